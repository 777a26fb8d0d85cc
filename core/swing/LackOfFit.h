#pragma once
/// Whether five coefficients describe what was read: more than they can (a third harmonic, a bump) is said, not hidden in a mean residual.

#include <optional>
#include <span>

#include "core/deviation/SmithFit.h"

namespace lubberline {

struct LackOfFit {
    Message words;
    std::vector<double>
        beyond_rad; ///< by reading, what five coefficients cannot describe (HigherShape.h); empty: a scatter is all that is known
    [[nodiscard]] bool anotherShape() const { return !beyond_rad.empty(); }
};

/// Of the fit that leaves less (large deviations are described by the exact one), where it leaves more than the reading error explains:
/// (a) harmonics beyond the second take away more of the residuals than chance would, or (b) the scatter is more than the reading
/// error and the usual handling (0.45°) leave in one swing of a hundred; of logs over three times the reading error and over 1.5°.
/// @param readingError_rad 0: (b) by 1.5° alone. @param leftOut readings that slipped, in ascending order: (a) without them.
[[nodiscard]] std::optional<LackOfFit> lackOfFit(std::span<const Observation> readings, const ApproximateFit& approximate,
    const ExactFit& exact, double readingError_rad, const std::vector<std::size_t>& leftOut = {});

} // namespace lubberline
