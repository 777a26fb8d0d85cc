#include "core/algebra/Spectra.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include <limits>

namespace lubberline {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

} // namespace

SymmetricParts symmetricParts(const MatrixView& matrix)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
    if (solver.info() != Eigen::Success)
        return {Eigen::VectorXd::Constant(matrix.rows(), kNone), Eigen::MatrixXd::Constant(matrix.rows(), matrix.rows(), kNone)};
    return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::VectorXd symmetricValues(const MatrixView& matrix)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix, Eigen::EigenvaluesOnly);
    return solver.info() == Eigen::Success ? solver.eigenvalues() : Eigen::VectorXd::Constant(matrix.rows(), kNone);
}

SingularParts singularParts(const MatrixView& matrix)
{
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
    return {svd.matrixU(), svd.matrixV(), svd.singularValues()};
}

std::optional<GeneralParts> generalParts(const MatrixView& matrix)
{
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(matrix);
    if (solver.info() != Eigen::Success)
        return {};
    return GeneralParts{solver.eigenvalues(), solver.eigenvectors()};
}

} // namespace lubberline
