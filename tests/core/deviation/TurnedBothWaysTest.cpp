// One run each way round: lag shows as a constant, hysteresis and site once around, and neither is taken for deviation.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/angle/Angle.h"
#include "core/deviation/TurnedBothWays.h"

namespace lubberline {
namespace {

std::vector<Observation> runOf(double lag_deg, double once_deg, double noise_deg, unsigned seed, int step_deg = 15)
{
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    std::vector<Observation> run;
    for (int heading = 0; heading < 360; heading += step_deg) {
        const double angle = toRadians(heading);
        const double deviation
            = 1 + 3 * std::sin(angle) - 2 * std::cos(angle) + lag_deg + once_deg * std::sin(angle) + noise_deg * normal(random);
        run.push_back({MagneticHeading::fromDegrees(heading + deviation), CompassHeading::fromDegrees(heading)});
    }
    return run;
}

/// The other way round, in the order in which it is read.
std::vector<Observation> other(std::vector<Observation> run)
{
    std::reverse(run.begin(), run.end());
    return run;
}

TEST(TurnedBothWays, lagAndHysteresisAreToldApart)
{
    const auto lag = turnedBothWays(runOf(0.8, 0, 0.1, 1), other(runOf(-0.8, 0, 0.1, 2)), 1);
    ASSERT_TRUE(lag);
    EXPECT_NEAR(lag->difference_deg[0], 1.6, 0.15);
    EXPECT_NEAR(lag->difference_deg[1], 0, 0.2);
    EXPECT_FALSE(lag->passes);
    ASSERT_EQ(lag->findings.size(), 1u);
    EXPECT_NE(lag->findings[0].english().find("late"), std::string::npos);
    const auto trace = turnedBothWays(runOf(0, 0.6, 0.1, 3), other(runOf(0, -0.6, 0.1, 4)), 2);
    EXPECT_NEAR(trace->difference_deg[1], 1.2, 0.2);
    EXPECT_TRUE(trace->passes);
    ASSERT_EQ(trace->findings.size(), 1u);
    EXPECT_NE(trace->findings[0].english().find("once around"), std::string::npos);
}

TEST(TurnedBothWays, agreementAndErrors)
{
    const auto same = turnedBothWays(runOf(0, 0, 0.2, 5), other(runOf(0, 0, 0.2, 6)), 1);
    ASSERT_TRUE(same);
    EXPECT_TRUE(same->passes);
    EXPECT_EQ(same->findings[0].english(), "both runs tell the same");
    EXPECT_NEAR(same->residual_deg, 0.2, 0.06);
    EXPECT_FALSE(turnedBothWays(runOf(0, 0, 0, 1, 90), runOf(0, 0, 0, 1), 1));
    auto few = runOf(0, 0, 0, 1);
    for (auto& read : few)
        read.compass = CompassHeading::fromDegrees(90);
    EXPECT_FALSE(turnedBothWays(few, few, 1));
}

/// Six readings from 000 to 075 tell nothing of the other 285°, and two runs the same way round nothing of what goes with the way.
TEST(TurnedBothWays, whatWasNotComparedDoesNotPass)
{
    const auto whole = runOf(0, 0, 0.1, 7);
    const std::vector<Observation> sixth(whole.begin(), whole.begin() + 6);
    const auto part = turnedBothWays(sixth, other(whole), 1);
    ASSERT_TRUE(part);
    EXPECT_FALSE(part->passes);
    EXPECT_NE(part->findings[0].english().find("no reading from 075° to 000°: over these 285°"), std::string::npos);
    const auto alike = turnedBothWays(whole, runOf(0, 0, 0.1, 8), 1);
    ASSERT_TRUE(alike);
    EXPECT_TRUE(alike->within());
    EXPECT_FALSE(alike->passes);
    EXPECT_NE(alike->findings[0].english().find("go clockwise and those of the other clockwise"), std::string::npos);
    const auto changed = turnedBothWays(other(whole), whole, 1);
    ASSERT_TRUE(changed);
    EXPECT_FALSE(changed->passes);
    EXPECT_NE(changed->findings[0].english().find("expected the clockwise run first"), std::string::npos);
    // A run may begin anywhere, and a heading be read a little late.
    auto from = whole;
    std::rotate(from.begin(), from.begin() + 9, from.end());
    std::swap(from[3], from[4]);
    EXPECT_TRUE(turnedBothWays(from, other(whole), 1)->passes);
}

} // namespace
} // namespace lubberline
