#pragma once
/// Wind without a model: ground velocity = air velocity + wind, so with one airspeed the ground velocities of all headings lie on a circle
/// about the wind. Three directions determine wind and airspeed, and with them the heading from each track, without any compass.
/// Exact check: wind (8, −5) m/s, airspeed 60 m/s, headings 010/100/190/280.

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace lubberline {

struct GroundVelocity {
    double track_deg = 0, speed_kt = 0;
};

struct AirMass {
    Eigen::Vector2d toward_kt = Eigen::Vector2d::Zero();  ///< east, north: where the air moves to
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero(); ///< of it [kt²]; readings one after the other are not independent
    double airspeed_kt = 0;
    double airspeedError_kt = 0;
    double scatter_kt = 0; ///< of the speeds about the circle; 0 where three legs leave none
    [[nodiscard]] double speed_kt() const { return toward_kt.norm(); }
    [[nodiscard]] double from_deg() const; ///< where it comes from, true
    [[nodiscard]] double standardError_kt() const;
    [[nodiscard]] double drift_deg() const; ///< the most that it turns a track from the heading
};

struct AirMassOptions {
    std::size_t fewest = 4;    ///< velocities
    bool dropStrays = true;    ///< taking off, braking: no part of the turn
    double speedError_kt = 0;  ///< of a velocity, where it is known: errors are not less than it gives
    bool oneAfterOther = true; ///< in order of time, so that neighbours tell the same
};

/// None where the directions do not determine it.
[[nodiscard]] std::optional<AirMass> airMassOf(std::span<const GroundVelocity> velocities, const AirMassOptions& options = {});

/// The heading [deg, true] of an aircraft whose track over ground is this.
[[nodiscard]] double headingInWind_deg(const AirMass& air, double track_deg, double speed_kt);
/// What one knot of wind toward east and toward north more turns that heading by [deg].
[[nodiscard]] Eigen::Vector2d turnedByWind_deg(const AirMass& air, double track_deg, double speed_kt);

} // namespace lubberline
