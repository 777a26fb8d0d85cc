#include "core/swing/LackOfFit.h"

#include <algorithm>
#include <cmath>

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>

#include "core/algebra/LeastSquares.h"
#include "core/base/Number.h"
#include "core/deviation/ToldCoefficients.h"

namespace lubberline {

namespace {

constexpr double kLeast_deg = 0.3;   ///< a smaller harmonic changes no card
constexpr double kScatter_deg = 1.5; ///< more than swaying cards and tired eyes
constexpr std::size_t kLog = 200;    ///< readings of a log are not independent: no F test there

std::string tenths(double angle_rad) { return figureText(toDegrees(angle_rad), 1); }

/// Amplitude of the third harmonic [rad] in what a fit leaves, where the orders beyond the second are more than chance.
std::optional<double> higherHarmonics_rad(std::span<const Observation> readings, const std::vector<double>& residual_rad)
{
    const auto n = static_cast<Eigen::Index>(readings.size());
    const Eigen::Index orders = n >= 12 ? 4 : 3, columns = 2 * orders + 1;
    Eigen::MatrixXd design(n, columns);
    Eigen::VectorXd observed(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const auto& reading = readings[static_cast<std::size_t>(i)];
        design(i, 0) = 1.0;
        for (Eigen::Index k = 1; k <= orders; ++k) {
            design(i, 2 * k - 1) = std::sin(static_cast<double>(k) * reading.compass.radians());
            design(i, 2 * k) = std::cos(static_cast<double>(k) * reading.compass.radians());
        }
        observed(i) = residual_rad[static_cast<std::size_t>(i)];
    }
    if (conditionNumber(singularValues(design)) > kConditionLimit)
        return std::nullopt;
    const auto squares = [&](Eigen::Index p) {
        return (observed - design.leftCols(p) * solveLeastSquares(design.leftCols(p), observed).solution).squaredNorm();
    };
    const Eigen::VectorXd solution = solveLeastSquares(design, observed).solution;
    const double with = (observed - design * solution).squaredNorm(), without = squares(5);
    const double more = static_cast<double>(columns - 5), freedom = static_cast<double>(n - columns);
    if (!(with > 1e-18)) // computed curves: rounding is no scatter to test against
        return std::nullopt;
    const double ratio = (without - with) / more / (with / freedom);
    const double amplitude = std::hypot(solution(5), solution(6));
    const bool chance = ratio <= boost::math::quantile(boost::math::fisher_f(more, freedom), 0.99);
    return chance || toDegrees(amplitude) < kLeast_deg ? std::nullopt : std::optional(amplitude);
}

/// Whether readings of that error leave such a scatter in one swing of twenty or more.
bool explained(const SmithFitReport& fit, double readingError_rad)
{
    if (fit.degreesOfFreedom < 1 || readingError_rad <= 0.0)
        return false;
    const double squares = *fit.sigma_rad * *fit.sigma_rad * fit.degreesOfFreedom / (readingError_rad * readingError_rad);
    return squares <= boost::math::quantile(boost::math::chi_squared(fit.degreesOfFreedom), 0.95);
}

} // namespace

std::optional<LackOfFit> lackOfFit(
    std::span<const Observation> readings, const ApproximateFit& approximate, const ExactFit& exact, double readingError_rad)
{
    if (approximate.parameters != static_cast<int>(kCoefficientCount) || !approximate.sigma_rad)
        return std::nullopt;
    const bool byExact
        = exact.parameters == static_cast<int>(kCoefficientCount) && exact.sigma_rad && *exact.sigma_rad < *approximate.sigma_rad;
    const SmithFitReport& fit = byExact ? static_cast<const SmithFitReport&>(exact) : approximate;
    if (explained(fit, readingError_rad))
        return std::nullopt;
    if (readings.size() >= 10 && readings.size() < kLog)
        if (const auto third_rad = higherHarmonics_rad(readings, fit.residual_rad))
            return LackOfFit{
                {MARKED("core",
                     "five coefficients do not describe this curve: a third harmonic of %1° is in the readings, more than chance, "
                     "and the card leaves it out (largest residual %2°)"),
                    tenths(*third_rad), tenths(fit.maxAbsResidual_rad)},
                true};
    if (fit.degreesOfFreedom >= 3 && *fit.sigma_rad > std::max(3.0 * readingError_rad, toRadians(kScatter_deg)))
        return LackOfFit{
            {MARKED("core",
                 "five coefficients leave a scatter of %1° where reading the compass explains %2°: the readings are poor, or more "
                 "than five coefficients are in them"),
                tenths(*fit.sigma_rad), tenths(readingError_rad)},
            false};
    return std::nullopt;
}

} // namespace lubberline
