#pragma once
/// A levelled gyro carried through a flight: in linear reach by the exact step of each axis, with cut-off, limits and switches by short ones.

#include <vector>

#include "core/reference/LevellingLoop.h"
#include "core/reference/Motion.h"

namespace lubberline {

/// σ along the heading: the gyro's axis (up) leans forward, to starboard.
struct AxisTilt {
    double forward_rad = 0, starboard_rad = 0;
};

struct VerticalRun {
    std::vector<AxisTilt> tilt; ///< one a point of the motion
    std::vector<Message> warnings;
};

/// Drift tilts the axis to starboard. A gyro comes to its stops at 90° from the vertical.
[[nodiscard]] VerticalRun verticalRun(const Scenario& scenario, const VerticalGyro& gyro, const Motion& motion);

/// What drift and the rate of the true vertical leave for good in the flight with which the scenario begins, τ1(ω_D − θ̇) [rad]; what
/// tilts the apparent vertical itself (Coriolis) is not in it.
[[nodiscard]] AxisTilt standoffOf(const Scenario& scenario, const VerticalGyro& gyro);

} // namespace lubberline
