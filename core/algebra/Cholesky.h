#pragma once
/// A = L Lᵀ, for whitening and for determinants.

#include "core/algebra/Matrices.h"

namespace lubberline {

/// L. @param a symmetric, positive definite: its lower half is looked at; not numbers where it is not definite.
[[nodiscard]] Eigen::MatrixXd choleskyFactor(const MatrixView& a);
/// L⁻¹ B. @param lower the lower half is looked at.
[[nodiscard]] Eigen::MatrixXd whitened(const MatrixView& lower, const MatrixView& b);

} // namespace lubberline
