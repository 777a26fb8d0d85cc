#pragma once
/// Wind in a turn: ground velocity = air velocity + wind, so with one airspeed the ground velocities of all headings lie on a circle
/// about the wind. Three directions determine wind and airspeed, and with them the heading from each track, without any compass.
/// Exact check: wind (8, −5) m/s, airspeed 60 m/s, headings 010/100/190/280.

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/nmea/HeadingLine.h"

namespace lubberline {

struct NmeaWind {
    Eigen::Vector2d toward_kt = Eigen::Vector2d::Zero();  ///< east, north: where the air moves to
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero(); ///< of it [kt²]; readings one after the other are not independent
    double airspeed_kt = 0;
    double scatter_kt = 0; ///< of the speeds about the circle
    bool takenOut = false;
    [[nodiscard]] double speed_kt() const { return toward_kt.norm(); }
    [[nodiscard]] double from_deg() const; ///< where it comes from, true
    [[nodiscard]] double standardError_kt() const;
    [[nodiscard]] double drift_deg() const; ///< the most that it turns a track from the heading
};

/// @param tracks in order of time; those without speed or track are passed over. None where the directions do not determine it.
[[nodiscard]] std::optional<NmeaWind> windOf(std::span<const TimedHeading> tracks);

/// The heading [deg, true] of an aircraft whose track over ground is this.
[[nodiscard]] double headingInWind_deg(const NmeaWind& wind, double track_deg, double speed_kt);
/// What one knot of wind toward east and toward north more turns that heading by [deg].
[[nodiscard]] Eigen::Vector2d turnedByWind_deg(const NmeaWind& wind, double track_deg, double speed_kt);

} // namespace lubberline
