// Records whose sign is suspect: told, by their type's D, and never turned.

#include <gmock/gmock.h>

#include "core/fleet/SignCheck.h"
#include "tests/core/fleet/SimulatedFleet.h"

namespace lubberline::test {

namespace {

/// Deviations of a swing written with the other sign.
void turn(FleetSwings& fleet, const FleetSwing& swing)
{
    for (auto i = swing.first; i < swing.first + swing.count; ++i)
        fleet.compass_deg[i] = wrap360(2 * fleet.magnetic_deg[i] - fleet.compass_deg[i]);
}

std::vector<SignSuspicion> suspicionsIn(const FleetSwings& fleet) { return suspectSigns(fleet, *curvesOf(fleet)); }

Truth alike()
{
    Truth truth;
    truth.aircraft = 12;
    truth.swings = 6;
    return truth;
}

} // namespace

TEST(SignCheck, nobodyIsSuspectWhereAllAreAlike)
{
    for (const std::uint32_t seed : {1u, 2u, 3u, 4u, 5u}) {
        Truth truth = alike();
        truth.seed = seed;
        EXPECT_TRUE(suspicionsIn(SimulatedFleet(truth).fleet).empty()) << seed;
    }
}

TEST(SignCheck, yearsThatWereWrittenTheOtherWayRoundAreTold)
{
    auto fleet = SimulatedFleet(alike()).fleet;
    const auto before = fleet;
    for (const auto& swing : fleet.swings) // half of the years of one, all of another
        if ((swing.compass == 3 && swing.day < 14000 + 3 * 365) || swing.compass == 7)
            turn(fleet, swing);
    const auto suspicions = suspicionsIn(fleet);
    ASSERT_EQ(suspicions.size(), 2u);
    EXPECT_EQ(suspicions[0].compass, 3);
    EXPECT_EQ(suspicions[0].rows.size(), 3u);
    EXPECT_EQ(suspicions[0].swings, 6u);
    EXPECT_EQ(suspicions[1].rows.size(), 6u);
    EXPECT_LT(suspicions[1].D_deg, 0);
    EXPECT_GT(suspicions[1].siblingsD_deg, 1.5);
    EXPECT_THAT(inWords(suspicions[0], fleet).english(), testing::HasSubstr("in 3 of 6 swings"));
    const auto report = reported(fleet);
    EXPECT_THAT(report.warnings,
        testing::Contains(testing::Truly([](const Message& m) { return m.english().find("is suspect") != std::string::npos; })));
    EXPECT_EQ(report.counts.used, static_cast<std::int64_t>(before.swings.size())); // nothing is left out for it
}

TEST(SignCheck, saysNothingWhereItCannotKnow)
{
    Truth small = alike();
    small.mean[3] = 0.2; // no D of its own
    EXPECT_TRUE(suspicionsIn(SimulatedFleet(small).fleet).empty());
    Truth few = alike();
    few.aircraft = 3;
    auto fleet = SimulatedFleet(few).fleet;
    for (const auto& swing : fleet.swings)
        if (swing.compass == 0)
            turn(fleet, swing);
    EXPECT_TRUE(suspicionsIn(fleet).empty());
    Truth four = alike();
    four.points = 4; // cardinals do not tell D
    EXPECT_TRUE(suspicionsIn(SimulatedFleet(four).fleet).empty());
    auto half = SimulatedFleet(alike()).fleet;
    for (const auto& swing : half.swings)
        if (swing.compass % 2 == 0)
            turn(half, swing);
    EXPECT_TRUE(suspicionsIn(half).empty()); // which half?
}

} // namespace lubberline::test
