#pragma once
/// Figures of results, as our JSON writes them.

#include <cmath>

namespace lubberline {

/// What the way through radians leaves in the last digits is cut: 90 is not written as 89.99999999999999, and 0 has no sign.
[[nodiscard]] inline double toTenDecimals(double value) { return std::round(value * 1e10) / 1e10 + 0.0; }

} // namespace lubberline
