#pragma once
/// The vertical in a moving aircraft [K 9.1–9.9] as formulas: for help, problems, budgets. Radians, SI.

namespace lubberline {

/// tan δ = a_H/(g + a_V), a_V up positive [K 9.1]: tilt of the apparent vertical. @param gravity in the unit of the accelerations.
[[nodiscard]] double apparentTilt_rad(double horizontal, double upward, double gravity);

/// σ = V² tan Φ/(g R): flight along a parallel [K 9.8]. The book prints 0.20° for 1000 ft/s at 70°; the formula gives 0.23°.
[[nodiscard]] double constantLatitudeTilt_rad(double speed_m_s, double latitude_rad, double gravity_m_s2);
/// 2 Ω V sin Φ [m/s²], to be balanced by a force towards the left on the northern hemisphere; over g it is a tilt.
[[nodiscard]] double coriolis_m_s2(double speed_m_s, double latitude_rad);
/// σ = V Δψ̇/g: lateral acceleration corrected with a wrong rate of turn [K 9.9].
[[nodiscard]] double turnRateErrorTilt_rad(double speed_m_s, double turnRateError_rad_s, double gravity_m_s2);
/// V/R: rate of the true vertical along the track.
[[nodiscard]] double transportRate_rad_s(double speed_m_s);

/// k = H/τ1 [dyn·cm/rad] for an angular momentum H [g·cm²/s] (problem 9.3).
[[nodiscard]] double torquePerTilt(double angularMomentum, double tau1_s);
/// x = ω H/(m g) [cm]: the shift of the mass along the spin axis that drifts ω per g (problem 9.1).
[[nodiscard]] double axialShift_cm(double drift_rad_s_g, double angularMomentum, double mass_g);

} // namespace lubberline
