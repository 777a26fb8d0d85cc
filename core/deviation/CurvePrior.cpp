#include "core/deviation/CurvePrior.h"

#include <algorithm>
#include <cmath>

namespace lubberline {

namespace {

/// Our choice, wide on purpose: E of a light aircraft is seldom over a degree, D over two or three.
constexpr ExpectedCurve kUsual{{}, {toRadians(3.0), toRadians(6.0), toRadians(6.0), toRadians(1.5), toRadians(0.8)}};
constexpr ExpectedCurve kLarge{{}, {toRadians(3.0), toRadians(15.0), toRadians(15.0), toRadians(6.0), toRadians(3.0)}};
constexpr double kUsualShare = 0.8;
/// How often a compass deviates as its last swing lets expect.
constexpr double kAsBefore = 0.8;

CurvePrior priorOf(Form form, const ExpectedCurve& expected, double share)
{
    CurvePrior prior;
    const ExactSmith exact = toExact(expected.mean);
    if (form == Form::Exact)
        prior.mean << 0.0, exact.B, exact.C, exact.D, exact.E; // the index is taken out
    else
        prior.mean << 0.0, expected.mean.B_rad, expected.mean.C_rad, expected.mean.D_rad, expected.mean.E_rad;
    const auto& spread = expected.standardDeviation;
    const double middle_rad = std::max(spread.A_rad, kUsual.standardDeviation.A_rad); // a middle is no A
    prior.precision = Row5{middle_rad, spread.B_rad, spread.C_rad, spread.D_rad, spread.E_rad}.array().square().inverse();
    prior.log = std::log(share) + 0.5 * prior.precision.array().log().sum();
    return prior;
}

} // namespace

std::vector<CurvePrior> curvePriors(Form form, const std::optional<ExpectedCurve>& history)
{
    const double unknown = history ? 1.0 - kAsBefore : 1.0;
    std::vector<CurvePrior> priors{priorOf(form, kUsual, unknown * kUsualShare), priorOf(form, kLarge, unknown * (1.0 - kUsualShare))};
    if (history)
        priors.push_back(priorOf(form, *history, kAsBefore));
    return priors;
}

} // namespace lubberline
