#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <numbers>

#include "core/algebra/Cholesky.h"
#include "core/algebra/Exponential.h"
#include "core/algebra/LeastSquares.h"
#include "core/algebra/Products.h"
#include "core/algebra/Solve.h"
#include "core/algebra/Spectra.h"

namespace lubberline {

namespace {

/// 1/(i + j − 1): its inverse is of whole numbers.
Eigen::MatrixXd hilbert(Eigen::Index n)
{
    return Eigen::MatrixXd::NullaryExpr(n, n, [](Eigen::Index i, Eigen::Index j) { return 1.0 / static_cast<double>(i + j + 1); });
}

/// Three columns of which the third is the sum of the others.
Eigen::MatrixXd shortOfRank()
{
    Eigen::MatrixXd a(4, 3);
    a << 1, 0, 1, 2, 1, 3, 0, 1, 1, 1, 1, 2;
    return a;
}

} // namespace

TEST(Algebra, theInverseOfHilbertsMatrixIsOfWholeNumbers)
{
    Eigen::Matrix3d expected;
    expected << 9, -36, 30, -36, 192, -180, 30, -180, 180; // Savage and Lukacs 1954
    EXPECT_LT((inversePositive(hilbert(3)) - expected).cwiseAbs().maxCoeff(), 1e-10);
    EXPECT_LT((*solveSquare(hilbert(3), Eigen::Matrix3d::Identity()) - expected).cwiseAbs().maxCoeff(), 1e-10);
    EXPECT_LT((pivotedSolve(hilbert(3), Eigen::Matrix3d::Identity()).solution - expected).cwiseAbs().maxCoeff(), 1e-10);
    EXPECT_LT((pseudoInverse(hilbert(3)) - expected).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(Algebra, whatIsShortOfRankIsToldAndSolvedByTheShortest)
{
    const Eigen::MatrixXd a = shortOfRank();
    const Eigen::Vector4d b(1, 2, 3, 4);
    EXPECT_EQ(pivotedSolve(a, b).rank, 2);
    EXPECT_FALSE(solveSquare(product(a.transpose(), a), Eigen::Matrix3d::Identity()));
    const Eigen::VectorXd shortest = leastNorm(a, b);
    EXPECT_LT((a.transpose() * (a * shortest - b)).norm(), 1e-12);    // least squares
    EXPECT_NEAR(shortest[0] + shortest[1] - shortest[2], 0.0, 1e-12); // nothing along (1, 1, −1), which changes nothing
    const Eigen::MatrixXd inverse = pseudoInverse(a);                 // the four conditions of Penrose
    EXPECT_LT((a * inverse * a - a).norm(), 1e-12);
    EXPECT_LT((inverse * a * inverse - inverse).norm(), 1e-12);
    EXPECT_LT((a * inverse - (a * inverse).transpose()).norm(), 1e-12);
    EXPECT_LT((inverse * a - (inverse * a).transpose()).norm(), 1e-12);
    EXPECT_LT((inverse * b - shortest).norm(), 1e-12);
}

TEST(Algebra, partsMakeTheMatrixAgain)
{
    const Eigen::MatrixXd symmetric = hilbert(5);
    const SymmetricParts parts = symmetricParts(symmetric);
    EXPECT_LT((composed(parts.vectors, parts.values) - symmetric).norm(), 1e-14);
    EXPECT_NEAR(parts.values[4], 1.5670506910982307, 1e-14); // of Hilbert's of order 5 (Todd 1954)
    EXPECT_NEAR(symmetricValues(symmetric)[0], 3.2879287721718e-06, 1e-15);
    const SingularParts singular = singularParts(shortOfRank());
    EXPECT_LT((singular.U.leftCols(3) * singular.values.asDiagonal() * singular.V.transpose() - shortOfRank()).norm(), 1e-13);
    EXPECT_NEAR(singularValues(shortOfRank())[2], 0.0, 1e-14);
}

TEST(Algebra, aQuarterTurnTurnsByItsExponentialAndItsPolesAreImaginary)
{
    Eigen::Matrix2d rate;
    rate << 0, -std::numbers::pi / 2, std::numbers::pi / 2, 0;
    const Eigen::MatrixXd turned = exponential(rate);
    EXPECT_NEAR(turned(0, 0), 0.0, 1e-15);
    EXPECT_NEAR(turned(1, 0), 1.0, 1e-15);
    const auto poles = generalParts(rate);
    ASSERT_TRUE(poles);
    EXPECT_NEAR(std::abs(poles->values[0].imag()), std::numbers::pi / 2, 1e-15);
    EXPECT_NEAR(poles->values[0].real(), 0.0, 1e-15);
}

TEST(Algebra, aCovarianceIsWhitenedByItsFactorAndOtherMatricesHaveNone)
{
    const Eigen::MatrixXd factor = choleskyFactor(hilbert(4));
    EXPECT_LT((product(factor, factor.transpose()) - hilbert(4)).norm(), 1e-15);
    const Eigen::MatrixXd white = whitened(factor, hilbert(4));
    EXPECT_LT((carried(whitened(factor, Eigen::Matrix4d::Identity()), hilbert(4)) - Eigen::Matrix4d::Identity()).norm(), 1e-11);
    EXPECT_LT((white - factor.transpose()).norm(), 1e-12);
    EXPECT_FALSE(choleskyFactor(-hilbert(4)).allFinite());
}

TEST(Algebra, whatIsNotANumberComesOutAsNone)
{
    Eigen::MatrixXd matrix = hilbert(3);
    matrix(1, 0) = std::nan("");
    EXPECT_FALSE(symmetricParts(matrix).values.allFinite());
    EXPECT_FALSE(symmetricValues(matrix).allFinite());
}

} // namespace lubberline
