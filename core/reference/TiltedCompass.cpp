#include "core/reference/TiltedCompass.h"

#include <cmath>

#include "core/reference/Scenario.h"
#include "core/sensor/Attitude.h"

namespace lubberline {

double tiltError_rad(MagneticHeading heading, SensorTilt tilt, double dip_rad)
{
    const Eigen::Vector3d field
        = rotation(tilt.roll_rad, tilt.pitch_rad, heading.radians()) * Eigen::Vector3d(std::cos(dip_rad), 0, std::sin(dip_rad));
    if (field.head<2>().norm() < 1e-12)
        return 0;
    return std::remainder(std::atan2(-field.y(), field.x()) - heading.radians(), 2 * kPi);
}

double smallTiltError_rad(MagneticHeading heading, SensorTilt tilt, double dip_rad)
{
    return -(tilt.roll_rad * std::cos(heading.radians()) - tilt.pitch_rad * std::sin(heading.radians())) * std::tan(dip_rad);
}

HeadingAndDip headingAndDipOf(const Eigen::Vector3d& bodyField, SensorTilt attitude)
{
    const Eigen::Vector3d level = rotation(attitude.roll_rad, attitude.pitch_rad, 0).transpose() * bodyField;
    return {MagneticHeading::fromRadians(std::atan2(-level.y(), level.x())), std::atan2(level.z(), level.head<2>().norm())};
}

SensorTilt hangingTilt(double forward_m_s2, double starboard_m_s2, double up_m_s2)
{
    const double gravity = kGravity_m_s2 + up_m_s2;
    return {-std::atan2(forward_m_s2, gravity), std::atan2(starboard_m_s2, std::hypot(forward_m_s2, gravity))};
}

} // namespace lubberline
