#include "core/reference/DirectionalGyro.h"

#include <cmath>

#include "core/reference/Scenario.h"

namespace lubberline {

double gimbalError_rad(MagneticHeading heading, SensorTilt outerAxis, double spinAxis_rad)
{
    const double azimuth = heading.radians() - spinAxis_rad;
    const double east = std::cos(outerAxis.roll_rad) * std::sin(azimuth)
        - std::sin(outerAxis.roll_rad) * std::sin(outerAxis.pitch_rad) * std::cos(azimuth);
    const double north = std::cos(outerAxis.pitch_rad) * std::cos(azimuth);
    return std::remainder(std::atan2(east, north) - azimuth, 2 * kPi);
}

double largestGimbalError_rad(double tilt_rad)
{
    const double half = std::tan(tilt_rad / 2);
    return std::asin(std::fmin(1.0, half * half));
}

double apparentDrift_rad_s(double latitude_rad, double eastward_m_s)
{
    return -(kEarthRate_rad_s * std::sin(latitude_rad) + eastward_m_s * std::tan(latitude_rad) / kMeanEarthRadius_m);
}

double slavingStandoff_rad(double tau_s, double drift_rad_s) { return tau_s * drift_rad_s; }

double slavingGain(double tau_s, double frequency_rad_s) { return 1 / std::hypot(1.0, frequency_rad_s * tau_s); }

} // namespace lubberline
