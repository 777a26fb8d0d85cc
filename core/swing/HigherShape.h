#pragma once
/// What five coefficients leave of a deviation curve that has more than they can describe: a third harmonic, a bump, a step. Neighbouring
/// readings go astray together then, which one misread figure does not.

#include <optional>
#include <span>
#include <vector>

#include "core/deviation/Smith.h"

namespace lubberline {

struct HigherShape {
    std::vector<double> at_rad;          ///< by reading, also at those that were left out
    double size_rad = 0;                 ///< amplitude of a sine that is as large in the mean of squares
    std::optional<double> onlyThird_rad; ///< amplitude, where the third harmonic is the most of it
};

/// From ten readings on: harmonics beyond the second, each alone and all together, by the F test that is the least likely to be chance; the
/// level of 1 % is shared among the tests. One reading that slipped is no harmonic more than any other, and is no shape. Readings of a
/// log (200 and more) are not independent: none is told of them.
/// @param residual_rad what a fit of five coefficients leaves of each. @param leftOut readings that do not count, in ascending order.
[[nodiscard]] std::optional<HigherShape> higherShape(
    std::span<const Observation> readings, const std::vector<double>& residual_rad, const std::vector<std::size_t>& leftOut = {});

} // namespace lubberline
