#pragma once
/// Whether five coefficients describe what was read: more than they can (a third harmonic, a bump) is said, not hidden in a mean residual.

#include <optional>
#include <span>

#include "core/deviation/SmithFit.h"

namespace lubberline {

struct LackOfFit {
    Message words;
    bool anotherShape = false; ///< by their harmonics, not by their scatter alone
};

/// Of the fit that leaves less (large deviations are described by the exact one), where it leaves more than the reading error explains:
/// (a) a third and fourth harmonic take away more of the residuals than chance would (F test, 1 %, from ten readings on), or (b) the
/// scatter is over three times the reading error and over 1.5°. @param readingError_rad 0: (b) by 1.5° alone.
[[nodiscard]] std::optional<LackOfFit> lackOfFit(
    std::span<const Observation> readings, const ApproximateFit& approximate, const ExactFit& exact, double readingError_rad);

} // namespace lubberline
