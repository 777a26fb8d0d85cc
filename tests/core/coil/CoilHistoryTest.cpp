// Coil benches that are kept: the same result from the record, and the drift between two.
#include "core/coil/CoilHistory.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

namespace lubberline::test {
namespace {

using testing::HasSubstr;

SensorLog benchLog(double scale, double bias_nT, double noise_nT, unsigned seed)
{
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    SensorLog log;
    for (const char* name : {"ax_nT", "AY_NT", "az_nT", "temperature_c"})
        log.others.push_back({name, {}});
    for (int round = 0; round < 5; ++round)
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (int step = 0; step < 40; ++step) {
                const double at = 3250.0 * (step < 20 ? -20 + 2 * step : 20 - 2 * (step - 20));
                for (std::size_t k = 0; k < 3; ++k) {
                    const double applied = k == axis ? at : 0.0;
                    log.others[k].values.push_back(applied);
                    log.field[k].push_back(scale * applied + bias_nT + noise_nT * normal(random));
                }
                log.others[3].values.push_back(20);
            }
    return log;
}

CoilBench keptOn(Date date, double scale, double bias_nT, double noise_nT, unsigned seed)
{
    CoilBench bench = *coilRecordOf(benchLog(scale, bias_nT, noise_nT, seed));
    bench.date = date;
    bench.serialNumber = "S 12";
    return bench;
}

TEST(CoilHistory, aRecordTellsTheSameAsItsLog)
{
    SensorLog log = benchLog(1.01, 50, 10, 3);
    log.field[1][7] = kNoValue;
    log.others[3].values[11] = kNoValue;
    const auto bench = coilRecordOf(log);
    ASSERT_TRUE(bench) << describe(bench.error());
    EXPECT_EQ(bench->readings.size(), log.size() - 2);
    const auto now = coilBench(log), again = coilBench(logOf(*bench));
    ASSERT_TRUE(now && again);
    EXPECT_EQ(again->used, now->used);
    EXPECT_EQ(again->gain, now->gain);
    EXPECT_EQ(again->bias_nT, now->bias_nT);
    EXPECT_EQ(again->noise_nT, now->noise_nT);
    EXPECT_EQ(again->hysteresis_nT, now->hysteresis_nT);
    EXPECT_EQ(now->range_nT, 65000);
}

TEST(CoilHistory, aLogTooLongToKeepIsRefused)
{
    SensorLog log = benchLog(1, 0, 5, 3), whole = log;
    while (whole.size() <= kMostCoilReadings)
        for (std::size_t k = 0; k < 4; ++k) {
            if (k < 3)
                whole.field[k].insert(whole.field[k].end(), log.field[k].begin(), log.field[k].end());
            whole.others[k].values.insert(whole.others[k].values.end(), log.others[k].values.begin(), log.others[k].values.end());
        }
    EXPECT_THAT(describe(coilRecordOf(whole).error()), HasSubstr("has 10200 whole rows; a bench that is kept has at most 10000"));
}

/// Over 300 pairs the 95 % intervals hold the drift in 92 to 98 %.
TEST(CoilHistory, driftAYearWithIntervalsThatHold)
{
    int held = 0, asked = 0;
    for (unsigned pair = 0; pair < 300; ++pair) {
        const auto drift
            = driftBetween(keptOn("2024-05-01", 1.0, 100, 20, 2 * pair + 1), keptOn("2026-05-01", 1.0004, 130, 20, 2 * pair + 2));
        ASSERT_TRUE(drift) << describe(drift.error());
        EXPECT_NEAR(drift->years, 2, 0.002);
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            held += std::abs(drift->bias_nT_per_year[axis] - 30 / drift->years) <= drift->biasInterval_nT_per_year[axis];
            held += std::abs(drift->scale_per_year[axis] - 0.0004 / drift->years) <= drift->scaleInterval_per_year[axis];
            asked += 2;
        }
    }
    EXPECT_GT(held, 0.92 * asked);
    EXPECT_LT(held, 0.98 * asked);
}

TEST(CoilHistory, whatCannotBeComparedIsSaid)
{
    const CoilBench earlier = keptOn("2025-05-01", 1, 0, 5, 1);
    CoilBench later = keptOn("2026-05-01", 1, 0, 10, 2);
    EXPECT_NEAR(driftBetween(earlier, later)->noiseRatio.x(), 2, 0.3);
    EXPECT_TRUE(driftBetween(earlier, later)->doubts.empty());
    for (double& one : later.temperature_c)
        one = 35;
    EXPECT_THAT(inEnglish(driftBetween(earlier, later)->doubts).front(), HasSubstr("20 °C before and 35 °C now"));
    later.serialNumber.clear();
    EXPECT_THAT(inEnglish(driftBetween(earlier, later)->doubts).front(), HasSubstr("whether it is the same sensor is not known"));
    later.serialNumber = "S 13";
    EXPECT_THAT(describe(driftBetween(earlier, later).error()), HasSubstr("of two sensors (serial numbers S 12 and S 13)"));
    later = keptOn("2025-05-20", 1, 0, 5, 2);
    EXPECT_THAT(describe(driftBetween(earlier, later).error()), HasSubstr("are 19 days apart"));
    later = keptOn("2026-05-01", 1, 0, 5, 2);
    later.inCounts = true;
    EXPECT_THAT(describe(driftBetween(earlier, later).error()), HasSubstr("one in counts and one in nT"));
}

/// A sensor of 30 nT at 20 °C and 2 nT/°C that did not drift, on a bench in winter (20 °C) and in summer (40 °C).
TEST(CoilHistory, biasesAreComparedAtOneTemperature)
{
    const auto benchAt = [](Date date, double mean_c, unsigned seed) {
        SensorLog log = benchLog(1, 30, 5, seed);
        for (std::size_t row = 0; row < log.size(); ++row) {
            const double temperature = mean_c + 6.0 * (static_cast<double>(row) / static_cast<double>(log.size() - 1) - 0.5);
            log.others[3].values[row] = temperature;
            for (auto& axis : log.field)
                axis[row] += 2 * (temperature - 20);
        }
        CoilBench bench = *coilRecordOf(log);
        bench.date = date;
        bench.serialNumber = "S 12";
        return bench;
    };
    const CoilBench winter = benchAt("2024-05-01", 20, 1), summer = benchAt("2026-05-01", 40, 2);
    const auto first = coilBench(logOf(winter)), second = coilBench(logOf(summer));
    ASSERT_TRUE(first && second);
    EXPECT_NEAR(*first->biasAt_c, 20, 1e-9);
    EXPECT_NEAR(*second->biasAt_c, 40, 1e-9);
    EXPECT_NEAR(first->bias_nT.x(), 30, 2);
    EXPECT_NEAR(second->bias_nT.x(), 70, 2);
    const auto drift = driftBetween(winter, summer);
    ASSERT_TRUE(drift && drift->at_c) << describe(drift.error());
    EXPECT_NEAR(*drift->at_c, 30, 1e-9);
    EXPECT_TRUE(drift->doubts.empty());
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        EXPECT_LT(std::abs(drift->bias_nT_per_year[axis]), 1.5 * drift->biasInterval_nT_per_year[axis]) << "the temperature's 20 nT a year";
        EXPECT_LT(drift->biasInterval_nT_per_year[axis], 5);
    }
    // Where one bench alone told what a degree does, that is taken for both; where none did, the difference is doubted (above).
    CoilBench even = summer;
    for (std::size_t i = 0; i < even.readings.size(); ++i) {
        for (std::size_t axis = 3; axis < 6; ++axis)
            even.readings[i][axis] -= 2 * (even.temperature_c[i] - 40);
        even.temperature_c[i] = 40;
    }
    const auto byOne = driftBetween(winter, even);
    ASSERT_TRUE(byOne && byOne->at_c);
    EXPECT_LT(std::abs(byOne->bias_nT_per_year.x()), 1.5 * byOne->biasInterval_nT_per_year.x());
    EXPECT_FALSE(driftBetween(even,
        [&] {
            CoilBench later = even;
            later.date = "2027-05-01";
            return later;
        }())
                     ->at_c);
}

} // namespace
} // namespace lubberline::test
