#include "core/algebra/Solve.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>

namespace lubberline {

Eigen::MatrixXd solvePositive(const MatrixView& a, const MatrixView& b) { return a.ldlt().solve(b); }

Eigen::MatrixXd inversePositive(const MatrixView& a) { return a.ldlt().solve(Eigen::MatrixXd::Identity(a.rows(), a.cols())); }

std::optional<Eigen::MatrixXd> solveSquare(const MatrixView& a, const MatrixView& b)
{
    const Eigen::FullPivLU<Eigen::MatrixXd> solver(a);
    if (!solver.isInvertible())
        return {};
    return solver.solve(b);
}

PivotedSolution pivotedSolve(const MatrixView& a, const MatrixView& b)
{
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(a);
    return {solver.solve(b), solver.rank()};
}

} // namespace lubberline
