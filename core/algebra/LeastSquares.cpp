#include "core/algebra/LeastSquares.h"

#include <Eigen/QR>
#include <Eigen/SVD>

#include <limits>

namespace lubberline {

namespace {

Eigen::MatrixXd upperOf(const Eigen::HouseholderQR<Eigen::MatrixXd>& qr)
{
    return qr.matrixQR().topRows(qr.cols()).triangularView<Eigen::Upper>();
}

} // namespace

Eigen::MatrixXd upperFactor(const Eigen::MatrixXd& design) { return upperOf(Eigen::HouseholderQR<Eigen::MatrixXd>(design)); }

Eigen::VectorXd singularValues(const Eigen::MatrixXd& design)
{
    return Eigen::JacobiSVD<Eigen::MatrixXd>(upperFactor(design)).singularValues();
}

double conditionNumber(const Eigen::VectorXd& singularValues)
{
    const double smallest = singularValues(singularValues.size() - 1);
    return smallest > 0 ? singularValues(0) / smallest : std::numeric_limits<double>::infinity();
}

LeastSquares solveLeastSquares(const Eigen::MatrixXd& design, const Eigen::VectorXd& observed)
{
    const auto p = design.cols();
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(design);
    const Eigen::MatrixXd upper = upperOf(qr);
    const Eigen::MatrixXd inverseUpper = upper.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(p, p));
    const Eigen::VectorXd rotated = (qr.householderQ().adjoint() * observed).head(p);
    LeastSquares result;
    result.solution = inverseUpper * rotated;
    result.inverseNormal = inverseUpper * inverseUpper.transpose();
    result.leverage = (design * inverseUpper).rowwise().squaredNorm();
    return result;
}

} // namespace lubberline
