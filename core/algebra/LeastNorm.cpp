#include "core/algebra/Solve.h"

#include <Eigen/QR>

namespace lubberline {

namespace {

using Decomposition = Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>;

} // namespace

Eigen::MatrixXd leastNorm(const MatrixView& a, const MatrixView& b) { return Decomposition(a).solve(b); }

Eigen::MatrixXd pseudoInverse(const MatrixView& a) { return Decomposition(a).pseudoInverse(); }

} // namespace lubberline
