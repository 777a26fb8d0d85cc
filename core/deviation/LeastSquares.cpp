#include "core/deviation/LeastSquares.h"

#include <Eigen/QR>
#include <Eigen/SVD>

#include <limits>

namespace lubberline {

namespace {

using Upper = Eigen::MatrixXd;

Upper upperFactor(const Eigen::MatrixXd& design, Eigen::HouseholderQR<Eigen::MatrixXd>& qr)
{
    qr.compute(design);
    const auto p = design.cols();
    return qr.matrixQR().topRows(p).triangularView<Eigen::Upper>();
}

} // namespace

Eigen::VectorXd singularValues(const Eigen::MatrixXd& design)
{
    Eigen::HouseholderQR<Eigen::MatrixXd> qr;
    const Upper upper = upperFactor(design, qr);
    return Eigen::JacobiSVD<Eigen::MatrixXd>(upper).singularValues();
}

double conditionNumber(const Eigen::VectorXd& singularValues)
{
    const double smallest = singularValues(singularValues.size() - 1);
    return smallest > 0 ? singularValues(0) / smallest : std::numeric_limits<double>::infinity();
}

LeastSquares solveLeastSquares(const Eigen::MatrixXd& design, const Eigen::VectorXd& observed)
{
    const auto p = design.cols();
    Eigen::HouseholderQR<Eigen::MatrixXd> qr;
    const Upper upper = upperFactor(design, qr);
    const Eigen::MatrixXd inverseUpper = upper.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(p, p));
    const Eigen::VectorXd rotated = (qr.householderQ().adjoint() * observed).head(p);
    LeastSquares result;
    result.solution = inverseUpper * rotated;
    result.inverseNormal = inverseUpper * inverseUpper.transpose();
    result.leverage = (design * inverseUpper).rowwise().squaredNorm();
    return result;
}

} // namespace lubberline
