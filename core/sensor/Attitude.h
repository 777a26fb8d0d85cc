#pragma once
/// Attitude, and the rotations of docs/model.md, "The Earth's field on the aircraft" [P 14–15, K 9.13].
/// Body axes: x forward, y starboard, z down. Earth axes: magnetic north, magnetic east, down.

#include <Eigen/Core>

#include "core/angle/Heading.h"
#include "core/earth/EarthField.h"

namespace lubberline {

struct Attitude {
    MagneticHeading heading;
    double pitch_rad = 0; ///< θ, nose up positive
    double roll_rad = 0;  ///< φ, starboard wing down positive
};

/// Rx(φ) Ry(θ) Rz(ψ): turns Earth axes into body axes.
[[nodiscard]] Eigen::Matrix3d rotation(double roll_rad, double pitch_rad, double yaw_rad);
/// B_body = Rx(φ) Ry(θ) Rz(ψ) · (H, 0, Z).
[[nodiscard]] Eigen::Vector3d fieldInBody(const MeridianField& field, const Attitude& attitude);

} // namespace lubberline
