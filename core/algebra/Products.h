#pragma once
/// Products of matrices of any size that compile in no time.

#include "core/algebra/Matrices.h"

namespace lubberline {

/// A B.
[[nodiscard]] Eigen::MatrixXd product(const MatrixView& a, const MatrixView& b);
/// A M Aᵀ, of a symmetric M: how a covariance goes over to A x.
[[nodiscard]] Eigen::MatrixXd carried(const MatrixView& a, const MatrixView& m);
/// V diag(values) Vᵀ, of any V.
[[nodiscard]] Eigen::MatrixXd composed(const MatrixView& vectors, const VectorView& values);

} // namespace lubberline
