#pragma once
/// From the magnetic sensor to the heading that is shown, a function a stage. All errors are read − magnetic [rad], (−π, π], one at
/// every point of the motion.

#include <optional>
#include <vector>

#include "core/reference/Motion.h"
#include "core/reference/VerticalRun.h"

namespace lubberline {

/// Sines and cosines of pitch and roll.
struct TurnedBy {
    double sinPitch = 0, cosPitch = 1, sinRoll = 0, cosRoll = 1;
};

/// The aircraft's attitude: the bank of its turn, the pitch of its climb.
[[nodiscard]] std::vector<TurnedBy> bodyAttitudes(const Motion& motion);
/// Of a sensor that hangs freely.
[[nodiscard]] std::vector<TurnedBy> hangingAttitudes(const Motion& motion);
/// Of a sensor on a platform with this tilt.
[[nodiscard]] std::vector<TurnedBy> platformAttitudes(const std::vector<AxisTilt>& tilt);

/// What the sensor reads: the aircraft's iron turns with the aircraft. @param sensor empty: level.
/// @param vanished  set where no horizontal field was left; what was read before stays.
[[nodiscard]] std::vector<double> sensorErrors(const Scenario& scenario, const Motion& motion, const std::vector<TurnedBy>& body,
    const std::vector<TurnedBy>& sensor, bool deviation, bool& vanished);

/// The card in its liquid [own]: ë + 2ζω(ė + ω_liquid) + ω² sin(e − e_m) = 0, τ_L ω̇_liquid = ψ̇ − ω_liquid; where it binds it turns with
/// the bowl. It begins at rest where the magnet points.
[[nodiscard]] std::vector<double> throughCard(const CardInLiquid& card, double step_s, const Motion& motion,
    const std::vector<TurnedBy>& body, const std::vector<TurnedBy>& sensor, const std::vector<double>& sensor_rad);

/// Drift of a gyro's reading at every point [rad/s].
[[nodiscard]] std::vector<double> driftOf(const Scenario& scenario, const HeadingGyro& gyro, const Motion& motion);
/// Gimbal error of the outer axis that is the body's z axis, tilted to starboard by what the gyro says.
[[nodiscard]] std::vector<double> gimbalErrors(const HeadingGyro& gyro, const Motion& motion, const std::vector<TurnedBy>& body);

/// Slaved: τ_s ė + e = e_m + τ_s d, no faster than its rate; free: ė = d. @param drift_rad_s empty: none.
[[nodiscard]] std::vector<double> throughGyro(const HeadingGyro& gyro, bool slaved, double step_s, const Motion& motion,
    const std::vector<double>& drift_rad_s, const std::vector<double>& sensor_rad);

} // namespace lubberline
