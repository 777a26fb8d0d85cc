#pragma once
/// A levelled gyro carried through a flight: in linear reach by the exact step of each axis, with cut-off, limits and switches by short ones.

#include <memory>
#include <span>
#include <vector>

#include "core/reference/LevellingLoop.h"
#include "core/reference/Motion.h"

namespace lubberline {

/// σ along the heading: the gyro's axis (up) leans forward, to starboard.
struct AxisTilt {
    double forward_rad = 0, starboard_rad = 0;
};

/// Drift tilts the axis to starboard. A gyro comes to its stops at 90° from the vertical.
class VerticalRun {
public:
    VerticalRun(const Scenario& scenario, const VerticalGyro& gyro);
    ~VerticalRun();
    /// The tilts at the points that follow those before.
    void take(std::span<const MotionPoint> points, std::vector<AxisTilt>& tilt);
    [[nodiscard]] std::vector<Message> warnings() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

/// What drift and the rate of the true vertical leave for good in the flight with which the scenario begins, τ1(ω_D − θ̇) [rad]; what
/// tilts the apparent vertical itself (Coriolis) is not in it.
[[nodiscard]] AxisTilt standoffOf(const Scenario& scenario, const VerticalGyro& gyro);

} // namespace lubberline
