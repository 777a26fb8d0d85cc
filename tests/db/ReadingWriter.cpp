// Writes into a database until it is killed, and says on standard output what is stored.
//   reading_writer FILE SWING    readings, one a transaction; says their ids
//   reading_writer FILE import   fleets of kSwingsAtOnce swings, one fleet a transaction; says how many swings there are
//   reading_writer FILE sign     copies of the first swing, each completed and signed by two; says their ids
//   reading_writer FILE open     brings the database up to date; says 1

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <QCoreApplication>

#include "db/schema/Schema.h"
#include "db/stores/SigningStore.h"
#include "db/transfer/Transfer.h"
#include "tests/db/TestFleet.h"

namespace {

using namespace lubberline;

void say(std::int64_t number)
{
    std::printf("%lld\n", static_cast<long long>(number));
    std::fflush(stdout);
}

int writeReadings(db::Database& database, SwingId swing)
{
    db::SwingStore swings(database);
    for (int i = 0;; ++i) {
        const auto stored = swings.insertReading(swing, i, test::reading(i % 360, (i * 7) % 360));
        if (!stored)
            return 2;
        say(stored->value);
    }
}

int signSwings(db::Database& database)
{
    db::SwingStore swings(database);
    db::SigningStore signing(database);
    const auto first = swings.swing(SwingId{1});
    if (!first)
        return 2;
    for (;;) {
        Swing copy = *first;
        copy.id = {};
        copy.record = newRecordId();
        copy.state = SwingState::Draft;
        const auto id = swings.add(copy);
        if (!id || !signing.complete(*id) || !signing.sign(*id, {SignatureRole::Performer, "Ada", "", "", ""})
            || !signing.sign(*id, {SignatureRole::Inspector, "Ben", "", "", ""}))
            return 2;
        say(id->value);
    }
}

int importFleets(db::Database& database)
{
    auto fleet = db::exportFleet(database, {}, {});
    if (!fleet || fleet->swings.empty())
        return 2;
    fleet->swings = std::vector<Swing>(test::kSwingsAtOnce, fleet->swings.front());
    for (;;) {
        for (auto& swing : fleet->swings)
            swing.record = newRecordId();
        if (!db::importFleet(database, *fleet, {}))
            return 2;
        say(db::FleetStore(database).totals()->swings);
    }
}

} // namespace

int main(int argc, char** argv)
{
    QCoreApplication application(argc, argv);
    auto database = db::openDatabase(argv[1], db::OpenMode::ReadWriteCreate);
    if (!database)
        return 1;
    if (std::strcmp(argv[2], "sign") == 0)
        return signSwings(*database);
    if (std::strcmp(argv[2], "open") == 0) {
        say(1);
        return 0;
    }
    return std::strcmp(argv[2], "import") == 0 ? importFleets(*database) : writeReadings(*database, SwingId{std::atoi(argv[2])});
}
