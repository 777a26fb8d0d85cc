#include "core/fleet/SwingCurve.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "core/algebra/Spectra.h"
#include "core/base/Contract.h"
#include "core/deviation/SmithFit.h"
#include "core/deviation/ToldCoefficients.h"

namespace lubberline {

namespace {

constexpr std::size_t kFive = kCoefficientCount;
using Matrix5 = std::array<std::array<double, kFive>, kFive>;
using Five = std::array<std::size_t, kFive>;

struct NormalEquations {
    Matrix5 matrix{}; ///< upper triangle
    FiveTerms right{};
    double squares = 0;    ///< Σ δ²
    double sinSquares = 0; ///< max sin² 2z
    double cosSquares = 0; ///< max cos² 2z
};

/// Cholesky of the picked rows and columns in place of a library call: 5×5, no memory taken. @return false where it is singular
bool invert(const Matrix5& whole, const Five& picked, std::size_t n, Matrix5& inverse)
{
    Matrix5 lower{}, back{};
    for (std::size_t j = 0; j < n; ++j) {
        double diagonal = whole[picked[j]][picked[j]];
        for (std::size_t k = 0; k < j; ++k)
            diagonal -= lower[j][k] * lower[j][k];
        if (!(diagonal > 1e-12 * whole[picked[j]][picked[j]]))
            return false;
        lower[j][j] = std::sqrt(diagonal);
        for (std::size_t i = j + 1; i < n; ++i) {
            double sum = whole[picked[j]][picked[i]];
            for (std::size_t k = 0; k < j; ++k)
                sum -= lower[i][k] * lower[j][k];
            lower[i][j] = sum / lower[j][j];
        }
    }
    for (std::size_t j = 0; j < n; ++j) { // L⁻¹
        back[j][j] = 1.0 / lower[j][j];
        for (std::size_t i = j + 1; i < n; ++i) {
            double sum = 0;
            for (std::size_t k = j; k < i; ++k)
                sum -= lower[i][k] * back[k][j];
            back[i][j] = sum / lower[i][i];
        }
    }
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i; j < n; ++j) {
            double sum = 0;
            for (std::size_t k = j; k < n; ++k)
                sum += back[k][i] * back[k][j];
            inverse[picked[i]][picked[j]] = inverse[picked[j]][picked[i]] = sum;
        }
    return true;
}

double squaredNorm(const Matrix5& matrix, const Five& picked, std::size_t n)
{
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i; j < n; ++j)
            sum += (i == j ? 1 : 2) * matrix[picked[i]][picked[j]] * matrix[picked[i]][picked[j]];
    return sum;
}

/// Frobenius norms bound the condition from both sides; only between the bounds the eigenvalues are asked for.
bool wellConditioned(const Matrix5& matrix, const Matrix5& inverse, const Five& picked, std::size_t n)
{
    constexpr double limit = kConditionLimit * kConditionLimit; // of XᵀX
    const double product = std::sqrt(squaredNorm(matrix, picked, n) * squaredNorm(inverse, picked, n));
    if (product <= limit)
        return true;
    if (product > limit * static_cast<double>(n))
        return false;
    Eigen::MatrixXd part(n, n);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
            part(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = matrix[picked[std::min(i, j)]][picked[std::max(i, j)]];
    const Eigen::VectorXd values = symmetricValues(part);
    return values[static_cast<Eigen::Index>(n) - 1] <= limit * values[0];
}

bool solve(const NormalEquations& sums, const Five& picked, std::size_t n, SwingCurve& curve)
{
    if (static_cast<std::size_t>(curve.readings) < n)
        return false;
    Matrix5 inverse{};
    if (!invert(sums.matrix, picked, n, inverse) || !wellConditioned(sums.matrix, inverse, picked, n))
        return false;
    curve.inverse = inverse;
    curve.parameters = static_cast<std::int32_t>(n);
    for (std::size_t i = 0; i < n; ++i) {
        curve.knownBits = static_cast<std::uint8_t>(curve.knownBits | 1U << picked[i]);
        for (std::size_t j = 0; j < n; ++j)
            curve.value_deg[picked[i]] += inverse[picked[i]][picked[j]] * sums.right[picked[j]];
    }
    return true;
}

/// With D unknown, E of the cardinals carries tan(2·distance) of it: a fifth at 5.7° from them is still told as E.
constexpr double kNearPoint = 0.2 * 0.2;

bool solveWhatTheHeadingsTell(const NormalEquations& sums, SwingCurve& curve)
{
    constexpr Five all{0, 1, 2, 3, 4}, cardinals{0, 1, 2, 4, 0};
    if (solve(sums, all, 5, curve))
        return true;
    if (sums.sinSquares < kNearPoint && solve(sums, cardinals, 4, curve))
        return true;
    if (sums.cosSquares < kNearPoint && solve(sums, all, 4, curve))
        return true;
    return solve(sums, all, 3, curve);
}

double deviation_deg(double magnetic_deg, double compass_deg)
{
    double deviation = magnetic_deg - compass_deg; // both within [0, 360)
    if (deviation > 180.0)
        deviation -= 360.0;
    else if (deviation <= -180.0)
        deviation += 360.0;
    return deviation;
}

bool isFarOut(std::span<const double> magnetic_deg, std::span<const double> compass_deg)
{
    std::vector<Observation> readings;
    for (std::size_t r = 0; r < magnetic_deg.size(); ++r)
        readings.push_back({MagneticHeading::fromDegrees(magnetic_deg[r]), CompassHeading::fromDegrees(compass_deg[r])});
    return largeIndex_deg(readings) != 0.0;
}

} // namespace

FiveTerms termsAt(double compass_deg)
{
    const double z = toRadians(compass_deg), s = std::sin(z), c = std::cos(z);
    return {1.0, s, c, 2 * s * c, c * c - s * s};
}

SwingCurve fitCurve(std::span<const double> magnetic_deg, std::span<const double> compass_deg)
{
    LUBBERLINE_EXPECT(magnetic_deg.size() == compass_deg.size(), "a reading has both headings");
    SwingCurve curve;
    curve.readings = static_cast<std::int32_t>(magnetic_deg.size());
    NormalEquations sums;
    for (std::size_t r = 0; r < magnetic_deg.size(); ++r) {
        const FiveTerms x = termsAt(compass_deg[r]);
        const double deviation = deviation_deg(magnetic_deg[r], compass_deg[r]);
        for (std::size_t i = 0; i < kFive; ++i) {
            for (std::size_t j = i; j < kFive; ++j)
                sums.matrix[i][j] += x[i] * x[j];
            sums.right[i] += x[i] * deviation;
        }
        sums.sinSquares = std::max(sums.sinSquares, x[3] * x[3]);
        sums.cosSquares = std::max(sums.cosSquares, x[4] * x[4]);
        curve.maxAbs_deg = std::max(curve.maxAbs_deg, std::abs(deviation));
        sums.squares += deviation * deviation;
    }
    curve.farOut = curve.maxAbs_deg > kLargeIndex_deg && isFarOut(magnetic_deg, compass_deg);
    if (curve.readings < 3 || curve.farOut || !solveWhatTheHeadingsTell(sums, curve))
        return curve;
    // Σδ² − βᵀXᵀδ: below the digits that are left the readings lie on the curve
    double residual = sums.squares;
    for (std::size_t i = 0; i < kFive; ++i)
        residual -= curve.value_deg[i] * sums.right[i];
    curve.residualSquares_deg2 = residual > 1e-12 * sums.squares && curve.degreesOfFreedom() > 0 ? residual : 0.0;
    return curve;
}

double curveAtCompass_deg(const FiveTerms& value, double compass_deg)
{
    const FiveTerms x = termsAt(compass_deg);
    return value[0] + value[1] * x[1] + value[2] * x[2] + value[3] * x[3] + value[4] * x[4];
}

CurvePoint curveAtMagnetic(const FiveTerms& value, double magnetic_deg)
{
    double compass = magnetic_deg;
    for (int round = 0; round < 20; ++round) {
        const FiveTerms x = termsAt(compass);
        const double deviation = value[0] + value[1] * x[1] + value[2] * x[2] + value[3] * x[3] + value[4] * x[4];
        const double slope = value[1] * x[2] - value[2] * x[1] + 2 * (value[3] * x[4] - value[4] * x[3]);
        const double step = (compass + deviation - magnetic_deg) / std::max(0.2, 1.0 + toRadians(slope)); // no further where it folds
        compass -= step;
        if (std::abs(step) < 1e-7)
            break;
    }
    return {curveAtCompass_deg(value, compass), compass};
}

double curveVariance(const SwingCurve& curve, double compass_deg)
{
    const FiveTerms x = termsAt(compass_deg);
    double sum = 0;
    for (std::size_t i = 0; i < kFive; ++i) {
        double row = 0;
        for (std::size_t j = 0; j < kFive; ++j)
            row += curve.inverse[i][j] * x[j];
        sum += row * x[i];
    }
    return sum;
}

double largestOf_deg(const FiveTerms& value)
{
    static const auto terms = [] {
        std::array<FiveTerms, 36> half{}; // the other half has the signs of the first order turned
        for (std::size_t i = 0; i < half.size(); ++i)
            half[i] = termsAt(5.0 * static_cast<double>(i));
        return half;
    }();
    double largest = 0;
    for (const auto& x : terms) {
        const double even = value[0] + value[3] * x[3] + value[4] * x[4], odd = value[1] * x[1] + value[2] * x[2];
        largest = std::max(largest, std::abs(even) + std::abs(odd));
    }
    return largest;
}

} // namespace lubberline
