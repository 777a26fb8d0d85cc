#pragma once
/// What is believed of a compass before it is read again. Its coefficients A … E, held against its card (the curve of its last swing),
///   change = walk N(0, σ²t) + with probability 1 − exp(−λt) a jump N(0, J²),
/// each coefficient for itself. σ is learnt from what happened between its swings, the plausible sizes being where that begins: a compass
/// whose C wanders is checked where C shows. Degrees and years throughout.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/base/Result.h"
#include "core/deviation/Smith.h"
#include "core/record/Aircraft.h"

namespace lubberline {

using PerCoefficient = std::array<double, kCoefficientCount>;

/// Sizes that are plausible before anything is known of a compass; standard deviations.
struct PlausibleChange {
    PerCoefficient walk_deg_year{0.3, 0.5, 0.5, 0.15, 0.15}; ///< by which it wanders in the first year
    PerCoefficient jump_deg{2, 4, 4, 1, 1};                  ///< when something happened
    double jumpsPerYear = 0.05;
    PerCoefficient swing_deg{0.3, 0.2, 0.2, 0.15, 0.15}; ///< of a swing beyond its readings: crew, base, instrument
    PerCoefficient unknown_deg{2, 5, 5, 1.5, 1};         ///< the coefficients of a compass of which nothing is known
};
/// A direct-reading compass has magnets that move and a card; a remote one a mount, a transmission and a corrector.
[[nodiscard]] PlausibleChange plausibleFor(CompassKind kind);

/// A swing of its history. What its headings did not tell has no value, and standard errors are those of its fit.
struct PastSwing {
    double year = 0; ///< decimal
    std::array<std::optional<double>, kCoefficientCount> value_deg;
    PerCoefficient standardError_deg{};
    bool afterCorrection = false; ///< what changed since the swing before was done on purpose
};

/// One possible size of everything, equally likely with the others of its kind.
struct PossibleChange {
    PerCoefficient variance_deg2{}; ///< of what changed since the card
    double weight = 1;              ///< before anything is read
    bool jumped = false;
};

struct CompassBelief {
    bool hasHistory = false;
    ApproximateSmith card; ///< of its last swing; without history: no deviation
    double yearsSince = 0;
    PerCoefficient walk_deg_year{}; ///< what its history makes likely; the plausible ones without
    double jumpProbability = 0;     ///< since its last swing
    std::vector<PossibleChange> possible;
};

/// @param swings in the order of time; only those before `year` count.
[[nodiscard]] CompassBelief beliefOf(std::span<const PastSwing> swings, double year, const PlausibleChange& plausible);

/// Row of [P 4] at a compass heading: 1, sin, cos, sin 2, cos 2.
[[nodiscard]] Eigen::Matrix<double, 5, 1> rowAt(double compass_deg);

} // namespace lubberline
