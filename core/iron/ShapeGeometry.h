#pragma once
/// Sizes of shapes, and how they fill the cells of a grid. Metres, in the part's own axes, the origin at its centre.

#include <vector>

#include <Eigen/Core>

#include "core/iron/FerrousPart.h"

namespace lubberline {

[[nodiscard]] Eigen::Vector3d sizeOf(const Shape& shape); ///< full lengths of the box around it
[[nodiscard]] double largestLength_m(const Shape& shape);
[[nodiscard]] double volume_m3(const Shape& shape);
[[nodiscard]] bool contains(const Shape& shape, const Eigen::Vector3d& place_m); ///< its surface belongs to it
[[nodiscard]] Shape scaled(const Shape& shape, double factor);

/// The part of each cell of a cube of cells³ cells round the origin that the shape fills, 0…1; x slowest, z fastest. Chords
/// along z are exact, across them the cells are sampled; then cells on the surface are scaled so that the volume is exact.
[[nodiscard]] std::vector<float> fillOf(const Shape& shape, int cells, double cell_m);

} // namespace lubberline
