#include <gtest/gtest.h>

#include <cmath>

#include "core/fleet/FleetRandom.h"
#include "core/fleet/FleetSwings.h"
#include "core/fleet/JumpTest.h"

using namespace lubberline;

namespace {

std::vector<DatedValue> yearly(int n)
{
    std::vector<DatedValue> series;
    for (int i = 0; i < n; ++i)
        series.push_back({365 * i, 0, 1});
    return series;
}

} // namespace

struct Critical {
    int n;
    double five, one; ///< at 5 % and 1 %
};

/// Values of one jump in a short series, by 200 000 simulations (±0.02), made for this project with another program.
TEST(JumpTest, criticalValuesOfKnownErrors)
{
    for (const auto& [n, five, one] :
        {Critical{5, 2.44, 2.99}, {6, 2.50, 3.05}, {8, 2.59, 3.12}, {10, 2.65, 3.19}, {15, 2.75, 3.28}, {20, 2.81, 3.33}}) {
        const JumpDesign design(yearly(n), {.trend = false, .at = {}});
        EXPECT_NEAR(design.criticalValue(0.05, 1000), five, 0.025) << n;
        EXPECT_NEAR(design.criticalValue(0.01, 1000), one, 0.025) << n;
    }
    for (const auto& [n, five, one] :
        {Critical{5, 2.45, 3.00}, {6, 2.53, 3.07}, {8, 2.64, 3.17}, {10, 2.72, 3.24}, {15, 2.84, 3.35}, {20, 2.92, 3.41}}) {
        const JumpDesign design(yearly(n), {.trend = true, .at = {}});
        EXPECT_NEAR(design.criticalValue(0.05, 1000), five, 0.03) << n;
        EXPECT_NEAR(design.criticalValue(0.01, 1000), one, 0.03) << n;
    }
}

TEST(JumpTest, criticalValuesOfUnknownErrors)
{
    const auto close = [](double found, double known, double share) { EXPECT_NEAR(found, known, share * known); };
    for (const auto& [n, five, one] : {Critical{6, 3.93, 6.22}, {8, 3.63, 5.21}, {10, 3.47, 4.72}, {15, 3.27, 4.19}, {20, 3.19, 3.99}}) {
        const JumpDesign design(yearly(n), {ErrorScale::Unknown, false, 2, {}});
        close(design.criticalValue(0.05, 40000), five, 0.02);
        close(design.criticalValue(0.01, 40000), one, 0.05);
    }
    for (const auto& [n, five, one] : {Critical{8, 4.04, 5.91}, {10, 3.75, 5.07}, {15, 3.50, 4.40}, {20, 3.41, 4.20}}) {
        const JumpDesign design(yearly(n), {ErrorScale::Unknown, true, 2, {}});
        close(design.criticalValue(0.05, 40000), five, 0.02);
        close(design.criticalValue(0.01, 40000), one, 0.05);
    }
}

TEST(JumpTest, chanceIsUniformWithoutAJumpAndToldInTheFarTail)
{
    FleetRandom random(5);
    int below[3] = {0, 0, 0};
    constexpr int series = 1500;
    for (int i = 0; i < series; ++i) {
        auto values = yearly(9);
        for (auto& value : values)
            value.value = 0.3 * value.day / 365 + random.normal(); // with a drift, which is in the null
        const double p = largestJump(values, {})->p;
        below[0] += p < 0.05;
        below[1] += p < 0.2;
        below[2] += p < 0.5;
    }
    EXPECT_NEAR(below[0], 0.05 * series, 3 * std::sqrt(0.05 * series));
    EXPECT_NEAR(below[1], 0.20 * series, 3 * std::sqrt(0.16 * series));
    EXPECT_NEAR(below[2], 0.50 * series, 3 * std::sqrt(0.25 * series));
    // Far out the places exclude one another: the chance is the sum of theirs.
    const JumpDesign design(yearly(9), {});
    EXPECT_NEAR(design.chanceBeyond(8, 200) / (static_cast<double>(design.places().size()) * 2 * normalTail(8)), 1.0, 0.02);
}

TEST(JumpTest, findsAJumpBetweenItsSwingsAndDriftIsNone)
{
    auto series = yearly(10);
    for (std::size_t i = 0; i < series.size(); ++i)
        series[i].value = (i >= 6 ? 6.0 : 0.0) + 0.2 * static_cast<double>(i);
    const auto jump = largestJump(series, {});
    ASSERT_TRUE(jump);
    EXPECT_EQ(jump->after, 5u);
    EXPECT_EQ(jump->before, 6u);
    EXPECT_NEAR(jump->change, 6.0, 1e-9);
    EXPECT_LT(jump->p, 1e-3);
    for (std::size_t i = 0; i < series.size(); ++i)
        series[i].value = 2.0 * static_cast<double>(i);
    EXPECT_GT(largestJump(series, {})->p, 0.9);
    const auto drift = driftOf(series, {});
    EXPECT_NEAR(drift->perYear, 2.0 * 365.25 / 365, 1e-9);
    EXPECT_LT(drift->p, 1e-6);
}

TEST(JumpTest, whatACorrectionDidIsNoJump)
{
    auto series = yearly(10);
    for (std::size_t i = 5; i < series.size(); ++i)
        series[i].value = 20;
    series[5].corrected = true;
    EXPECT_GT(largestJump(series, {})->p, 0.9);
    series[8].value = series[9].value = 30; // and a jump after it is still found
    const auto jump = largestJump(series, {});
    EXPECT_EQ(jump->before, 8u);
    EXPECT_LT(jump->p, 1e-3);
}

TEST(JumpTest, oneDayHoldsNoJumpAndShortSeriesNone)
{
    auto series = yearly(6);
    series[3].day = series[2].day;
    for (std::size_t i = 3; i < 6; ++i)
        series[i].value = 9;
    const auto jump = largestJump(series, {});
    ASSERT_TRUE(jump);
    EXPECT_NE(jump->before, 3u);
    EXPECT_FALSE(largestJump(yearly(2), {}));
    EXPECT_FALSE(largestJump(yearly(3), {}));
    EXPECT_FALSE(largestJump({}, {}));
    std::vector<DatedValue> oneDay(8, DatedValue{100, 1, 1});
    EXPECT_FALSE(largestJump(oneDay, {}));
    EXPECT_FALSE(driftOf(oneDay, {}));
    EXPECT_FALSE(largestJump(yearly(8), {ErrorScale::Unknown, true, 2, {}})); // all equal: no scatter to hold a step against
}
