// Writes readings into the swing of a database until it is killed, and says on standard output what is stored.

#include <cstdio>
#include <cstdlib>

#include <QCoreApplication>

#include "tests/db/TestFleet.h"

int main(int argc, char** argv)
{
    using namespace lubberline;
    QCoreApplication application(argc, argv);
    auto database = db::Database::open(argv[1], db::OpenMode::ReadWriteCreate);
    if (!database)
        return 1;
    db::SwingRepository swings(*database);
    const SwingId swing{std::atoi(argv[2])};
    for (int i = 0; i < 100000; ++i) {
        const auto stored = swings.insertReading(swing, i, test::reading(i % 360, (i * 7) % 360));
        if (!stored)
            return 2;
        std::printf("%lld\n", static_cast<long long>(stored->value));
        std::fflush(stdout);
    }
    return 0;
}
