#pragma once
/// The directional gyro [K 9.4.6]: gimbal error, apparent drift, slaving. Radians, SI.

#include "core/reference/TiltedCompass.h"

namespace lubberline {

/// ψ' = atan2(cos φ sin ψ − sin φ sin θ cos ψ, cos θ cos ψ), the outer axis being the body's z axis and the spin axis on north;
/// with the spin axis at azimuth χ, ψ − χ stands for ψ. @return read − true.
[[nodiscard]] double gimbalError_rad(MagneticHeading heading, SensorTilt outerAxis, double spinAxis_rad = 0);
/// Largest gimbal error of an outer axis tilted by λ: asin(tan²(λ/2)); the book's λ²/4 is its beginning.
[[nodiscard]] double largestGimbalError_rad(double tilt_rad);

/// −(Ω sin Φ + V_E tan Φ/R): what a free gyro's reading does [rad/s]. Not for the poles, where there is no north to drift from.
[[nodiscard]] double apparentDrift_rad_s(double latitude_rad, double eastward_m_s);

/// τ_s d: what is left of a drift by first-order slaving, τ_s ė + e = e_m + τ_s d.
[[nodiscard]] double slavingStandoff_rad(double tau_s, double drift_rad_s);
/// 1/√(1 + (n ψ̇ τ_s)²): what is left in a steady turn of a deviation with n cycles.
[[nodiscard]] double slavingGain(double tau_s, double frequency_rad_s);

} // namespace lubberline
