#include "core/calibration/Interference.h"

#include <gmock/gmock.h>

#include <random>

namespace lubberline::test {
namespace {

using testing::HasSubstr;

/// Ten samples a second for a minute; the light is on from 20 s, the pump from 40 s with a surge of one second.
SensorLog stillLog()
{
    std::mt19937_64 random(2);
    std::normal_distribution<double> normal;
    SensorLog log;
    log.currents = {{"light", {}}, {"pump", {}}};
    for (int i = 0; i < 600; ++i) {
        const double time = 0.1 * i, light = time >= 20 ? 10 : 0, pump = time >= 40 ? (time < 41 ? 30 : 10) : 0;
        log.time_s.push_back(time);
        log.field[0].push_back(18000 + 12 * light + 3 * normal(random));
        log.field[1].push_back(-500 + 60 * pump + 3 * normal(random));
        log.field[2].push_back(44000 - 4 * light + 3 * normal(random));
        log.currents[0].values.push_back(light);
        log.currents[1].values.push_back(pump);
    }
    return log;
}

TEST(Interference, worstChangePerAxisWithItsTime)
{
    const auto result = interferenceTest(stillLog(), {{20, "light on"}, {40, "pump on"}});
    ASSERT_TRUE(result) << describe(result.error());
    ASSERT_EQ(result->actions.size(), 2u);
    const auto& light = result->actions[0];
    EXPECT_TRUE(light.passes);
    EXPECT_NEAR(light.change_nT.x(), 120, 2);
    EXPECT_NEAR(light.change_nT.z(), -40, 2);
    const auto& pump = result->actions[1];
    EXPECT_FALSE(pump.passes) << "the surge of 1800 nT is beyond 500 nT";
    EXPECT_NEAR(pump.worst_nT.y(), 1800, 15);
    EXPECT_GE(pump.worstAt_s.y(), 40);
    EXPECT_LT(pump.worstAt_s.y(), 41);
    EXPECT_NEAR(pump.change_nT.y(), 600, 3) << "in the end";
    EXPECT_FALSE(result->passes);
    EXPECT_NEAR(result->noise_nT.y(), 3, 0.8);
}

/// One sample of 9000 nT, ten seconds after the action, is a fault of the log and is named; it made the light fail.
TEST(Interference, aSpikeIsNoChange)
{
    SensorLog log = stillLog();
    log.field[0][300] += 9000;
    const auto result = interferenceTest(log, {{20, "light on"}});
    ASSERT_TRUE(result) << describe(result.error());
    EXPECT_LT(result->actions[0].worst_nT.x(), 140);
    EXPECT_THAT(together(result->warnings).english(), HasSubstr("1 spike left out, the largest of +9"));
    EXPECT_THAT(together(result->warnings).english(), HasSubstr("along x at 30.00 s"));
    EXPECT_TRUE(interferenceTest(stillLog(), {{20, "light on"}})->warnings.empty());
}

TEST(Interference, fieldPerAmpereOfEachCircuit)
{
    const auto result = interferenceTest(stillLog(), {{20, "light on"}, {40, "pump on"}});
    ASSERT_EQ(result->circuits.size(), 2u);
    EXPECT_NEAR(result->circuits[0].field_nT_per_A.x(), 12, 0.1);
    EXPECT_NEAR(result->circuits[0].field_nT_per_A.z(), -4, 0.1);
    EXPECT_NEAR(result->circuits[1].field_nT_per_A.y(), 60, 0.1);
    EXPECT_EQ(result->circuits[1].current_A, 30);
}

TEST(Interference, limitsAreTheCallers)
{
    EXPECT_TRUE(interferenceTest(stillLog(), {{20, "light on"}}, {2000, 2000, 2000})->passes);
    EXPECT_THAT(together(interferenceTest(stillLog(), {{20, "light on"}}, {10, 500, 800})->warnings).english(),
        HasSubstr("may fail by noise alone"));
}

TEST(Interference, whatIsRefused)
{
    EXPECT_THAT(describe(interferenceTest(stillLog(), {{90, "late"}}).error()), HasSubstr("actions inside the log"));
    EXPECT_THAT(describe(interferenceTest(stillLog(), {{20, "a"}, {20.05, "b"}}).error()), HasSubstr("time between them"));
    SensorLog log = stillLog();
    log.unit = FieldUnit::Counts;
    EXPECT_THAT(describe(interferenceTest(log, {{20, "a"}}).error()), HasSubstr("is in counts"));
}

} // namespace
} // namespace lubberline::test
