#pragma once
/// Readings held against what is possible: Gaussian for each possibility, exact, with the weight that the readings give it.
///   A = I + √V G √V, G = XᵀX/s², b = Xᵀr/s²: log weight += −½ log|A| + ½ (√V b)ᵀ A⁻¹ (√V b); mean √V A⁻¹ √V b, covariance √V A⁻¹ √V

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace lubberline {

/// What readings say of the changes of so many coefficients.
template <int size>
struct Readings {
    using Vector = Eigen::Matrix<double, size, 1>;
    using Matrix = Eigen::Matrix<double, size, size>;
    /// @param row  what the reading shows of each, @param residual_deg  read − card, with this standard error.
    void take(const Vector& row, double residual_deg, double error_deg)
    {
        information += row * row.transpose() / (error_deg * error_deg);
        weighted += row * residual_deg / (error_deg * error_deg);
    }
    Matrix information = Matrix::Zero(); ///< G
    Vector weighted = Vector::Zero();    ///< b
};

template <int size>
struct Conditioned {
    double logWeight = 0;
    Eigen::Matrix<double, size, 1> mean;
    Eigen::Matrix<double, size, size> root; ///< L of the covariance L Lᵀ
};

/// @param variance the diagonal V.
template <int size>
[[nodiscard]] Conditioned<size> conditionedOn(const Readings<size>& readings, const Eigen::Matrix<double, size, 1>& variance)
{
    using Matrix = Eigen::Matrix<double, size, size>;
    const Eigen::Matrix<double, size, 1> spread = variance.cwiseSqrt();
    const Matrix A = Matrix::Identity() + spread.asDiagonal() * readings.information * spread.asDiagonal();
    const Eigen::LLT<Matrix> factor(A);
    const Matrix L = factor.matrixL();
    const Eigen::Matrix<double, size, 1> scaled = spread.cwiseProduct(readings.weighted), solved = factor.solve(scaled);
    // (L Lᵀ)⁻¹ = L⁻ᵀ L⁻¹.
    Matrix inverse = Matrix::Identity();
    L.transpose().template triangularView<Eigen::Upper>().solveInPlace(inverse);
    return {scaled.dot(solved) / 2 - L.diagonal().array().log().sum(), spread.cwiseProduct(solved), spread.asDiagonal() * inverse};
}

} // namespace lubberline
