// The quick sines and arctangents are the library's.

#include <gtest/gtest.h>

#include <cmath>

#include "core/angle/QuickAngle.h"

using namespace lubberline;

namespace {

TEST(QuickAngle, sinesAndCosinesAreTheLibrarys)
{
    for (int i = -8000; i <= 8000; ++i) {
        const double angle_deg = 0.1 * i + 1e-3 * (i % 7), angle_rad = toRadians(angle_deg);
        const SineCosine ofDegrees = quickSineCosineOfDegrees(angle_deg), ofRadians = quickSineCosine(angle_rad / 10);
        EXPECT_NEAR(ofDegrees.sine, std::sin(angle_rad), 4e-15) << angle_deg;
        EXPECT_NEAR(ofDegrees.cosine, std::cos(angle_rad), 4e-15) << angle_deg;
        EXPECT_NEAR(ofRadians.sine, std::sin(angle_rad / 10), 5e-16) << angle_deg;
        EXPECT_NEAR(ofRadians.cosine, std::cos(angle_rad / 10), 5e-16) << angle_deg;
    }
    EXPECT_EQ(quickSineCosineOfDegrees(90).sine, 1);
    EXPECT_EQ(quickSineCosineOfDegrees(90).cosine, 0);
    EXPECT_EQ(quickSineCosineOfDegrees(-180).cosine, -1);
    EXPECT_NEAR(quickSineCosineOfDegrees(1e6).sine, std::sin(toRadians(1e6)), 1e-15);
    EXPECT_TRUE(std::isnan(quickSineCosineOfDegrees(std::nan("")).sine));
}

TEST(QuickAngle, arctangentsAreTheLibrarys)
{
    for (int i = -1800; i <= 1800; ++i) {
        const double angle_rad = toRadians(0.1 * i), y = 3 * std::sin(angle_rad), x = 3 * std::cos(angle_rad);
        EXPECT_NEAR(quickArctangent(y, x), std::atan2(y, x), 4e-16 * (1 + std::abs(angle_rad))) << i;
        EXPECT_NEAR(std::abs(wrap180(directionNearly_deg(y, x) - 0.1 * i)), 0, 2e-6) << i;
    }
    // Without a branch, in all octants and on the borders between them.
    for (int i = -7200; i <= 7200; ++i) {
        const double angle_rad = toRadians(0.025 * i + 1e-9 * (i % 5)), y = 0.7 * std::sin(angle_rad), x = 0.7 * std::cos(angle_rad);
        EXPECT_NEAR(arctangentAround(y, x), std::atan2(y, x), 1e-15) << i;
    }
    EXPECT_EQ(arctangentAround(0, 2), 0);
    EXPECT_EQ(arctangentAround(0, -2), kPi);
    EXPECT_EQ(arctangentAround(-0.0, -2), -kPi);
    EXPECT_EQ(arctangentAround(2, 0), kPi / 2);
    EXPECT_EQ(arctangentAround(-2, 0), -kPi / 2);
    EXPECT_EQ(quickWrap180(-180), 180);
    EXPECT_EQ(quickWrap180(540), 180);
    EXPECT_EQ(quickWrap180(-12.5), -12.5);
    EXPECT_EQ(quickArctangent(0, 0), 0);
    EXPECT_EQ(directionNearly_deg(0, 0), 0);
    EXPECT_LT(directionNearly_deg(-1e-18, 1), 360);
}

} // namespace
