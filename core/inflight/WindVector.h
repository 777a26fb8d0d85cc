#pragma once
/// The wind triangle: ground velocity = air velocity + wind, all as (east, north) in one unit.

#include <cmath>

#include <Eigen/Core>

#include "core/angle/Angle.h"

namespace lubberline {

/// Of a direction clockwise from north.
inline Eigen::Vector2d velocityOf(double direction_deg, double speed)
{
    const double direction_rad = toRadians(direction_deg);
    return {speed * std::sin(direction_rad), speed * std::cos(direction_rad)};
}
/// Where a velocity points, [0, 360).
inline double directionOf_deg(const Eigen::Vector2d& velocity) { return wrap360(toDegrees(std::atan2(velocity.x(), velocity.y()))); }
/// A velocity turned clockwise by a right angle.
inline Eigen::Vector2d rightOf(const Eigen::Vector2d& velocity) { return {velocity.y(), -velocity.x()}; }

} // namespace lubberline
