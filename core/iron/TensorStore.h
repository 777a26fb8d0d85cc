#pragma once
/// Tensors of parts near the sensor. A tensor does not know its scale: it is computed for a largest length of 1 on one of a few
/// grids, so that parts that are alike, and one part that is moved a little, share it.

#include <memory>

#include "core/iron/DemagnetisationTensor.h"

namespace lubberline {

/// Cells along a side of the grids of the bench: about 40 MB and a tenth of a second each.
inline constexpr int kBenchTensorCells = 64;

struct TensorKey {
    Shape shape;      ///< its largest length 1
    double reach = 0; ///< half the side of the grid, in largest lengths
    friend bool operator==(const TensorKey&, const TensorKey&) = default;
};

/// The grid for a place [m, the part's own axes] at least so far from the border that the tensor is good there.
[[nodiscard]] TensorKey tensorKey(const Shape& shape, const Eigen::Vector3d& place_m);

/// From the last few that were asked for, or computed. May be called from several threads. Errors: Cancelled.
Result<std::shared_ptr<const DemagnetisationTensor>> tensorFor(const TensorKey& key, const Progress& progress);

} // namespace lubberline
