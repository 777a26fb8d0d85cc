#pragma once
/// The iron that makes a compass's deviation level, as a flight needs it: P = 𝔅H, Q = ℭH, a = −e = 𝔇, d = 𝔈 + 𝔄, b = 𝔈 − 𝔄 [P 7]. What a swing
/// on the ground cannot tell (R, c, f, g, h, k) is none.

#include "core/deviation/Smith.h"
#include "core/sensor/SensorModel.h"

namespace lubberline {

/// Level where the horizontal field is H, its deviation is deviationAt(smith, ψ) with no approximation.
[[nodiscard]] SensorModel levelIron(const ExactSmith& smith, double horizontal_nT);

} // namespace lubberline
