#include "core/swing/LackOfFit.h"

#include <algorithm>
#include <cmath>

#include <boost/math/distributions/chi_squared.hpp>

#include "core/base/Number.h"
#include "core/swing/HigherShape.h"

namespace lubberline {

namespace {

constexpr double kLeast_deg = 0.3;     ///< a smaller shape changes no card
constexpr double kScatter_deg = 1.5;   ///< more than swaying cards and tired eyes
constexpr double kHandling_deg = 0.45; ///< what crews and compasses usually add to the division (core/deviation/SwingSlips.cpp)
constexpr int kLogFreedom = 200;       ///< a log sways with the aircraft: its scatter is no reader's

std::string tenths(double angle_rad) { return figureText(toDegrees(angle_rad), 1); }

/// Whether readings of that error leave such a scatter in one swing of twenty or more.
bool explained(const SmithFitReport& fit, double readingError_rad)
{
    if (fit.degreesOfFreedom < 1 || readingError_rad <= 0.0)
        return false;
    const double squares = *fit.sigma_rad * *fit.sigma_rad * fit.degreesOfFreedom / (readingError_rad * readingError_rad);
    return squares <= boost::math::quantile(boost::math::chi_squared(fit.degreesOfFreedom), 0.95);
}

Message wordsOf(const HigherShape& shape, const SmithFitReport& fit)
{
    if (shape.onlyThird_rad)
        return {MARKED("core",
                    "five coefficients do not describe this curve: a third harmonic of %1° is in the readings, more than chance, "
                    "and the card leaves it out (largest residual %2°)"),
            tenths(*shape.onlyThird_rad), tenths(fit.maxAbsResidual_rad)};
    return {MARKED("core",
                "five coefficients do not describe this curve: neighbouring readings go astray together by some %1°, more than chance, "
                "and the card leaves it out (largest residual %2°)"),
        tenths(shape.size_rad), tenths(fit.maxAbsResidual_rad)};
}

/// A scatter that readings of that error, as they are usually handled, do not leave in one swing of a hundred.
bool scattersMore(const SmithFitReport& fit, double readingError_rad)
{
    if (fit.degreesOfFreedom < 3)
        return false;
    if (readingError_rad <= 0.0 || fit.degreesOfFreedom >= kLogFreedom)
        return *fit.sigma_rad > std::max(3.0 * readingError_rad, toRadians(kScatter_deg));
    const double expected_rad = std::hypot(readingError_rad, toRadians(kHandling_deg));
    const double most = boost::math::quantile(boost::math::chi_squared(fit.degreesOfFreedom), 0.99) / fit.degreesOfFreedom;
    return *fit.sigma_rad > std::sqrt(most) * expected_rad;
}

} // namespace

std::optional<LackOfFit> lackOfFit(std::span<const Observation> readings, const ApproximateFit& approximate, const ExactFit& exact,
    double readingError_rad, const std::vector<std::size_t>& leftOut)
{
    if (approximate.parameters != static_cast<int>(kCoefficientCount) || !approximate.sigma_rad)
        return std::nullopt;
    const bool byExact
        = exact.parameters == static_cast<int>(kCoefficientCount) && exact.sigma_rad && *exact.sigma_rad < *approximate.sigma_rad;
    const SmithFitReport& fit = byExact ? static_cast<const SmithFitReport&>(exact) : approximate;
    if (explained(fit, readingError_rad))
        return std::nullopt;
    const auto shape = higherShape(readings, fit.residual_rad, leftOut);
    if (shape && toDegrees(shape->size_rad) >= kLeast_deg)
        return LackOfFit{wordsOf(*shape, fit), shape->at_rad};
    if (scattersMore(fit, readingError_rad))
        return LackOfFit{
            {MARKED("core",
                 "five coefficients leave a scatter of %1° where reading the compass explains %2°: the readings are poor, or more "
                 "than five coefficients are in them"),
                tenths(*fit.sigma_rad), tenths(readingError_rad)},
            {}};
    return std::nullopt;
}

} // namespace lubberline
