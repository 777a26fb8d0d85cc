#pragma once
/// Site check: one run clockwise, one counter-clockwise, over the same headings. What differs is no deviation:
///   δ = A + B sin ψ' + C cos ψ' + D sin 2ψ' + E cos 2ψ' ± (a + b sin ψ' + c cos ψ')/2,   + clockwise
/// a is lag (card, liquid, a reference that is late): it goes with the turn's rate. b and c are iron that keeps a trace of the heading
/// before, or a site whose field is another on the other track.

#include <array>
#include <optional>
#include <span>

#include "core/base/Result.h"
#include "core/deviation/Smith.h"

namespace lubberline {

struct BothWays {
    std::array<double, 3> difference_deg{}, standardError_deg{}; ///< clockwise − counter-clockwise: constant, sin, cos
    double largest_deg = 0;                                      ///< of the difference over heading
    double residual_deg = 0;                                     ///< rms of what is left
    double limit_deg = 0;
    bool passes = false; ///< within the limit, and both runs go all around, each its own way
    std::vector<Message> findings;
    [[nodiscard]] bool within() const { return largest_deg <= limit_deg; }
};

/// @param clockwise,counterClockwise in the order in which they were read: the order shows which way round a run was turned
/// Errors: InvalidInput (fewer than six readings of a run), Numeric (headings that do not tell it).
Result<BothWays> turnedBothWays(std::span<const Observation> clockwise, std::span<const Observation> counterClockwise, double limit_deg);

} // namespace lubberline
