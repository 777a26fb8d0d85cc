#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/fleet/SimulatedFleet.h"

using namespace lubberline;
using namespace lubberline::test;

/// Of a kind that hardly drifts, where jumps are looked for without a trend: one in ten of those that do drift had a jump, too.
TEST(DriftIsNoJump, whereAFewDriftAmongMany)
{
    constexpr int drifting = 16;
    int found = 0;
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
        Truth truth;
        truth.seed = seed;
        truth.aircraft = 120;
        truth.swings = 10;
        truth.swing_deg = 0.3;
        truth.extra = [](int aircraft, int swing, std::size_t c) {
            if (aircraft == 100 && c == 2)
                return swing >= 5 ? 3.0 : 0.0; // and one did jump
            return aircraft < drifting && c == 1 ? 0.5 * swing : 0.0;
        };
        const auto changes = reported(SimulatedFleet(truth).fleet).changes;
        EXPECT_EQ(std::ranges::count_if(changes.jumps, [](const FleetJump& j) { return j.compass < drifting && j.coefficient == 1; }), 0)
            << seed;
        EXPECT_EQ(std::ranges::count_if(changes.jumps, [](const FleetJump& j) { return j.compass == 100 && j.coefficient == 2; }), 1)
            << seed;
        found += static_cast<int>(std::ranges::count_if(
            changes.drifts, [](const FleetDrift& d) { return d.compass < drifting && d.coefficient == 1 && d.drift.perYear > 0; }));
    }
    EXPECT_EQ(found, 3 * drifting);
}
