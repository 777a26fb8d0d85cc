// Analysing 100,000 swings of 24 readings (both fits, harmonics) against reading them from SQLite through Qt SQL.
// Limit: 2 times the reading. BENCH_SWINGS sets another number of swings.

#include <QCoreApplication>
#include <QTemporaryDir>

#include <cstdlib>

#include "core/swing/Analysis.h"
#include "core/swing/Observations.h"
#include "db/engine/Transaction.h"
#include "db/schema/Schema.h"
#include "tests/bench/BenchFleet.h"
#include "tests/bench/Ratio.h"

int main(int argc, char** argv)
{
    using namespace lubberline;
    QCoreApplication application(argc, argv);
    const char* wanted = std::getenv("BENCH_SWINGS");
    const int swings = wanted ? std::atoi(wanted) : 100'000;
    const QTemporaryDir folder;
    auto database = db::openDatabase(folder.filePath("bench.lubberline"), db::OpenMode::ReadWriteCreate);
    bench::fillFleet(*database, swings);

    std::vector<std::vector<Observation>> all;
    const auto readAll = [&] {
        all.clear();
        const auto done = db::SwingStore(*database).forEach([&](const Swing& swing) {
            all.push_back(observationsOf(swing));
            return true;
        });
        if (!done)
            std::abort();
    };
    double sum = 0; // used, so that nothing is optimised away
    const auto analyseAll = [&] {
        for (const auto& observations : all)
            sum += analyse(observations)->approximate.rms_rad;
    };
    readAll();
    const auto timing = bench::compare(analyseAll, readAll, 3);
    std::fprintf(
        stderr, "%d swings, mean rms %.3f deg, %.1f us a swing\n", swings, toDegrees(sum) / (4.0 * swings), timing.ours_s * 1e6 / swings);
    return bench::report("analyse all swings", timing, "reading them from SQLite", 2.0) ? 0 : 1;
}
