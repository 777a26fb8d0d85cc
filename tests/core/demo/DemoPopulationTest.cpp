// The demonstration's population is like the source paper's, and what was put into it is found.

#include <gmock/gmock.h>

#include "core/demo/DemoFleet.h"
#include "core/demo/DemoPopulation.h"
#include "core/fleet/FleetReport.h"

namespace lubberline::test {

namespace {

/// The columns of one type of a fleet.
FleetSwings columnsOf(const Fleet& from, const std::string& type)
{
    FleetSwings fleet;
    std::vector<std::int32_t> place(from.compasses.size(), -1);
    for (const auto& system : from.compasses) {
        const auto& aircraft = from.aircraft[static_cast<std::size_t>(system.aircraft.value) - 1];
        if (from.types[static_cast<std::size_t>(aircraft.type.value) - 1].name != type)
            continue;
        place[static_cast<std::size_t>(system.id.value) - 1] = static_cast<std::int32_t>(fleet.compasses.size());
        FleetCompass compass;
        compass.type = type;
        compass.aircraft = aircraft.registration;
        compass.compass = system.name;
        compass.kind = system.kind;
        compass.limit_deg = from.limits[static_cast<std::size_t>(system.limits.value) - 1].maxDeviation_deg;
        compass.readingError_deg = system.resolution_deg / std::sqrt(12.0);
        for (const auto& event : from.events)
            if (event.aircraft == aircraft.id)
                compass.events.push_back({*dayOfDate(event.date.text()), event.kind});
        fleet.compasses.push_back(compass);
    }
    for (const auto& swing : from.swings) {
        const auto compass = place[static_cast<std::size_t>(swing.compass.value) - 1];
        if (compass < 0)
            continue;
        FleetSwing row;
        row.compass = compass;
        row.day = *dayOfDate(swing.date.text());
        row.stage = swing.stage;
        row.first = static_cast<std::uint32_t>(fleet.magnetic_deg.size());
        for (const auto& reading : swing.readings) {
            fleet.magnetic_deg.push_back(reading.magnetic->degrees());
            fleet.compass_deg.push_back(reading.compass->degrees());
            ++row.count;
        }
        fleet.swings.push_back(row);
    }
    putInOrder(fleet);
    return fleet;
}

} // namespace

class DemoPopulation : public testing::TestWithParam<std::uint64_t> {};

TEST_P(DemoPopulation, isLikeThePapersAndWhatWasPutInIsFound)
{
    DemoOptions demo;
    demo.seed = GetParam();
    const auto fleet = columnsOf(demoFleet(demo), kDemoPopulationType);
    FleetOptions options;
    options.today_day = *dayOfDate("2026-11-26");
    options.variance = false;
    const auto report = fleetReportOf(fleet, options);
    ASSERT_TRUE(report);
    EXPECT_EQ(report->counts.aircraft, 20);
    EXPECT_THAT(report->pattern.maxima_deg, testing::ElementsAre(135, 315));
    EXPECT_THAT(report->pattern.minima_deg, testing::ElementsAre(45, 225));
    const auto& coefficients = report->pattern.coefficients;
    const auto mean = [&](std::size_t c) { return std::abs(*coefficients[c].mean_deg); };
    EXPECT_GT(mean(3), mean(0)); // D, A, B in the mean
    EXPECT_GT(mean(0), mean(2));
    EXPECT_GT(mean(1), mean(2));
    EXPECT_GT(mean(1), mean(4));
    for (const std::size_t c : {0u, 1u, 2u}) // A, B and C in the spread
        for (const std::size_t other : {3u, 4u})
            EXPECT_GT(*coefficients[c].standardDeviation_deg, *coefficients[other].standardDeviation_deg) << c << other;
    ASSERT_TRUE(report->plants.training);
    EXPECT_EQ(dateOfDay(report->plants.training->day).substr(0, 4), std::to_string(demo.lastYear - kDemoTrainedYears + 1));
    EXPECT_NEAR(report->plants.training->change, -0.8, 0.08);
    for (const auto& put : demoJumps()) {
        const auto found = std::ranges::find_if(report->changes.jumps, [&](const FleetJump& jump) {
            return jump.coefficient == put.coefficient
                && fleet.compasses[static_cast<std::size_t>(jump.compass)].aircraft == std::to_string(3201 + put.aircraft);
        });
        ASSERT_NE(found, report->changes.jumps.end()) << put.aircraft;
        EXPECT_NEAR(found->change_deg, put.size_deg, 4 * found->standardError_deg);
        EXPECT_EQ(dateOfDay(fleet.swings[found->beforeRow].day).substr(0, 4), std::to_string(demo.lastYear - put.year));
        EXPECT_EQ(found->event, put.event);
    }
    EXPECT_LE(report->changes.jumps.size(), demoJumps().size() + 2);
    const std::string drifting = std::to_string(3201 + kDemoDrifting);
    ASSERT_FALSE(report->changes.drifts.empty());
    const auto& drift = report->changes.drifts.front();
    EXPECT_EQ(fleet.compasses[static_cast<std::size_t>(drift.compass)].aircraft, drifting);
    EXPECT_LT(drift.drift.interval95.low, kDemoDrift_deg_year);
    EXPECT_GT(drift.drift.interval95.high, kDemoDrift_deg_year - 0.1);
    EXPECT_EQ(fleet.compasses[static_cast<std::size_t>(report->ranking.compasses.front().compass)].aircraft, drifting);
    EXPECT_GT(report->exceedance.pairs, 50);
}

INSTANTIATE_TEST_SUITE_P(Seeds, DemoPopulation, testing::Values(1, 2, 3));

} // namespace lubberline::test
