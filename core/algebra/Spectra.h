#pragma once
/// Eigenvalues and singular values, of matrices of any size. For the few that run millions of times a second Eigen's own of fixed size stay
/// better.

#include "core/algebra/Matrices.h"

#include <optional>

namespace lubberline {

/// A = V diag(values) Vᵀ.
struct SymmetricParts {
    Eigen::VectorXd values;  ///< ascending; not numbers where the matrix holds none
    Eigen::MatrixXd vectors; ///< as columns, orthonormal
};

/// @param matrix symmetric: its lower half is looked at.
[[nodiscard]] SymmetricParts symmetricParts(const MatrixView& matrix);
/// Without the vectors.
[[nodiscard]] Eigen::VectorXd symmetricValues(const MatrixView& matrix);

/// A = U diag(values) Vᵀ, values descending, U and V square.
struct SingularParts {
    Eigen::MatrixXd U, V;
    Eigen::VectorXd values;
};
[[nodiscard]] SingularParts singularParts(const MatrixView& matrix);

/// A x = value x, of a square matrix that is not symmetric; nothing where the iteration does not settle.
struct GeneralParts {
    Eigen::VectorXcd values;  ///< in no order
    Eigen::MatrixXcd vectors; ///< as columns
};
[[nodiscard]] std::optional<GeneralParts> generalParts(const MatrixView& matrix);

} // namespace lubberline
