#include "core/algebra/Cholesky.h"

#include <Eigen/Cholesky>
#include <limits>

namespace lubberline {

Eigen::MatrixXd choleskyFactor(const MatrixView& a)
{
    const Eigen::LLT<Eigen::MatrixXd> factor(a);
    if (factor.info() != Eigen::Success)
        return Eigen::MatrixXd::Constant(a.rows(), a.cols(), std::numeric_limits<double>::quiet_NaN());
    return factor.matrixL();
}

Eigen::MatrixXd whitened(const MatrixView& lower, const MatrixView& b) { return lower.triangularView<Eigen::Lower>().solve(b); }

} // namespace lubberline
