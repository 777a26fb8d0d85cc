// The loops of core/reference/LevellingLoop.h: responses that were computed apart (exact to their digits; first order at 60 s is
// 0.1 rad (1 − 1/e)), gains, standoffs, and where third order is unstable.

#include <gtest/gtest.h>

#include <cmath>

#include "core/angle/Angle.h"
#include "core/reference/LevellingLoop.h"
#include "core/reference/ReferenceRun.h"

namespace lubberline {
namespace {

VerticalGyro loopOf(LoopKind kind, double tau1, double tau2, double tau3)
{
    VerticalGyro loop;
    loop.loop = kind;
    loop.tau1_s = tau1;
    loop.tau2_s = tau2;
    loop.tau3_s = tau3;
    return loop;
}

struct Published {
    VerticalGyro loop;
    double at30, at60, at90, at120, at300, largest, largestAt;
    double under60, under300, under900, under1800;
};

const std::vector<Published>& published()
{
    static const std::vector<Published> rows{
        {loopOf(LoopKind::First, 60, 15, 600), 2.2544, 3.6218, 2.1967, 1.3324, 0.0663, 3.6218, 60, -0.10535, -0.16554, -0.16667, -0.16667},
        {loopOf(LoopKind::Damped, 60, 15, 600), 1.5140, 3.4033, 3.0746, 1.8015, 0.0144, 3.6226, 69.4, -0.12155, -0.16662, -0.16667,
            -0.16667},
        {loopOf(LoopKind::Integral, 60, 15, 600), 2.3060, 3.7719, 2.3934, 1.5103, 0.0544, 3.7719, 60, -0.10363, -0.11993, -0.03968,
            -0.00732},
        {loopOf(LoopKind::Third, 60, 10, 600), 1.8092, 3.6881, 3.0163, 1.7797, 0.0103, 3.8265, 66.2, -0.11487, -0.11848, -0.03877,
            -0.00718}};
    return rows;
}

TEST(LevellingLoop, aTenthOfAGForAMinute)
{
    for (const Published& row : published()) {
        const LinearLoop loop(row.loop, 0.1);
        LoopState state;
        double largest = 0, largestAt = 0;
        for (int i = 1; i <= 3000; ++i) {
            state = loop.next(state, i <= 600 ? 0.1 : 0, 0);
            const double tilt = toDegrees(state.tilt_rad);
            if (tilt > largest) {
                largest = tilt;
                largestAt = i / 10.0;
            }
            for (const auto& [step, wanted] :
                {std::pair{300, row.at30}, {600, row.at60}, {900, row.at90}, {1200, row.at120}, {3000, row.at300}}) {
                if (i == step) {
                    EXPECT_NEAR(tilt, wanted, 6e-5);
                }
            }
        }
        EXPECT_NEAR(largest, row.largest, 6e-5);
        EXPECT_NEAR(largestAt, row.largestAt, 0.06);
    }
}

TEST(LevellingLoop, tenDegreesAnHour)
{
    for (const Published& row : published()) {
        const LinearLoop loop(row.loop, 1);
        LoopState state;
        for (int i = 1; i <= 1800; ++i) {
            state = loop.next(state, 0, -toRadians(10) / 3600);
            for (const auto& [at, tilt] : {std::pair{60, row.under60}, {300, row.under300}, {900, row.under900}, {1800, row.under1800}}) {
                if (i == at) {
                    EXPECT_NEAR(toDegrees(state.tilt_rad), tilt, 6e-6);
                }
            }
        }
    }
    EXPECT_NEAR(toDegrees(standoff_rad(published()[0].loop, -toRadians(10) / 3600)), -0.16667, 6e-6);
    EXPECT_EQ(standoff_rad(published()[3].loop, 1), 0);
}

TEST(LevellingLoop, gains)
{
    const double frequency = 2 * kPi / 15;
    EXPECT_NEAR(gainAt(published()[0].loop, frequency), 0.039757, 6e-7);
    EXPECT_NEAR(gainAt(loopOf(LoopKind::Damped, 40, 10, 0), frequency), 0.014048, 6e-7);
    EXPECT_NEAR(gainAt(published()[1].loop, frequency), 0.0062927, 6e-8);
    EXPECT_NEAR(gainAt(published()[2].loop, frequency), 0.039764, 6e-7);
    EXPECT_NEAR(gainAt(published()[3].loop, frequency), 0.0093231, 6e-8);
    for (const auto& [ratio, most] : {std::pair{1.0, 1.468}, {4.0, 1.155}, {10.0, 1.071}, {20.0, 1.039}})
        EXPECT_NEAR(characterOf(loopOf(LoopKind::Integral, 60, 0, 60 * ratio)).largestGain, most, 6e-4);
}

TEST(LevellingLoop, thirdOrderNeedsTau3AboveTau2)
{
    EXPECT_TRUE(characterOf(loopOf(LoopKind::Third, 60, 10, 10.1)).stable);
    EXPECT_GT(characterOf(loopOf(LoopKind::Third, 60, 10, 10.1)).damping, 0);
    EXPECT_FALSE(characterOf(loopOf(LoopKind::Third, 60, 10, 9.9)).stable);
    EXPECT_LT(characterOf(loopOf(LoopKind::Third, 60, 10, 9.9)).damping, 0);
    Scenario scenario;
    scenario.duration_s = 7200;
    scenario.step_s = 0.5;
    scenario.manoeuvres = {{0, 60, 0, 1, 0}};
    scenario.vertical = loopOf(LoopKind::Third, 60, 60, 6);
    const auto run = runScenario(scenario);
    ASSERT_TRUE(run);
    ASSERT_EQ(run->warnings.size(), 2u);
    EXPECT_NE(run->warnings[0].english().find("tau3 > tau2"), std::string::npos);
    EXPECT_NE(run->warnings[1].english().find("tumbles"), std::string::npos);
    for (const AxisTilt& tilt : run->tilt)
        ASSERT_LE(std::hypot(tilt.forward_rad, tilt.starboard_rad), kPi / 2 + 1e-9);
}

/// The scenario's own way through turns, short steps and axes gives the loops' responses, too.
TEST(LevellingLoop, theSameInAScenario)
{
    for (const Published& row : published())
        for (const bool shortly : {false, true}) {
            Scenario scenario;
            scenario.duration_s = 300;
            scenario.step_s = 0.1;
            scenario.manoeuvres = {{0, 60, 0, 0.1 * kGravity_m_s2, 0}};
            scenario.vertical = row.loop;
            scenario.vertical->rateCompensation = true;
            if (shortly)
                scenario.vertical->rateLimit_deg_min = 1e6; // never reached
            const auto run = runScenario(scenario);
            ASSERT_TRUE(run);
            EXPECT_NEAR(toDegrees(run->tilt[600].forward_rad), row.at60, shortly ? 2e-3 : 6e-5);
            EXPECT_NEAR(toDegrees(run->tilt[1200].forward_rad), row.at120, shortly ? 2e-3 : 6e-5);
            EXPECT_NEAR(run->tilt[1200].starboard_rad, 0, 1e-12);
        }
}

} // namespace
} // namespace lubberline
