// D and E of a type: its standard soft-iron correction, and how far its next aircraft lies from it.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/fleet/SimulatedFleet.h"

namespace lubberline::test {

TEST(SoftIron, isTheMeanOfTheTypeAndHoldsItsNextAircraftAsOftenAsItSays)
{
    Truth truth;
    truth.aircraft = 12;
    truth.swings = 4;
    truth.mean = {0.5, -1, 0.8, -2.2, 0.2};
    truth.between = {0.4, 1, 1, 0.3, 0.1};
    int holds = 0, near = 0;
    constexpr int runs = 300;
    double between = 0;
    for (int run = 0; run < runs; ++run) {
        truth.seed = static_cast<std::uint32_t>(run + 1);
        SimulatedFleet simulated(truth);
        const auto curves = curvesOf(simulated.fleet);
        const auto standards = softIronOf(simulated.fleet, *curves);
        ASSERT_EQ(standards.size(), 1u);
        const auto& D = standards[0].D;
        ASSERT_TRUE(D);
        EXPECT_EQ(D->aircraft, 12);
        const double next = -2.2 + 0.3 * simulated.normal();
        holds += D->next95_deg.low <= next && next <= D->next95_deg.high;
        near += std::abs(D->mean_deg + 2.2) < 2.2 * D->standardError_deg; // Student's 95 % of 11 degrees
        between += D->between_deg / runs;
    }
    EXPECT_NEAR(holds / double(runs), 0.95, 0.04);
    EXPECT_NEAR(near / double(runs), 0.95, 0.04);
    EXPECT_NEAR(between, 0.3, 0.02);
}

TEST(SoftIron, saysNothingOfAFewAircraftOrOfCardinals)
{
    Truth truth;
    truth.aircraft = 2;
    SimulatedFleet few(truth);
    EXPECT_TRUE(softIronOf(few.fleet, *curvesOf(few.fleet)).empty());
    truth.aircraft = 5;
    truth.points = 4;
    SimulatedFleet cardinals(truth);
    const auto standards = softIronOf(cardinals.fleet, *curvesOf(cardinals.fleet));
    ASSERT_EQ(standards.size(), 1u);
    EXPECT_FALSE(standards[0].D);
    EXPECT_TRUE(standards[0].E);
}

TEST(SoftIron, isWhatIsExpectedOfTheNextAircraftBeforeItIsSwung)
{
    const ExpectedCurve any = anyCurve();
    SoftIronStandard standard;
    standard.D = SoftIronCoefficient{3, -2, 0.06, 0.1, 0.1, {-2.43, -1.57}}; // Student's 4.303 of two degrees
    const ExpectedCurve expected = expectedOf(standard);
    EXPECT_NEAR(toDegrees(expected.mean.D_rad), -2, 1e-12);
    EXPECT_NEAR(toDegrees(expected.standardDeviation.D_rad), 0.43 / 1.96, 1e-4);
    EXPECT_EQ(expected.standardDeviation.A_rad, any.standardDeviation.A_rad);
    EXPECT_EQ(expected.mean.E_rad, 0);
    EXPECT_EQ(expected.standardDeviation.E_rad, any.standardDeviation.E_rad);
    standard.D->next95_deg = {-2, -2}; // all alike: not sure without end
    EXPECT_NEAR(toDegrees(expectedOf(standard).standardDeviation.D_rad), 0.2, 1e-12);
}

TEST(SoftIron, isSaidInOneLine)
{
    const SoftIronCoefficient D{20, -2.214, 0.041, 0.08, 0.09, {-2.40, -2.03}};
    EXPECT_EQ(inWords(D, 'D').english(),
        "D \u22122.21\u00B0 \u00B1 0.04\u00B0 from 20 aircraft; the next one within \u22122.40\u00B0 to \u22122.03\u00B0 (95 %)");
}

TEST(SwingNext, isTheRankingOfTheReport)
{
    Truth truth;
    truth.extra = [](int aircraft, int swing, std::size_t c) { return aircraft == 7 && c == 1 ? 0.5 * swing : 0.0; };
    SimulatedFleet simulated(truth);
    FleetOptions options;
    options.variance = false;
    options.today_day = 17000;
    const auto report = reported(simulated.fleet, options);
    const auto next = swingNext(simulated.fleet, 17000);
    ASSERT_TRUE(next);
    ASSERT_EQ(next->compasses.size(), report.ranking.compasses.size());
    for (std::size_t i = 0; i < next->compasses.size(); ++i) {
        EXPECT_EQ(next->compasses[i].compass, report.ranking.compasses[i].compass);
        EXPECT_EQ(next->compasses[i].probability, report.ranking.compasses[i].probability);
    }
    const auto& first = next->compasses.front();
    ASSERT_FALSE(first.reachedShare.empty());
    EXPECT_TRUE(std::ranges::is_sorted(first.reachedShare));
    EXPECT_LE(first.reachedShare.back(), 1.0);
    EXPECT_TRUE(swingNext({}, 17000)->compasses.empty());
    EXPECT_EQ(swingNext(simulated.fleet, 17000, [](double) { return false; }).error().code, ErrorCode::Cancelled);
}

} // namespace lubberline::test
