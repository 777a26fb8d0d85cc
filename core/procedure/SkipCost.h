#pragma once

#include <span>

namespace lubberline {

/// What readings that could not be made cost: the standard error of the fitted curve where it is largest, in units of that of
/// one reading, δ = A + B sin ψ + C cos ψ + D sin 2ψ + E cos 2ψ [P 4] (without D and E where fewer than five headings remain):
///   largest over ψ of √(xᵀ (XᵀX)⁻¹ x)
struct SkipCost {
    double planned = 0;                 ///< with every heading of the plan
    double remaining = 0;               ///< with those that were read; infinite where they do not tell the curve at all
    double at_deg = 0;                  ///< the heading where it is largest then
    bool withoutSecondHarmonic = false; ///< D and E are not told any more
};

/// @param planned_deg the headings of the plan, read_deg those of them that were read [deg]; at least five planned ones.
[[nodiscard]] SkipCost skipCost(std::span<const double> planned_deg, std::span<const double> read_deg);

} // namespace lubberline
