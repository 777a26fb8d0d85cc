#pragma once
/// The demagnetisation tensor of a uniform body on a grid, by FFT of its shape function:
///   N_ij(r) = (2π)⁻³ ∫ d³k F(k)/k² k_i k_j e^{ik·r}                                                          [P 8]
/// B of a body with uniform magnetisation M: outside −μ0 N(r) M, inside μ0 (1 − N(r)) M. Trace: 1 inside, 0 outside.

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/iron/DemagnetisingFactors.h"
#include "core/iron/FerrousPart.h"
#include "core/iron/FourierGrid.h"

namespace lubberline {

/// A cube of `cells`³ cubic cells round the origin of the part; zero-padded to twice that for the transforms.
struct TensorGrid {
    int cells = 64;
    double cell_m = 0.01;
};

/// Memory that the tensor of such a grid takes while it is computed [bytes]; the largest number there is where it cannot be
/// told.
[[nodiscard]] std::size_t memoryFor(const TensorGrid& grid);
/// Grids that would take more are refused before any memory is taken.
inline constexpr std::size_t kMostTensorMemory = std::size_t{4} << 30;
inline constexpr int kFewestTensorCells = 8;

/// On a padded grid the plain 1/k² feels the periodic images of the body (averages of a cube off by 0.01, 5 % of the dipole at
/// the grid's border). Here it is (1 − cos kR)/k², the transform of a 1/4πr cut off at R, half the side of the padded grid: no
/// image is within R, so the tensor is exact up to the cells' size wherever |r| + the body's half diagonal ≤ R. In zz the cut
/// comes in by the trace, which is taken to be the shape function. Measured on 64³ cells against the closed forms: averages of
/// the sphere, and of boxes whose faces lie between cells, within 5e-5, of all other bodies of 7 cells or more within 0.004; a
/// sphere of 10 cells in diameter or more agrees with its dipole within 1 % from two cells off its surface to three cells off
/// the border. In the cells that the surface cuts, and two beside them, the values are smeared between inside and outside.
struct DemagnetisationTensor {
    TensorGrid grid;
    std::vector<float> fill;                      ///< part of each cell that the body fills, 0…1; x slowest, z fastest
    std::array<std::vector<double>, 6> component; ///< xx, yy, zz, xy, xz, yz at the cells' centres, in the same order
    /// In the part's own axes, within the grid. By B-splines of degree 5 that smooth out the ringing of the transforms: on a
    /// harmonic function, as the tensor is off the surface, such a smoothing has no effect of second order.
    [[nodiscard]] Eigen::Matrix3d at(const Eigen::Vector3d& place_m) const;
    /// Over the body, with the jump n nᵀ of the tensor at the surface put back into the cells that the surface cuts. Trace 1.
    [[nodiscard]] Eigen::Matrix3d averageInside() const;
};

/// Errors: InvalidInput (sizes not > 0, fewer than 8 cells, body larger than the grid, grid too large: its size in MiB),
/// Cancelled.
Result<DemagnetisationTensor> demagnetisationTensor(const Shape& shape, const TensorGrid& grid, const Progress& progress = {});

} // namespace lubberline
