// Records of years: a table of 100,000 swings of 24 readings imported, against the bare inserts of the same rows (one prepared statement for
// swings, one for readings, one transaction). Limit: three times; and memory that does not grow with the table. BENCH_SWINGS sets another
// number of swings.

#include <QCoreApplication>
#include <QTemporaryDir>

#include <cstdlib>
#include <fstream>
#include <random>
#include <string>

#include "db/engine/Statement.h"
#include "db/engine/Transaction.h"
#include "db/saving/Saving.h"
#include "db/schema/Schema.h"
#include "db/stores/SwingRows.h"
#include "db/transfer/Years.h"
#include "tests/bench/BenchFleet.h"
#include "tests/bench/Ratio.h"

namespace {

using namespace lubberline;

long memory_MB(const char* key)
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(key))
            return std::atol(line.c_str() + std::string(key).size()) / 1024;
    return 0;
}

void writeTable(const std::string& path, int swings)
{
    std::ofstream file(path);
    std::mt19937 random(3);
    file << "type,aircraft,compass,date,stage,datum_reader";
    for (int i = 0; i < 24; ++i)
        file << ',' << 15 * i;
    file << '\n';
    for (int swing = 0; swing < swings; ++swing) {
        const int aircraft = swing / 10;
        file << "Type " << aircraft % 20 << ",B-" << aircraft << ",standby," << 2010 + swing % 10 << "-05-01,as_found,Crew " << swing % 7;
        const Swing one = bench::noisySwing({}, random, 24);
        for (const auto& reading : one.readings)
            file << ',' << std::round(deviationOf(*reading.magnetic, *reading.compass).degrees() * 10) / 10;
        file << '\n';
    }
}

db::Database fresh(const QTemporaryDir& folder, int& number)
{
    auto database = db::openDatabase(folder.filePath(QString::number(number++) + ".lubberline"), db::OpenMode::ReadWriteCreate);
    if (!database)
        std::abort();
    return std::move(database.value());
}

void bareInserts(db::Database& database, int swings)
{
    auto transaction = db::Transaction::begin(database);
    db::FleetStore fleet(database);
    Aircraft aircraft;
    aircraft.type = *fleet.add(AircraftType{{}, {}, "Type", "", ""});
    aircraft.registration = "B";
    CompassSystem compass;
    compass.aircraft = *fleet.add(aircraft);
    compass.name = "standby";
    const auto id = *fleet.add(compass);
    std::mt19937 random(3);
    const Swing one = bench::noisySwing(id, random, 24);
    db::Statement swing(database,
        "INSERT INTO swing (record, " + db::swingFields().join(", ") + ") VALUES (" + db::placeholders(db::swingFields().size() + 1) + ")");
    db::Statement reading(database,
        "INSERT INTO reading (swing_id, position, " + db::readingFields().join(", ") + ") VALUES ("
            + db::placeholders(db::readingFields().size() + 2) + ")");
    for (int i = 0; i < swings; ++i) {
        swing << std::to_string(i) + "-0000-4000-8000-000000000000";
        db::bindParticulars(swing, one);
        if (!swing.run())
            std::abort();
        const SwingId row{swing.insertedId()};
        int position = 0;
        for (const auto& each : one.readings) {
            reading << row << position++;
            db::bindReading(reading, each);
            if (!reading.run())
                std::abort();
        }
    }
    if (!transaction->commit())
        std::abort();
}

void import(db::Database& database, const std::string& path, int swings)
{
    std::ifstream input(path);
    YearsTable table;
    table.cells = YearsCells::Deviations;
    YearsReader reader(input, "years.csv", table);
    const auto outcome = db::importYears(database, reader, db::YearsStep::Store, "2026-11-27");
    if (!outcome || outcome->swings != swings)
        std::abort();
}

} // namespace

int main(int argc, char** argv)
{
    QCoreApplication application(argc, argv);
    const char* wanted = std::getenv("BENCH_SWINGS");
    const int swings = wanted ? std::atoi(wanted) : 100'000;
    const QTemporaryDir folder;
    int number = 0;
    const std::string path = folder.filePath("years.csv").toStdString(), small = folder.filePath("small.csv").toStdString();
    writeTable(path, swings);
    writeTable(small, swings / 10);
    {
        auto database = fresh(folder, number);
        import(database, small, swings / 10);
    }
    const long before = memory_MB("VmHWM:");
    const double import_s = bench::seconds([&] {
        auto database = fresh(folder, number);
        import(database, path, swings);
    });
    const long after = memory_MB("VmHWM:");
    const double bare_s = bench::seconds([&] {
        auto database = fresh(folder, number);
        bareInserts(database, swings);
    });
    const bool quick = bench::report("a table of years imported", {import_s, bare_s}, "bare inserts of the same rows", 3.0);
    const bool lean = bench::row("memory that ten times the table takes [MB]", static_cast<double>(after - before), 40, "40 MB", 1.0);
    return quick && lean ? 0 : 1;
}
