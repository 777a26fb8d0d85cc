#pragma once
/// How well the directions of the field in the sensor's axes cover the sphere, and where to turn to fill the largest hole.

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/base/Message.h"

namespace lubberline {

struct Coverage {
    double share = 0;                              ///< of 200 cells of equal area, those that hold samples
    double largestGap_deg = 0;                     ///< radius of the largest empty cap
    Eigen::Vector3d gap = Eigen::Vector3d::Zero(); ///< its middle: a direction in body axes
    Message turnTo;                                ///< which part of the sensor to point along the field
};

/// @param directions unit vectors
[[nodiscard]] Coverage coverageOf(std::span<const Eigen::Vector3d> directions);

/// "the nose, with the starboard side a little": a direction of body axes in words.
[[nodiscard]] Message bodyDirection(const Eigen::Vector3d& direction);

} // namespace lubberline
