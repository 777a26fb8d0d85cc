#pragma once
/// Compasses as core/check believes them to be, with their truth known.

#include <cmath>

#include "core/check/CheckRandom.h"
#include "core/check/FaultTest.h"
#include "core/check/TwoCompasses.h"

namespace lubberline::test {

struct SimulatedCompass {
    std::vector<PastSwing> history;
    Eigen::Matrix<double, 5, 1> now; ///< its coefficients
    bool fault = false;              ///< its card does not hold any more
    CompassBelief belief;

    /// What it reads on a compass heading: deviation by [P 4], with the error of reading it.
    [[nodiscard]] Observation read(double compass_deg, double error_deg, CheckRandom& random) const
    {
        const double deviation = rowAt(compass_deg).dot(now) + error_deg * random.normal();
        return {MagneticHeading::fromDegrees(compass_deg + deviation), CompassHeading::fromDegrees(compass_deg)};
    }
};

/// `swings` a year apart, and the compass a year after the last.
inline SimulatedCompass simulateCompass(int swings, const PlausibleChange& plausible, const CheckOptions& options, CheckRandom& random)
{
    SimulatedCompass compass;
    std::array<double, 5> walk{};
    Eigen::Matrix<double, 5, 1> truth;
    for (std::size_t c = 0; c < 5; ++c) {
        walk[c] = plausible.walk_deg_year[c] * std::exp2(random.normal());
        truth[static_cast<Eigen::Index>(c)] = plausible.unknown_deg[c] * random.normal();
    }
    const double perYear = -std::expm1(-plausible.jumpsPerYear);
    const std::array<double, 5> error{0.35, 0.5, 0.5, 0.5, 0.5}; // of eight readings to 1°
    for (int year = 0; year <= swings; ++year) {
        if (year > 0) {
            const bool jump = random.uniform() < perYear;
            for (std::size_t c = 0; c < 5; ++c) {
                truth[static_cast<Eigen::Index>(c)] += walk[c] * random.normal();
                truth[static_cast<Eigen::Index>(c)] += jump ? plausible.jump_deg[c] * random.normal() : 0;
            }
        }
        if (year == swings)
            break;
        PastSwing swing;
        swing.year = 2010 + year;
        for (std::size_t c = 0; c < 5; ++c) {
            swing.value_deg[c] = truth[static_cast<Eigen::Index>(c)] + std::hypot(error[c], plausible.swing_deg[c]) * random.normal();
            swing.standardError_deg[c] = error[c];
        }
        compass.history.push_back(swing);
    }
    compass.now = truth;
    compass.belief = beliefOf(compass.history, 2010 + swings, plausible);
    Eigen::Matrix<double, 5, 1> change = truth;
    if (!compass.history.empty())
        for (std::size_t c = 0; c < 5; ++c)
            change[static_cast<Eigen::Index>(c)] -= *compass.history.back().value_deg[c];
    compass.fault = FaultTest(compass.belief.card, options.tolerance_deg, options.limit_deg).isFault(change);
    return compass;
}

} // namespace lubberline::test
