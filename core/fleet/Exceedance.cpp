#include "core/fleet/Exceedance.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/algebra/Spectra.h"
#include "core/fleet/FleetRandom.h"
#include "core/fleet/Pattern.h"

namespace lubberline {

namespace {

constexpr int kPredictions = 20000; ///< an expected share of 10 % is told to ±0.2 %

const FleetCompass& compassOf(const FleetSwings& fleet, const InspectionPair& pair)
{
    return fleet.compasses[static_cast<std::size_t>(fleet.swings[pair.foundRow].compass)];
}

/// The limit that all pairs share; none where they have several or none.
std::optional<double> commonLimit(const FleetSwings& fleet, std::span<const InspectionPair> pairs)
{
    std::optional<double> common;
    for (const auto& pair : pairs) {
        const auto& limit = compassOf(fleet, pair).limit_deg;
        if (!limit)
            continue;
        if (common && *common != *limit)
            return {};
        common = limit;
    }
    return common;
}

void countGroup(std::map<std::string, ExceedanceGroup>& groups, const std::string& name, bool beyond)
{
    auto& group = groups[name];
    group.name = name;
    ++group.pairs;
    group.exceeded += beyond ? 1 : 0;
}

std::vector<ExceedanceGroup> listed(std::map<std::string, ExceedanceGroup>& groups)
{
    std::vector<ExceedanceGroup> list;
    for (auto& [name, group] : groups) {
        group.share95 = clopperPearson(group.exceeded, group.pairs);
        list.push_back(std::move(group));
    }
    return list;
}

/// Means and covariance of the coefficients as found, of swings that tell all five.
struct FoundPopulation {
    int n = 0;
    Eigen::Matrix<double, 5, 1> mean = Eigen::Matrix<double, 5, 1>::Zero();
    Eigen::Matrix<double, 5, 5> covariance = Eigen::Matrix<double, 5, 5>::Zero();
    double residual_deg2 = 0; ///< by which a reading lies off its swing's curve, on average
    std::uint64_t seed = 0;
};

FoundPopulation populationOf(const FleetCurves& curves, std::span<const InspectionPair> pairs)
{
    FoundPopulation population;
    ContentSeed seed;
    double squares = 0, readings = 0;
    const auto whole = [&](auto&& use) {
        for (const auto& pair : pairs)
            if (const auto& curve = curves.curves[pair.foundRow]; curve.parameters == 5)
                use(curve, Eigen::Map<const Eigen::Matrix<double, 5, 1>>(curve.value_deg.data()));
    };
    whole([&](const SwingCurve& curve, const auto& value) {
        ++population.n;
        population.mean += value;
        squares += curve.residualSquares_deg2;
        readings += curve.readings;
        for (const double each : curve.value_deg)
            seed.add(each);
    });
    population.seed = seed.value();
    if (population.n < 2)
        return population;
    population.mean /= population.n;
    whole([&](const SwingCurve&, const auto& value) {
        const Eigen::Matrix<double, 5, 1> off = value - population.mean;
        population.covariance += off * off.transpose() / (population.n - 1);
    });
    population.residual_deg2 = squares / readings;
    return population;
}

/// Square root of a covariance that may be short of rank.
Eigen::Matrix<double, 5, 5> rootOf(const Eigen::Matrix<double, 5, 5>& covariance)
{
    const SymmetricParts parts = symmetricParts(covariance);
    return parts.vectors * parts.values.cwiseMax(0.0).cwiseSqrt().asDiagonal();
}

double expectedBeyond(const FoundPopulation& population, double limit_deg, int grid)
{
    std::vector<FiveTerms> terms;
    for (int h = 0; h < grid; ++h)
        terms.push_back(termsAt(360.0 * h / grid));
    // Each heading's marginal is Student's with n − 1 degrees and s√(1 + 1/n) (Geisser and Cornfield 1963).
    const Eigen::Matrix<double, 5, 5> root = rootOf(population.covariance) * std::sqrt(1 + 1.0 / population.n);
    const double residual = std::sqrt(population.residual_deg2);
    FleetRandom random(population.seed);
    int beyond = 0;
    for (int draw = 0; draw < kPredictions; ++draw) {
        Eigen::Matrix<double, 5, 1> z;
        for (int c = 0; c < 5; ++c)
            z[c] = random.normal();
        const double scale = std::sqrt((population.n - 1) / random.chiSquare(population.n - 1));
        const Eigen::Matrix<double, 5, 1> next = population.mean + scale * (root * z);
        bool out = false;
        for (const auto& x : terms) {
            const double curve = next.dot(Eigen::Map<const Eigen::Matrix<double, 5, 1>>(x.data()));
            out = out || std::abs(curve + scale * residual * random.normal()) > limit_deg;
        }
        beyond += out ? 1 : 0;
    }
    return static_cast<double>(beyond) / kPredictions;
}

void predictHeadings(const FleetSwings& fleet, const FleetCurves& curves, std::span<const InspectionPair> pairs, double limit_deg, int grid,
    Exceedance& result)
{
    const double step = 360.0 / grid;
    for (int h = 0; h < grid; ++h) {
        std::vector<double> values;
        for (const auto& pair : pairs)
            if (const auto value = valueAt(fleet, fleet.swings[pair.foundRow], curves.curves[pair.foundRow], h * step, 0.5 * step))
                values.push_back(value->deviation_deg);
        const auto n = static_cast<int>(values.size());
        if (n < 2)
            continue;
        double mean = 0, squares = 0;
        for (const double value : values)
            mean += value / n;
        for (const double value : values)
            squares += (value - mean) * (value - mean);
        const double s = std::sqrt(squares / (n - 1));
        const double plain
            = s > 0 ? normalTail((limit_deg - mean) / s) + normalTail((limit_deg + mean) / s) : (std::abs(mean) > limit_deg ? 1.0 : 0.0);
        result.headings.push_back({h * step, nextBeyond(n, mean, s, limit_deg), plain});
        result.threeSigmaShare = std::max(result.threeSigmaShare.value_or(0.0), plain);
    }
}

} // namespace

std::vector<InspectionPair> pairsOf(const FleetSwings& fleet, std::span<const CompassHistory> histories)
{
    std::vector<InspectionPair> pairs;
    for (const auto& history : histories) {
        std::optional<std::uint32_t> left;
        for (const auto row : history.rows) {
            const FleetSwing& swing = fleet.swings[row];
            if (swing.stage == SwingStage::AsLeft)
                left = row;
            else if (left && swing.day > fleet.swings[*left].day) {
                if (swing.stage == SwingStage::AsFound) // where it is not stated, nobody knows how the compass was found
                    pairs.push_back({*left, row});
                left.reset();
            }
        }
    }
    return pairs;
}

Exceedance exceedanceOf(
    const FleetSwings& fleet, const FleetCurves& curves, std::span<const InspectionPair> pairs, std::optional<double> limit_deg, int grid)
{
    Exceedance result;
    result.limit_deg = limit_deg ? limit_deg : commonLimit(fleet, pairs);
    std::map<std::string, ExceedanceGroup> types, sites, crews;
    for (const auto& pair : pairs) {
        const auto limit = limit_deg ? limit_deg : compassOf(fleet, pair).limit_deg;
        if (!limit) {
            ++result.withoutLimit;
            continue;
        }
        const FleetSwing& found = fleet.swings[pair.foundRow];
        const bool beyond = curves.curves[pair.foundRow].maxAbs_deg > *limit;
        ++result.pairs;
        result.exceeded += beyond ? 1 : 0;
        countGroup(types, compassOf(fleet, pair).type, beyond);
        if (found.site >= 0)
            countGroup(sites, fleet.sites[static_cast<std::size_t>(found.site)], beyond);
        if (found.crew >= 0)
            countGroup(crews, fleet.crews[static_cast<std::size_t>(found.crew)], beyond);
    }
    if (result.pairs == 0)
        return result;
    result.share95 = clopperPearson(result.exceeded, result.pairs);
    result.byType = listed(types);
    result.bySite = listed(sites);
    result.byCrew = listed(crews);
    if (!result.limit_deg)
        return result;
    if (const auto population = populationOf(curves, pairs); population.n >= 2)
        result.expectedShare = expectedBeyond(population, *result.limit_deg, grid);
    predictHeadings(fleet, curves, pairs, *result.limit_deg, grid, result);
    return result;
}

} // namespace lubberline
