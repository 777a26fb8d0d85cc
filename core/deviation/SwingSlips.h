#pragma once
/// Which readings of a whole swing were misread, misheard or written wrong, by Bayes' rule over "all as read" and every slip of
/// every reading. Eight readings leave three degrees of freedom: their scatter alone finds little. What is known besides is used:
/// how a compass is read (the scatter, within what crews reach), how aircraft compasses deviate (most a little, some much), this one by its last
/// swing, and how people slip.
///   model: sin δ = 𝔄 cos δ + 𝔅 sin ψ' + ℭ cos ψ' + 𝔇 sin(ψ+ψ') + 𝔈 cos(ψ+ψ') + ε [P 3, multiplied out], coefficients normal,
///   ε normal with a scatter that is itself uncertain (log-normal about half a degree, besides the division of the compass).
///   With a history: coefficients as after the last swing in four of five swings, and as of any compass in the fifth (engines are changed,
///   lightning strikes); the readings tell which.

#include <optional>
#include <span>
#include <vector>

#include "core/base/Progress.h"
#include "core/deviation/SlipCheck.h"

namespace lubberline {

struct SlippedReading {
    std::size_t reading = 0;
    double probability = 0;                ///< that this reading slipped; with `orReadings`: that one of them all did
    std::vector<std::size_t> orReadings;   ///< the others that could be it instead: which one slipped cannot be told
    std::vector<SlipCandidate> candidates; ///< the likeliest first; probabilities of what this reading may have meant
};

struct SlipSearch {
    std::vector<SlippedReading> slips; ///< in order of their finding: the likeliest first; all that cannot be told apart are listed
    /// A misreading of one reading by less than this could pass unseen [deg]: of the reading that is checked worst. None without check.
    std::optional<double> seenFrom_deg;
};

/// @param resolution_deg smallest division of the compass. @param history how this compass is expected to deviate by its last swing;
/// its index is no matter, as the middle of the readings' deviations is taken out. @param beyond_rad by reading, what is known of the curve
/// beyond five coefficients (a third harmonic, a bump): none is held for a slip. Fewer than three readings check nothing.
/// @param progress told false, the search ends with what it has found by then: ask it again.
[[nodiscard]] SlipSearch findSlips(std::span<const Observation> readings, double resolution_deg,
    const std::optional<ExpectedCurve>& history = {}, std::span<const double> beyond_rad = {}, const Progress& progress = {});

} // namespace lubberline
