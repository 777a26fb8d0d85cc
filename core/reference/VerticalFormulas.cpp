#include "core/reference/VerticalFormulas.h"

#include <cmath>

#include "core/reference/Scenario.h"

namespace lubberline {

double apparentTilt_rad(double horizontal, double upward, double gravity) { return std::atan2(horizontal, gravity + upward); }

double constantLatitudeTilt_rad(double speed_m_s, double latitude_rad, double gravity_m_s2)
{
    return speed_m_s * speed_m_s * std::tan(latitude_rad) / (gravity_m_s2 * kEarthRadius_m);
}

double coriolis_m_s2(double speed_m_s, double latitude_rad) { return 2 * kEarthRate_rad_s * speed_m_s * std::sin(latitude_rad); }

double turnRateErrorTilt_rad(double speed_m_s, double turnRateError_rad_s, double gravity_m_s2)
{
    return speed_m_s * turnRateError_rad_s / gravity_m_s2;
}

double transportRate_rad_s(double speed_m_s) { return speed_m_s / kEarthRadius_m; }

double torquePerTilt(double angularMomentum, double tau1_s) { return angularMomentum / tau1_s; }

double axialShift_cm(double drift_rad_s_g, double angularMomentum, double mass_g)
{
    return drift_rad_s_g * angularMomentum / (mass_g * kGravity_m_s2 * 100);
}

} // namespace lubberline
