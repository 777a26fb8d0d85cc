#pragma once
/// Private to the ellipsoid: the quadric of a cloud of points from its moments.

#include <optional>

#include "core/calibration/Ellipsoid.h"
#include "core/calibration/FieldMoments.h"

namespace lubberline {

/// |V (u − centre)| = 1 in the unit of the points, V symmetric and positive definite.
struct Quadric {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    Eigen::Matrix3d toUnit = Eigen::Matrix3d::Identity();
    double sigma = 0; ///< noise of one axis that the adjustment found
};

/// Adjusted least squares. None where the quadric is no ellipsoid.
[[nodiscard]] std::optional<Quadric> adjustedQuadric(const FieldMoments& moments, EllipsoidShape shape);
/// Least squares under the constraint that it is an ellipsoid (Li and Griffiths 2004, GMP 335): always one, but with a bias.
[[nodiscard]] std::optional<Quadric> constrainedQuadric(const FieldMoments& moments);

} // namespace lubberline
