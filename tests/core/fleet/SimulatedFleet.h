#pragma once
/// Fleets whose truth is known: what the estimates are held against.

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <random>
#include <string>

#include "core/fleet/FleetReport.h"

namespace lubberline::test {

struct Truth {
    std::uint32_t seed = 1;
    int aircraft = 40, swings = 8; ///< a compass; a year apart
    int points = 8;
    FiveTerms mean{0.5, -1.0, 0.8, 2.0, 0.2}, between{0.4, 1.0, 1.0, 0.3, 0.3};
    double noise_deg = 0.5; ///< of a reading
    double swing_deg = 0;   ///< of A from swing to swing
    bool pairs = false;     ///< each visit as found, then corrected and as left
    std::optional<double> limit_deg = 5.0;
    /// Added to a coefficient of an aircraft at a swing.
    std::function<double(int aircraft, int swing, std::size_t c)> extra = {};
};

class SimulatedFleet {
public:
    explicit SimulatedFleet(const Truth& truth) : m_random(truth.seed)
    {
        for (int a = 0; a < truth.aircraft; ++a) {
            FleetCompass compass;
            compass.type = "T-1";
            compass.aircraft = "SIM-" + std::to_string(1000 + a);
            compass.compass = "standby";
            compass.limit_deg = truth.limit_deg;
            fleet.compasses.push_back(compass);
            FiveTerms own{};
            for (std::size_t c = 0; c < 5; ++c)
                own[c] = truth.mean[c] + truth.between[c] * normal();
            for (int s = 0; s < truth.swings; ++s) {
                FiveTerms now = own;
                now[0] += truth.swing_deg * normal();
                for (std::size_t c = 0; c < 5 && truth.extra; ++c)
                    now[c] += truth.extra(a, s, c);
                const int day = 14000 + 365 * s + static_cast<int>(20 * uniform());
                add(a, day, SwingStage::AsFound, now, truth);
                if (truth.pairs) {
                    for (std::size_t c = 0; c < 3; ++c)
                        own[c] -= now[c];
                    for (std::size_t c = 0; c < 3; ++c)
                        now[c] = 0;
                    add(a, day, SwingStage::AsLeft, now, truth);
                }
            }
        }
        putInOrder(fleet);
    }

    double normal() { return std::normal_distribution<>()(m_random); }
    double uniform() { return std::uniform_real_distribution<>()(m_random); }

    FleetSwings fleet;

private:
    void add(int compass, int day, SwingStage stage, const FiveTerms& smith, const Truth& truth)
    {
        FleetSwing swing;
        swing.compass = compass;
        swing.day = day;
        swing.stage = stage;
        swing.first = static_cast<std::uint32_t>(fleet.compass_deg.size());
        swing.count = static_cast<std::uint32_t>(truth.points);
        fleet.swings.push_back(swing);
        for (int r = 0; r < truth.points; ++r) {
            const double magnetic = 360.0 * r / truth.points;
            fleet.magnetic_deg.push_back(magnetic);
            fleet.compass_deg.push_back(wrap360(magnetic - curveAtMagnetic(smith, magnetic).deviation_deg - truth.noise_deg * normal()));
        }
    }
    std::mt19937 m_random;
};

inline FleetReport reported(const FleetSwings& fleet, const FleetOptions& options = {})
{
    auto report = fleetReportOf(fleet, options);
    EXPECT_TRUE(report) << (report ? "" : describe(report.error()));
    return report ? std::move(report.value()) : FleetReport{};
}

} // namespace lubberline::test
