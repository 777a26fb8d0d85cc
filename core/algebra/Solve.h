#pragma once
/// Linear systems and least squares, of any size. For the few that run millions of times a second Eigen's own of fixed size stay better.

#include "core/algebra/Matrices.h"

#include <optional>

namespace lubberline {

/// A X = B by LDLᵀ. @param a symmetric, positive definite: its lower half is looked at; what it cannot tell comes out as 0.
[[nodiscard]] Eigen::MatrixXd solvePositive(const MatrixView& a, const MatrixView& b);
[[nodiscard]] Eigen::MatrixXd inversePositive(const MatrixView& a);

/// A X = B of a square matrix; nothing where it has no inverse to working precision.
[[nodiscard]] std::optional<Eigen::MatrixXd> solveSquare(const MatrixView& a, const MatrixView& b);

/// min |A X − B| by QR with column pivots; where the rank is short, some of the solutions.
struct PivotedSolution {
    Eigen::MatrixXd solution;
    Eigen::Index rank = 0;
};
[[nodiscard]] PivotedSolution pivotedSolve(const MatrixView& a, const MatrixView& b);

/// Of all that make |A X − B| least, the shortest.
[[nodiscard]] Eigen::MatrixXd leastNorm(const MatrixView& a, const MatrixView& b);
/// Moore and Penrose's inverse.
[[nodiscard]] Eigen::MatrixXd pseudoInverse(const MatrixView& a);

} // namespace lubberline
