#include "core/deviation/Derivation.h"

#include <cmath>

#include "core/deviation/SmithRows.h"

namespace lubberline {

namespace {

template <class MakeRow>
std::optional<Derivation> derivationBy(std::span<const Observation> readings, const SmithFitReport& fit, Coefficient which, MakeRow makeRow)
{
    if (!fit.of(which))
        return std::nullopt;
    const auto own = fit.unitCovariance.row(static_cast<Eigen::Index>(indexOf(which)));
    Derivation derivation;
    for (std::size_t i = 0; i < readings.size(); ++i) {
        const SmithRow row = makeRow(readings[i], toDegrees(fit.index_rad));
        const double weight = own.dot(Eigen::Map<const Eigen::Matrix<double, 1, 5>>(row.x.data()));
        derivation.terms.push_back({i, weight, row.y});
        derivation.sum += derivation.terms.back().product();
    }
    return derivation;
}

/// Of N, NE, … NW.
std::array<double, 8> ruleWeights(int points, Coefficient which)
{
    switch (which) {
    case Coefficient::A:
        return points == 8 ? std::array{0.125, 0.125, 0.125, 0.125, 0.125, 0.125, 0.125, 0.125}
                           : std::array{0.25, 0.0, 0.25, 0.0, 0.25, 0.0, 0.25, 0.0};
    case Coefficient::B: return {0, 0, 0.5, 0, 0, 0, -0.5, 0};
    case Coefficient::C: return {0.5, 0, 0, 0, -0.5, 0, 0, 0};
    case Coefficient::D: return {0, 0.25, 0, -0.25, 0, 0.25, 0, -0.25};
    case Coefficient::E: return {0.25, 0, -0.25, 0, 0.25, 0, -0.25, 0};
    }
    return {};
}

} // namespace

std::optional<Derivation> derivationOf(std::span<const Observation> readings, const ApproximateFit& fit, Coefficient which)
{
    return derivationBy(readings, fit, which, approximateRow);
}

std::optional<Derivation> derivationOf(std::span<const Observation> readings, const ExactFit& fit, Coefficient which)
{
    return derivationBy(readings, fit, which, exactRow);
}

/// Several readings on the heading of a point share its weight, as the rule takes their mean.
std::optional<Derivation> derivationOf(std::span<const Observation> readings, const PointRules& rules, Coefficient which)
{
    if (which == Coefficient::D && !rules.D_rad)
        return std::nullopt;
    const auto weights = ruleWeights(rules.points, which);
    const double index_deg = largeIndex_deg(readings);
    const auto headingOf = [&](std::size_t i) {
        return rules.argument == HeadingArgument::Magnetic ? readings[i].magnetic.degrees() : readings[i].compass.degrees();
    };
    Derivation derivation;
    for (std::size_t point = 0; point < weights.size(); ++point) {
        if (weights[point] == 0.0 || !rules.reading[point])
            continue;
        std::vector<std::size_t> there;
        for (std::size_t i = 0; i < readings.size(); ++i)
            if (headingOf(i) == headingOf(*rules.reading[point]))
                there.push_back(i);
        for (const std::size_t i : there) {
            const double deviation_rad = toRadians(aboutIndex_deg(readings[i], index_deg));
            derivation.terms.push_back({i, weights[point] / static_cast<double>(there.size()), deviation_rad});
            derivation.sum += derivation.terms.back().product();
        }
    }
    return derivation;
}

} // namespace lubberline
