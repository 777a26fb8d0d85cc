// Wind reports: reading and summing 1,000,000 against getline and from_chars on the same columns; limit 2 times. Kalman updates against their
// own stated times: 0.5 us with 5 states, 5 us with 15. BENCH_REPORTS sets another number of reports.

#include <array>
#include <charconv>
#include <cstdlib>
#include <random>
#include <sstream>
#include <string>

#include "core/format/csv/WindCsv.h"
#include "core/inflight/StateFilter.h"
#include "core/inflight/WindVector.h"
#include "tests/bench/Ratio.h"

namespace {

using namespace lubberline;

std::string reportsOf(int count)
{
    std::mt19937_64 engine(1);
    std::normal_distribution<double> normal;
    std::string csv
        = "aircraft,flight,time_utc,latitude_deg,longitude_deg,ground_speed_kt,track_deg,tas_kt,wind_speed_kt,wind_from_deg,ref_wind_speed_kt,ref_wind_from_deg\n";
    std::array<char, 256> line;
    for (int i = 0; i < count; ++i) {
        const int flight = i / 100 % 100, aircraft = i / 10000;
        const double heading_deg = 3.6 * (i % 100);
        const Eigen::Vector2d wind(20, 10), ground = velocityOf(heading_deg, 430) + wind;
        const Eigen::Vector2d reported = ground - velocityOf(heading_deg + 1 + 0.2 * normal(engine), 430),
                              held = wind + Eigen::Vector2d{normal(engine), normal(engine)};
        const int length = std::snprintf(line.data(), line.size(),
            "A%03d,F%03d,2026-03-%02dT%02d:%02d:%02dZ,%.3f,%.3f,%.1f,%.1f,%.1f,%.1f,%.1f,%.1f,%.1f\n", aircraft, flight, 1 + flight % 28,
            8 + i % 100 / 60, i % 60, 0, 50 + 0.02 * (i % 100), 10 + 0.05 * (i % 100), ground.norm(), directionOf_deg(ground), 430.0,
            reported.norm(), directionOf_deg(-reported), held.norm(), directionOf_deg(-held));
        csv.append(line.data(), static_cast<std::size_t>(length));
    }
    return csv;
}

/// Every column that is a figure, as a plain program would read it.
double plainSum(const std::string& csv)
{
    std::istringstream input(csv);
    std::string line;
    double sum = 0;
    std::getline(input, line);
    while (std::getline(input, line)) {
        const char* at = line.data();
        const char* const end = at + line.size();
        for (int column = 0; at <= end; ++column) {
            double value = 0;
            const char* cellEnd = at;
            while (cellEnd < end && *cellEnd != ',')
                ++cellEnd;
            if (column > 2) {
                std::from_chars(at, cellEnd, value);
                sum += value;
            }
            at = cellEnd + 1;
        }
    }
    return sum;
}

double updateTime_us(int states)
{
    std::mt19937_64 engine(2);
    std::normal_distribution<double> normal;
    std::vector<StateFilter::State> rows;
    for (int i = 0; i < 1000; ++i) {
        StateFilter::State row(states);
        for (int j = 0; j < states; ++j)
            row(j) = normal(engine);
        rows.push_back(row);
    }
    StateFilter filter(states);
    constexpr int kRounds = 200;
    const double seconds = bench::seconds([&] {
        for (int round = 0; round < kRounds; ++round)
            for (const auto& row : rows)
                filter.update(row, row.sum(), 0.25);
    });
    return seconds * 1e6 / (kRounds * 1000.0);
}

} // namespace

int main()
{
    const char* wanted = std::getenv("BENCH_REPORTS");
    const int count = wanted ? std::atoi(wanted) : 1'000'000;
    const std::string csv = reportsOf(count);
    double sum = 0;
    const auto timing = bench::compare(
        [&] {
            std::istringstream input(csv);
            sum += static_cast<double>(readWindCsv(input, "bench", {})->result.used);
        },
        [&] { sum += plainSum(csv); }, 3);
    std::printf("%d reports, %.0f ns each (sum %.0f)\n", count, timing.ours_s * 1e9 / count, sum);
    bool kept = bench::report("wind reports, read and summed", timing, "getline and from_chars", 2.0);
    kept &= bench::row("Kalman update, 5 states [us]", updateTime_us(5), 0.5, "0.5 us", 1.0);
    kept &= bench::row("Kalman update, 15 states [us]", updateTime_us(15), 5.0, "5 us", 1.0);
    return kept ? 0 : 1;
}
