#include "core/algebra/Products.h"

namespace lubberline {

Eigen::MatrixXd product(const MatrixView& a, const MatrixView& b) { return a * b; }

Eigen::MatrixXd carried(const MatrixView& a, const MatrixView& m)
{
    const Eigen::MatrixXd half = a * m;
    return half * a.transpose();
}

Eigen::MatrixXd composed(const MatrixView& vectors, const VectorView& values)
{
    const Eigen::MatrixXd half = vectors * values.asDiagonal();
    return half * vectors.transpose();
}

} // namespace lubberline
