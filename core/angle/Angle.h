#pragma once
/// Degrees, radians and wrapping of bare angles. Headings and deviations have types of their own: Heading.h.

#include <cmath>
#include <numbers>

namespace lubberline {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kRadiansPerDegree = kPi / 180.0;
inline constexpr double kDegreesPerRadian = 180.0 / kPi;

constexpr double toRadians(double angle_deg) { return angle_deg * kRadiansPerDegree; }
constexpr double toDegrees(double angle_rad) { return angle_rad * kDegreesPerRadian; }

/// Wraps to [0, 360) degrees. Exact for whole turns: 360 gives 0, and no rounding is added to what is in range.
inline double wrap360(double angle_deg)
{
    const double wrapped = std::fmod(angle_deg, 360.0);
    if (wrapped >= 0.0)
        return wrapped + 0.0; // turns −0 into 0
    const double turned = wrapped + 360.0;
    return turned < 360.0 ? turned : 0.0; // −1e-20 would round up to 360
}

/// Wraps to (−180, 180] degrees.
inline double wrap180(double angle_deg)
{
    const double wrapped = std::remainder(angle_deg, 360.0);
    return wrapped <= -180.0 ? 180.0 : wrapped + 0.0;
}

} // namespace lubberline
