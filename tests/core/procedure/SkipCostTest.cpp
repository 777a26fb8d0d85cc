#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "core/procedure/SkipCost.h"

namespace lubberline {
namespace {

const std::vector<double> kEight{0, 45, 90, 135, 180, 225, 270, 315};

/// On n headings spread evenly XᵀX = diag(n, n/2, n/2, n/2, n/2), so the curve's variance is 1/n + 2·2/n = 5/n everywhere.
TEST(SkipCost, everyHeadingReadCostsNothing)
{
    const auto cost = skipCost(kEight, kEight);
    EXPECT_NEAR(cost.planned, std::sqrt(5.0 / 8), 1e-12);
    EXPECT_NEAR(cost.remaining, cost.planned, 1e-12);
    EXPECT_FALSE(cost.withoutSecondHarmonic);
}

/// Without one of eight: its leverage was h = 5/8, so that the variance there becomes h/(1 − h) = 5/3.
TEST(SkipCost, oneOfEightIsMissedMostWhereItWas)
{
    const std::vector<double> seven{0, 45, 135, 180, 225, 270, 315};
    const auto cost = skipCost(kEight, seven);
    EXPECT_NEAR(cost.remaining, std::sqrt(5.0 / 3), 1e-9);
    EXPECT_DOUBLE_EQ(cost.at_deg, 90.0);
}

TEST(SkipCost, fewHeadingsTellLess)
{
    const auto cardinals = skipCost(kEight, std::array{0.0, 90.0, 180.0, 270.0});
    EXPECT_TRUE(cardinals.withoutSecondHarmonic);
    EXPECT_NEAR(cardinals.remaining, std::sqrt(3.0 / 4), 1e-9); // 1/4 + 2/4 everywhere
    EXPECT_TRUE(std::isinf(skipCost(kEight, std::array{0.0, 90.0}).remaining));
    EXPECT_TRUE(std::isinf(skipCost(kEight, std::vector<double>{}).remaining));
}

} // namespace
} // namespace lubberline
