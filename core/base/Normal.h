#pragma once
/// The normal distribution's figures that intervals are made with.

namespace lubberline {

/// Half width of the 95 % interval of an error whose size is known, in standard errors.
inline constexpr double kNormal95 = 1.959963984540054;

} // namespace lubberline
