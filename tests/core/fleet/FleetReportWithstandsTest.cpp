// What the report of a fleet must withstand: few swings, equal ones, gaps, limits that are missing, mixed configurations.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/core/fleet/SimulatedFleet.h"

using namespace lubberline;
using namespace lubberline::test;

TEST(FleetReportWithstands, oneSwing)
{
    Truth truth;
    truth.aircraft = 1;
    truth.swings = 1;
    const SimulatedFleet simulated(truth);
    const auto report = reported(simulated.fleet);
    EXPECT_EQ(report.counts.used, 1);
    EXPECT_TRUE(report.pattern.points[0].mean_deg);
    EXPECT_FALSE(report.pattern.points[0].standardDeviation_deg);
    EXPECT_FALSE(report.pattern.points[0].between_deg);
    EXPECT_TRUE(report.pattern.spread.empty());
    EXPECT_FALSE(report.variance[0].report);
    EXPECT_FALSE(report.variance[0].why.empty());
    EXPECT_FALSE(report.exceedance.share95);
    EXPECT_TRUE(report.changes.jumps.empty());
    EXPECT_EQ(report.ranking.compasses.size(), 1u);
    EXPECT_FALSE(report.warnings.empty());
}

TEST(FleetReportWithstands, oneAircraftOfManySwings)
{
    Truth truth;
    truth.aircraft = 1;
    truth.swings = 12;
    truth.extra = [](int, int s, std::size_t c) { return c == 1 && s >= 6 ? 5.0 : 0.0; };
    const SimulatedFleet simulated(truth);
    const auto report = reported(simulated.fleet);
    // With its scatter estimated from the series itself.
    const auto B = std::ranges::find(report.changes.jumps, std::size_t{1}, &FleetJump::coefficient);
    ASSERT_NE(B, report.changes.jumps.end());
    EXPECT_NEAR(B->change_deg, 5.0, 1.5);
    EXPECT_LE(report.changes.jumps.size(), 2u);
    ASSERT_TRUE(report.variance[0].report);
    EXPECT_FALSE(report.variance[0].report->aircraft);
}

TEST(FleetReportWithstands, allEqual)
{
    Truth truth;
    truth.between = {};
    truth.noise_deg = 0;
    truth.pairs = false;
    const SimulatedFleet simulated(truth);
    const auto report = reported(simulated.fleet);
    EXPECT_NEAR(*report.pattern.points[0].standardDeviation_deg, 0, 1e-9);
    EXPECT_TRUE(report.changes.jumps.empty());
    EXPECT_TRUE(report.changes.drifts.empty());
    EXPECT_FALSE(report.plants.training);
    for (const auto& ranked : report.ranking.compasses)
        EXPECT_LT(ranked.probability, 0.01);
}

TEST(FleetReportWithstands, twoSwingsOnOneDayAndGapsOfYears)
{
    Truth truth;
    truth.aircraft = 20;
    SimulatedFleet simulated(truth);
    for (auto& swing : simulated.fleet.swings) {
        if (swing.day < 14365)
            swing.day = 14000; // twice a day, then a gap of eight years
        else if (swing.day > 15500)
            swing.day += 3000;
        else
            swing.day = 14000;
    }
    putInOrder(simulated.fleet);
    const auto report = reported(simulated.fleet);
    for (const auto& jump : report.changes.jumps)
        EXPECT_GT(simulated.fleet.swings[jump.beforeRow].day, simulated.fleet.swings[jump.afterRow].day);
    EXPECT_EQ(report.ranking.compasses.size(), 20u);
}

TEST(FleetReportWithstands, gridOfSevenHeadings)
{
    Truth truth;
    truth.points = 7;
    const SimulatedFleet simulated(truth);
    const auto report = reported(simulated.fleet, {.grid = 7, .variance = false});
    ASSERT_EQ(report.pattern.points.size(), 7u);
    EXPECT_EQ(report.pattern.mean.size(), 4u); // orders 0 … 3
    EXPECT_FALSE(fleetReportOf(simulated.fleet, {.grid = 2}));
    // Swings of seven headings on a grid of eight enter moved along their own curve.
    const auto eight = reported(simulated.fleet, {.grid = 8, .variance = false});
    const auto curve = *eight.pattern.points[3].mean_deg;
    double expected = 0;
    for (std::size_t c = 0; c < 5; ++c)
        expected += *eight.pattern.coefficients[c].mean_deg * termsAt(135.0 - curve)[c];
    EXPECT_NEAR(curve, expected, 0.2);
}

TEST(FleetReportWithstands, fourPointSwings)
{
    Truth truth;
    truth.points = 4;
    truth.mean[3] = 0;
    truth.between[3] = 0;
    const SimulatedFleet simulated(truth);
    const auto report = reported(simulated.fleet);
    EXPECT_EQ(report.pattern.coefficients[3].units, 0);
    EXPECT_FALSE(report.pattern.coefficients[3].mean_deg);
    EXPECT_EQ(report.pattern.coefficients[4].units, 40);
    EXPECT_FALSE(report.variance[3].report);
    EXPECT_FALSE(report.pattern.points[1].between_deg); // the curve between them is not known
    EXPECT_FALSE(report.exceedance.expectedShare);
}

TEST(FleetReportWithstands, limitThatIsMissing)
{
    Truth truth;
    truth.limit_deg.reset();
    truth.pairs = true;
    const SimulatedFleet simulated(truth);
    const auto report = reported(simulated.fleet);
    EXPECT_EQ(report.exceedance.pairs, 0);
    EXPECT_EQ(report.exceedance.withoutLimit, 40 * 7);
    EXPECT_TRUE(report.ranking.compasses.empty());
    EXPECT_EQ(report.ranking.withoutLimit, 40u);
    const auto given = reported(simulated.fleet, {.limit_deg = 3.0});
    EXPECT_EQ(given.exceedance.pairs, 40 * 7);
    EXPECT_EQ(given.ranking.compasses.size(), 40u);
}

TEST(FleetReportWithstands, mixedConfigurationsAreTold)
{
    Truth truth;
    SimulatedFleet simulated(truth);
    for (std::size_t i = 0; i < simulated.fleet.swings.size(); ++i)
        simulated.fleet.swings[i].radio = i % 8 == 0 ? RadioState::On : RadioState::Off;
    simulated.fleet.compasses[0].type = "T-0";
    putInOrder(simulated.fleet);
    const auto report = reported(simulated.fleet, {.variance = false});
    std::string words;
    for (const auto& warning : report.warnings)
        words += warning.english() + '\n';
    EXPECT_NE(words.find("radio on and off"), std::string::npos) << words;
    EXPECT_NE(words.find("2 aircraft types"), std::string::npos) << words;
    EXPECT_NE(words.find("40 swings not compared"), std::string::npos) << words;
}

TEST(FleetReportWithstands, cancelling)
{
    const SimulatedFleet simulated(Truth{});
    int asked = 0;
    const auto report = fleetReportOf(simulated.fleet, {}, [&](double) { return ++asked < 3; });
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().code, ErrorCode::Cancelled);
    EXPECT_FALSE(fleetReportOf({}, {}));
}
