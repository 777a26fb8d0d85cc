#pragma once
/// What a tilted magnetic sensor reads as if it were level [K 9.12–9.17].

#include <Eigen/Core>

#include "core/angle/Heading.h"
#include "core/earth/EarthField.h"

namespace lubberline {

/// How a sensor or card is out of the horizontal, in axes along the heading.
struct SensorTilt {
    double pitch_rad = 0; ///< θ, nose up positive
    double roll_rad = 0;  ///< φ, starboard down positive
};

/// tan(read) = −starboard/forward of the field Rx(φ)Ry(θ)Rz(ψ)(cos γ, 0, sin γ) [K 9.13, 9.17], exact. @return read − true [rad],
/// (−π, π]. Where the field stands upright on the sensor nothing is read: 0.
[[nodiscard]] double tiltError_rad(MagneticHeading heading, SensorTilt tilt, double dip_rad);
/// −(φ cos ψ − θ sin ψ) tan γ: the same for small tilts (the book prints it with deviation's sign, problem 9.6).
[[nodiscard]] double smallTiltError_rad(MagneticHeading heading, SensorTilt tilt, double dip_rad);
/// Magnetic heading and dip out of the body field and the true attitude [K 9.14–9.15].
struct HeadingAndDip {
    MagneticHeading heading;
    double dip_rad = 0;
};
[[nodiscard]] HeadingAndDip headingAndDipOf(const Eigen::Vector3d& bodyField, SensorTilt attitude);

/// What hangs freely levels to the apparent vertical: φ = atan(a_starboard/g) in a coordinated turn (the bank), θ = −atan(a_forward/g).
[[nodiscard]] SensorTilt hangingTilt(double forward_m_s2, double starboard_m_s2, double up_m_s2);

} // namespace lubberline
