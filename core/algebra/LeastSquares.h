#pragma once
/// Linear least squares with a report, for the Smith fits and for harmonics of unequal headings.

#include <Eigen/Core>

namespace lubberline {

struct LeastSquares {
    Eigen::VectorXd solution;
    Eigen::MatrixXd inverseNormal; ///< (XᵀX)⁻¹: covariance of the solution for unit variance of the readings
    Eigen::VectorXd leverage;      ///< diagonal of X (XᵀX)⁻¹ Xᵀ
};

/// R of X = Q R, p×p. @param design N×p, N ≥ p
[[nodiscard]] Eigen::MatrixXd upperFactor(const Eigen::MatrixXd& design);

/// Singular values of X (N×p, N ≥ p), largest first, by QR and the singular values of R.
[[nodiscard]] Eigen::VectorXd singularValues(const Eigen::MatrixXd& design);

/// σ_max/σ_min of the leading `columns` of X; infinite when the rank is short.
[[nodiscard]] double conditionNumber(const Eigen::VectorXd& singularValues);

/// min |Xβ − y|² by Householder QR. X must be of full rank: check the condition number before.
[[nodiscard]] LeastSquares solveLeastSquares(const Eigen::MatrixXd& design, const Eigen::VectorXd& observed);

} // namespace lubberline
