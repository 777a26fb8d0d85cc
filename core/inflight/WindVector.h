#pragma once
/// The wind triangle: ground velocity = air velocity + wind, all as (east, north) in one unit.

#include <cmath>

#include <Eigen/Core>

#include "core/angle/Angle.h"
#include "core/angle/QuickAngle.h"

namespace lubberline {

/// Of a direction clockwise from north.
inline Eigen::Vector2d velocityOf(double direction_deg, double speed)
{
    const SineCosine direction = quickSineCosineOfDegrees(direction_deg);
    return {speed * direction.sine, speed * direction.cosine};
}
/// Where a velocity points, [0, 360).
inline double directionOf_deg(const Eigen::Vector2d& velocity) { return wrap360(toDegrees(std::atan2(velocity.x(), velocity.y()))); }
/// From one velocity to another, clockwise [deg].
inline double turnBetween_deg(const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
    return toDegrees(quickArctangent(from.y() * to.x() - from.x() * to.y(), from.dot(to)));
}
/// A velocity turned clockwise by a right angle.
inline Eigen::Vector2d rightOf(const Eigen::Vector2d& velocity) { return {velocity.y(), -velocity.x()}; }

} // namespace lubberline
