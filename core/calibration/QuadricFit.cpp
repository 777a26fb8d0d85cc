#include "core/calibration/QuadricFit.h"

#include <Eigen/Core>
#include <cmath>

#include "core/algebra/Products.h"
#include "core/algebra/Solve.h"
#include "core/algebra/Spectra.h"

namespace lubberline {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// x², xy, xz, y², yz, z², x, y, z, 1.
constexpr std::array<std::array<int, 3>, 10> kMonomials{
    {{2, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 2, 0}, {0, 1, 1}, {0, 0, 2}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}};

/// Hermite's polynomials with variance v: E[t_k(x + noise)] = x^k. Factor of x^(k − 2j) v^j.
constexpr std::array<std::array<double, 3>, 5> kHermite{{{1, 0, 0}, {1, 0, 0}, {1, -1, 0}, {1, -3, 0}, {1, -6, 3}}};

/// Ψ(v) = Ψ₀ + v Ψ₁ + v² Ψ₂: the moment matrix of the points without their noise of variance v.
struct CorrectedMoments {
    std::array<MatrixXd, 3> power;
    [[nodiscard]] MatrixXd at(double v) const { return power[0] + v * (power[1] + v * power[2]); }
    [[nodiscard]] MatrixXd slope(double v) const { return power[1] + 2.0 * v * power[2]; }
};

std::array<double, 3> correctedMoment(const FieldMoments& moments, const std::array<int, 3>& e)
{
    std::array<double, 3> powers{};
    for (int i = 0; 2 * i <= e[0]; ++i)
        for (int j = 0; 2 * j <= e[1]; ++j)
            for (int k = 0; 2 * k <= e[2]; ++k) {
                const double factor = kHermite[static_cast<std::size_t>(e[0])][static_cast<std::size_t>(i)]
                    * kHermite[static_cast<std::size_t>(e[1])][static_cast<std::size_t>(j)]
                    * kHermite[static_cast<std::size_t>(e[2])][static_cast<std::size_t>(k)];
                if (i + j + k < 3)
                    powers[static_cast<std::size_t>(i + j + k)] += factor * moments.of(e[0] - 2 * i, e[1] - 2 * j, e[2] - 2 * k);
            }
    return powers;
}

CorrectedMoments correctedMoments(const FieldMoments& moments)
{
    CorrectedMoments corrected;
    corrected.power.fill(MatrixXd::Zero(10, 10));
    for (std::size_t i = 0; i < 10; ++i)
        for (std::size_t j = i; j < 10; ++j) {
            std::array<int, 3> e{};
            for (std::size_t axis = 0; axis < 3; ++axis)
                e[axis] = kMonomials[i][axis] + kMonomials[j][axis];
            const auto powers = correctedMoment(moments, e);
            for (std::size_t k = 0; k < 3; ++k) {
                const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(j);
                corrected.power[k](row, column) = corrected.power[k](column, row) = powers[k] / moments.points();
            }
        }
    return corrected;
}

/// The quadrics of a shape: which of the ten coefficients are free.
MatrixXd freeCoefficients(EllipsoidShape shape)
{
    if (shape == EllipsoidShape::General)
        return MatrixXd::Identity(10, 10);
    const bool sphere = shape == EllipsoidShape::Sphere;
    MatrixXd free = MatrixXd::Zero(10, sphere ? 5 : 7);
    for (int i = 0; i < 3; ++i)
        free((std::array{0, 3, 5})[static_cast<std::size_t>(i)], sphere ? 0 : i) = 1.0;
    for (int i = 0; i < 4; ++i)
        free(6 + i, (sphere ? 1 : 3) + i) = 1.0;
    return free;
}

std::optional<Quadric> quadricOf(const VectorXd& q, const FieldMoments& moments, double sigma)
{
    Eigen::Matrix3d a;
    a << q[0], q[1] / 2, q[2] / 2, q[1] / 2, q[3], q[4] / 2, q[2] / 2, q[4] / 2, q[5];
    const Eigen::Vector3d b(q[6], q[7], q[8]);
    const SymmetricParts axes = symmetricParts(a);
    const Eigen::Vector3d values = axes.values;
    const Eigen::Matrix3d directions = axes.vectors;
    if (!values.allFinite() || values.minCoeff() * values.maxCoeff() <= 0
        || values.cwiseAbs().minCoeff() < 1e-9 * values.cwiseAbs().maxCoeff())
        return {};
    const Eigen::Vector3d centre = -0.5 * directions * (directions.transpose() * b).cwiseQuotient(values);
    const double level = centre.dot(a * centre) - q[9];
    const Eigen::Vector3d scaled = values / level;
    if (!(scaled.minCoeff() > 0) || !scaled.allFinite())
        return {};
    Quadric quadric;
    quadric.centre = moments.centre + moments.scale * centre;
    quadric.toUnit = directions * scaled.cwiseSqrt().asDiagonal() * directions.transpose() / moments.scale;
    quadric.sigma = sigma * moments.scale;
    return quadric;
}

} // namespace

std::optional<Quadric> adjustedQuadric(const FieldMoments& moments, EllipsoidShape shape)
{
    const CorrectedMoments corrected = correctedMoments(moments);
    const MatrixXd free = freeCoefficients(shape);
    // The smallest eigenvalue falls with v, ever faster: Newton's steps come down on its first zero from above.
    double v = 0;
    VectorXd null;
    for (int step = 0; step < 60; ++step) {
        const SymmetricParts parts = symmetricParts(carried(free.transpose(), corrected.at(v)));
        if (!parts.values.allFinite())
            return {};
        null = parts.vectors.col(0);
        const double least = parts.values[0], slope = VectorXd(free * null).dot(corrected.slope(v) * VectorXd(free * null));
        if (!(slope < 0))
            break;
        const double next = std::max(0.0, v - least / slope);
        if (!std::isfinite(next) || std::abs(next - v) <= 1e-13 * std::max(next, 1e-6))
            break;
        v = next;
    }
    return quadricOf(free * null, moments, std::sqrt(std::max(0.0, v)));
}

std::optional<Quadric> constrainedQuadric(const FieldMoments& moments)
{
    const MatrixXd design = correctedMoments(moments).power[0];
    // q' C q = 4 J − I² > 0 for the six coefficients of second order: x², y², z² and half of yz, xz, xy.
    MatrixXd constraint = MatrixXd::Zero(6, 6);
    const std::array<Eigen::Index, 3> squares{0, 3, 5};
    for (const auto i : squares)
        for (const auto j : squares)
            constraint(i, j) = i == j ? -1.0 : 1.0;
    for (const Eigen::Index i : {1, 2, 4})
        constraint(i, i) = -1.0;
    const MatrixXd across = design.bottomLeftCorner(4, 6);
    const auto rest = solveSquare(design.bottomRightCorner(4, 4), across); // of the other four by the six
    if (!rest)
        return {};
    const MatrixXd reduced = design.topLeftCorner(6, 6) - product(across.transpose(), *rest);
    const auto inside = solveSquare(constraint, reduced);
    const auto parts = inside ? generalParts(*inside) : std::nullopt;
    if (!parts)
        return {};
    std::optional<Quadric> best;
    double largest = 0;
    for (Eigen::Index i = 0; i < 6; ++i) {
        if (std::abs(parts->values[i].imag()) > 1e-9 || parts->values[i].real() <= 0 || parts->values[i].real() <= largest)
            continue;
        const VectorXd second = parts->vectors.col(i).real();
        VectorXd q(10);
        q << second, -*rest * second;
        if (auto quadric = quadricOf(q, moments, 0.0)) {
            best = std::move(quadric);
            largest = parts->values[i].real();
        }
    }
    return best;
}

} // namespace lubberline
