// A fleet of 100,000 swings of 24 readings as a population: read as columns and computed (pattern, harmonics, coefficients, exceedance,
// jumps, ranking), against one forward-only SELECT of swing, magnetic and compass heading through Qt SQL; and the fit of one swing against
// its sines and cosines with one 5×5 solution. Limits: 2.5 times, 600 MB, 3 times. Critical values of the jump test are timed apart.
// BENCH_SWINGS sets another number of swings.

#include <QCoreApplication>
#include <QTemporaryDir>

#include <Eigen/Dense>

#include <cstdlib>
#include <fstream>
#include <string>

#include "core/fleet/FleetReport.h"
#include "core/fleet/JumpChances.h"
#include "db/engine/Statement.h"
#include "db/schema/Schema.h"
#include "db/stores/PopulationStore.h"
#include "tests/bench/BenchFleet.h"
#include "tests/bench/Ratio.h"

namespace {

using namespace lubberline;

/// The most memory that the process ever held [MB].
long peakMemory_MB()
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM:"))
            return std::atol(line.c_str() + 6) / 1024;
    return 0;
}

bool fitIsQuick()
{
    std::vector<double> magnetic, compass;
    for (int i = 0; i < 24; ++i) {
        compass.push_back(15.0 * i);
        magnetic.push_back(wrap360(15.0 * i + 2 * std::sin(0.26 * i) + 0.1 * (i % 3)));
    }
    constexpr int times = 20000;
    double sum = 0; // used, so that nothing is optimised away
    const auto fit = [&] {
        for (int i = 0; i < times; ++i) {
            magnetic[0] = 1e-6 * i;
            sum += fitCurve(magnetic, compass).value_deg[1];
        }
    };
    Eigen::Matrix<double, 5, 5> matrix = Eigen::Matrix<double, 5, 5>::Identity() * 12;
    const Eigen::Matrix<double, 5, 1> right = Eigen::Matrix<double, 5, 1>::Ones();
    const auto reference = [&] {
        for (int i = 0; i < times; ++i) {
            for (const double heading : compass)
                sum += std::sin(toRadians(heading + 1e-6 * i)) + std::cos(toRadians(heading + 1e-6 * i));
            matrix(0, 1) = matrix(1, 0) = 1e-3 * (i % 7);
            sum += matrix.ldlt().solve(right)[0];
        }
    };
    const auto timing = bench::compare(fit, reference, 7);
    return bench::report("20,000 fits of 24 readings, with covariance", timing, "24 sines and cosines, one 5x5 solution", 3.0) && sum != 0;
}

/// Critical values of the jump test, timed apart: tables by pattern of dates, made and asked again, against chances by the dates
/// themselves, each of one statistic.
bool criticalValuesAreQuick(const FleetSwings& fleet, const FleetCurves& curves, std::span<const CompassHistory> histories)
{
    constexpr std::size_t most = 400;
    std::vector<std::vector<DatedValue>> series;
    for (std::size_t h = 0; h < histories.size() && series.size() < most; ++h)
        for (std::size_t c = 0; c < kCoefficientCount; ++c)
            series.push_back(seriesOf(fleet, curves, histories[h], c, {}).values);
    double sum = 0;
    std::size_t patterns = 0;
    JumpChances kept;
    const auto ask = [&](JumpChances& chances) {
        for (const auto& each : series)
            sum += chances.of(jumpPatternOf(each, {}))->chanceBeyond(4.0);
        patterns = chances.patterns();
    };
    const auto byDates = [&] {
        for (const auto& each : series)
            sum += JumpDesign(each, {}).chanceBeyond(4.0, 64);
    };
    const auto make = [&] {
        JumpChances fresh;
        ask(fresh);
    };
    const auto made = bench::compare(make, byDates, 3), again = bench::compare([&] { ask(kept); }, byDates, 3);
    std::printf("%zu series of dates, %zu patterns\n", series.size(), patterns);
    const bool quick = bench::report("critical values, tables made", made, "one chance each by its dates", 2.0);
    return bench::report("critical values, asked again", again, "one chance each by its dates", 0.1) && quick && sum != 0;
}

} // namespace

int main(int argc, char** argv)
{
    QCoreApplication application(argc, argv);
    const char* wanted = std::getenv("BENCH_SWINGS");
    const int swings = wanted ? std::atoi(wanted) : 100'000;
    const QTemporaryDir folder;
    auto database = db::openDatabase(folder.filePath("bench.lubberline"), db::OpenMode::ReadWriteCreate);
    bench::fillFleet(*database, swings);
    if (!db::execute(*database, "UPDATE swing SET state = 1, stage = id % 2"))
        std::abort();
    const bool quick = fitIsQuick();

    double sum = 0;
    const auto select = [&] {
        db::Statement statement(*database, "SELECT swing_id, magnetic_heading_deg, compass_heading_deg FROM reading");
        if (!statement.run())
            std::abort();
        while (statement.next())
            sum += static_cast<double>(statement.integer(0)) + statement.real(1, {0, 360}) + statement.real(2, {0, 360});
    };
    FleetOptions options;
    options.limit_deg = 10;
    options.today_day = 20783;
    options.variance = false;
    double reading_s = 0, changes_s = 0;
    const auto whole = [&] {
        FleetSwings fleet;
        reading_s = bench::seconds([&] { fleet = std::move(db::PopulationStore(*database).columns({}).value()); });
        sum += fleetReportOf(fleet, options)->ranking.compasses.front().probability;
    };
    const auto timing = bench::compare(whole, select, 3);
    const FleetSwings fleet = std::move(db::PopulationStore(*database).columns({}).value());
    const auto curves = curvesOf(fleet);
    const auto histories = historiesOf(fleet);
    changes_s = bench::seconds([&] { sum += static_cast<double>(changesOf(fleet, *curves, histories)->tested); });
    std::printf("%d swings: columns read in %.0f ms; jumps and drifts with their critical values %.0f ms of the whole\n", swings,
        reading_s * 1e3, changes_s * 1e3);
    const bool kept = bench::report("the fleet as a population", timing, "one SELECT of its readings", 2.5);
    const bool soonCritical = criticalValuesAreQuick(fleet, *curves, histories);
    options.changes = false;
    const double look_s = bench::seconds([&] {
        const FleetSwings some = std::move(db::PopulationStore(*database).columns({}, {}, 1500).value());
        sum += *fleetReportOf(some, options)->pattern.points.front().mean_deg;
    });
    const bool soon = bench::row("the first look of the page", look_s * 1e3, 300, "300 ms", 1.0);
    const long memory = peakMemory_MB();
    const bool lean = bench::row("most memory held [MB]", static_cast<double>(memory), 600, "600 MB", 1.0);
    return quick && kept && soonCritical && soon && lean && sum != 0 ? 0 : 1;
}
