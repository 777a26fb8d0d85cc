#include "core/fleet/Pattern.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "core/base/Contract.h"
#include "core/fleet/ByTwoHands.h"
#include "core/fleet/Proportion.h"

namespace lubberline {

namespace {

using Matrix5d = Eigen::Matrix<double, 5, 5>;
using Vector5d = Eigen::Matrix<double, 5, 1>;

/// A swing without a curve has a say only where it was read.
constexpr double kOnHeading_deg = 0.5;
constexpr double kOutlier = 3.5;

struct Moments {
    std::optional<double> mean, standardDeviation, standardError;
};
Moments momentsOf(std::span<const double> values)
{
    Moments moments;
    if (values.empty())
        return moments;
    const auto n = static_cast<double>(values.size());
    double mean = 0, squares = 0;
    for (const double value : values)
        mean += value;
    mean /= n;
    for (const double value : values)
        squares += (value - mean) * (value - mean);
    moments.mean = mean;
    if (values.size() > 1) {
        moments.standardDeviation = std::sqrt(squares / (n - 1));
        moments.standardError = *moments.standardDeviation / std::sqrt(n);
    }
    return moments;
}

struct Votes {
    std::vector<std::vector<double>> atHeading; ///< heading by unit
    std::array<std::vector<double>, 5> coefficient;
    std::array<std::vector<std::uint32_t>, 5> row; ///< a swing of each unit
    std::array<double, 5> fitVariance{};           ///< summed over the units
    Vector5d sum = Vector5d::Zero();               ///< of the units of which all five are known
    Matrix5d products = Matrix5d::Zero(), fitCovariance = Matrix5d::Zero();
    int whole = 0;
    std::vector<std::int64_t> moved;
    std::size_t swings = 0;
};

/// One who votes: the swings of an aircraft, or one swing.
struct Unit {
    std::vector<double> sum;
    std::vector<int> count;
    std::array<double, 5> coefficient{}, variance{};
    std::array<int, 5> known{};
    std::array<std::uint32_t, 5> row{};
    Vector5d whole = Vector5d::Zero();
    Matrix5d covariance = Matrix5d::Zero();
    int wholes = 0;
    std::vector<int> moved;
    std::size_t swings = 0;

    explicit Unit(std::size_t grid) : sum(grid), count(grid), moved(grid) {}

    void add(const FleetCurves& curves, const FleetSwing& swing, std::uint32_t at)
    {
        const SwingCurve& curve = curves.curves[at];
        for (std::size_t c = 0; c < 5; ++c)
            if (curve.known(c)) {
                coefficient[c] += curve.value_deg[c];
                variance[c] += curves.variance_deg2(swing, at, c);
                if (known[c]++ == 0)
                    row[c] = at;
            }
        if (curve.parameters != 5)
            return;
        const double sigma = curves.sigma_deg[static_cast<std::size_t>(swing.compass)];
        for (int i = 0; i < 5; ++i) {
            whole[i] += curve.value_deg[static_cast<std::size_t>(i)];
            for (int j = 0; j < 5; ++j)
                covariance(i, j) += sigma * sigma * curve.inverse[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
        }
        ++wholes;
    }

    void voteInto(Votes& votes) const
    {
        votes.swings += swings;
        for (std::size_t h = 0; h < sum.size(); ++h)
            votes.moved[h] += moved[h];
        for (std::size_t h = 0; h < sum.size(); ++h)
            if (count[h] > 0)
                votes.atHeading[h].push_back(sum[h] / count[h]);
        for (std::size_t c = 0; c < 5; ++c)
            if (known[c] > 0) {
                votes.coefficient[c].push_back(coefficient[c] / known[c]);
                votes.row[c].push_back(row[c]);
                votes.fitVariance[c] += variance[c] / (static_cast<double>(known[c]) * known[c]);
            }
        if (wholes == 0)
            return;
        const Vector5d mean = whole / wholes;
        votes.sum += mean;
        votes.products += mean * mean.transpose();
        votes.fitCovariance += covariance / (static_cast<double>(wholes) * wholes);
        ++votes.whole;
    }
};

bool sameAircraft(const FleetSwings& fleet, const FleetSwing& a, const FleetSwing& b)
{
    const auto& one = fleet.compasses[static_cast<std::size_t>(a.compass)];
    const auto& other = fleet.compasses[static_cast<std::size_t>(b.compass)];
    return a.compass == b.compass || (one.aircraft == other.aircraft && one.type == other.type);
}

/// Rows of the first swing of each unit, and the end.
std::vector<std::size_t> unitsOf(const FleetSwings& fleet, FleetVote vote)
{
    std::vector<std::size_t> first;
    for (std::size_t row = 0; row < fleet.swings.size(); ++row)
        if (row == 0 || vote != FleetVote::Aircraft || !sameAircraft(fleet, fleet.swings[first.back()], fleet.swings[row]))
            first.push_back(row);
    first.push_back(fleet.swings.size());
    return first;
}

Unit unitOf(const FleetSwings& fleet, const FleetCurves& curves, const PatternOptions& options, std::size_t first, std::size_t next)
{
    const auto grid = static_cast<std::size_t>(options.grid);
    const double step_deg = 360.0 / options.grid;
    Unit unit(grid);
    for (std::size_t row = first; row < next; ++row) {
        const auto& swing = fleet.swings[row];
        if (options.stage && swing.stage != *options.stage)
            continue;
        ++unit.swings;
        unit.add(curves, swing, static_cast<std::uint32_t>(row));
        for (std::size_t h = 0; h < grid; ++h)
            if (const auto value = valueAt(fleet, swing, curves.curves[row], static_cast<double>(h) * step_deg, 0.5 * step_deg)) {
                unit.sum[h] += value->deviation_deg;
                ++unit.count[h];
                unit.moved[h] += value->read ? 0 : 1;
            }
    }
    return unit;
}

Votes votesOf(const FleetSwings& fleet, const FleetCurves& curves, const PatternOptions& options)
{
    constexpr std::size_t most = 4096; // that are held before they vote
    const auto grid = static_cast<std::size_t>(options.grid);
    Votes votes;
    votes.atHeading.resize(grid);
    votes.moved.resize(grid);
    const auto first = unitsOf(fleet, options.vote);
    for (std::size_t begin = 0; begin + 1 < first.size(); begin += most) {
        std::vector<Unit> units(std::min(most, first.size() - 1 - begin), Unit(grid));
        byTwoHands(
            units.size(), 4, {}, [&](std::size_t i) { units[i] = unitOf(fleet, curves, options, first[begin + i], first[begin + i + 1]); });
        for (const auto& unit : units)
            unit.voteInto(votes);
    }
    return votes;
}

/// Standard deviation between units of the curve at a heading, from Σ of the coefficients less the mean covariance of their fits.
std::optional<double> betweenAt(const Votes& votes, double magnetic_deg)
{
    if (votes.whole < 2)
        return {};
    const double n = votes.whole;
    const Vector5d mean = votes.sum / n;
    const Matrix5d covariance = (votes.products - n * mean * mean.transpose()) / (n - 1) - votes.fitCovariance / n;
    FiveTerms smith{};
    for (std::size_t c = 0; c < 5; ++c)
        smith[c] = mean[static_cast<Eigen::Index>(c)];
    const FiveTerms x = termsAt(curveAtMagnetic(smith, magnetic_deg).compass_deg);
    const Eigen::Map<const Vector5d> terms(x.data());
    return std::sqrt(std::max(0.0, terms.dot(covariance * terms)));
}

void setPercentiles(std::vector<double>& values, std::optional<double>& p5, std::optional<double>& p50, std::optional<double>& p95)
{
    if (values.empty())
        return;
    std::ranges::sort(values);
    p5 = percentileOf(values, 0.05);
    p50 = percentileOf(values, 0.50);
    p95 = percentileOf(values, 0.95);
}

std::vector<CoefficientOutlier> outliersOf(const std::vector<double>& values, const std::vector<std::uint32_t>& rows, double median)
{
    std::vector<double> distance;
    for (const double value : values)
        distance.push_back(std::abs(value - median));
    std::ranges::sort(distance);
    const double mad = percentileOf(distance, 0.5);
    std::vector<CoefficientOutlier> outliers;
    if (values.size() < 8 || !(mad > 0)) // fewer have no tails to be judged by
        return outliers;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (const double z = 0.6745 * (values[i] - median) / mad; std::abs(z) > kOutlier)
            outliers.push_back({rows[i], values[i], z});
    std::ranges::stable_sort(outliers, {}, [](const CoefficientOutlier& o) { return -std::abs(o.distance); });
    return outliers;
}

CoefficientSpread spreadOf(Votes& votes, std::size_t c)
{
    CoefficientSpread spread;
    auto& values = votes.coefficient[c];
    const auto moments = momentsOf(values);
    spread.units = static_cast<int>(values.size());
    spread.mean_deg = moments.mean;
    spread.standardDeviation_deg = moments.standardDeviation;
    spread.standardError_deg = moments.standardError;
    if (moments.standardDeviation)
        spread.between_deg
            = std::sqrt(std::max(0.0, std::pow(*moments.standardDeviation, 2) - votes.fitVariance[c] / static_cast<double>(values.size())));
    spread.values_deg = values;
    setPercentiles(spread.values_deg, spread.percentile5_deg, spread.percentile50_deg, spread.percentile95_deg);
    if (spread.percentile50_deg)
        spread.outliers = outliersOf(values, votes.row[c], *spread.percentile50_deg);
    return spread;
}

std::vector<HarmonicOrder> ordersOf(const std::vector<PatternPoint>& points, std::optional<double> PatternPoint::*figure)
{
    std::vector<HarmonicSample> samples;
    for (const auto& point : points) {
        if (!(point.*figure))
            return {};
        samples.push_back({toRadians(point.heading_deg), toRadians(*(point.*figure))});
    }
    const auto found = harmonics(samples);
    return found ? found->orders : std::vector<HarmonicOrder>{};
}

std::vector<double> headingsOf(const std::vector<PatternPoint>& points, const std::vector<std::size_t>& places)
{
    std::vector<double> headings;
    for (const auto place : places)
        headings.push_back(points[place].heading_deg);
    return headings;
}

void findExtremes(PopulationPattern& pattern)
{
    std::vector<double> mean, spread;
    for (const auto& point : pattern.points) {
        if (point.mean_deg)
            mean.push_back(*point.mean_deg);
        if (point.standardDeviation_deg)
            spread.push_back(*point.standardDeviation_deg);
    }
    if (mean.size() == pattern.points.size()) {
        pattern.maxima_deg = headingsOf(pattern.points, peaksOf(mean, true));
        pattern.minima_deg = headingsOf(pattern.points, peaksOf(mean, false));
    }
    if (spread.size() == pattern.points.size() && std::ranges::max(spread) > 0)
        pattern.largestSpread_deg = pattern.points[static_cast<std::size_t>(std::ranges::max_element(spread) - spread.begin())].heading_deg;
}

double apart(double a_deg, double b_deg)
{
    const double d = std::abs(a_deg - b_deg);
    return std::min(d, 360.0 - d);
}

} // namespace

std::optional<GridValue> valueAt(
    const FleetSwings& fleet, const FleetSwing& swing, const SwingCurve& curve, double magnetic_deg, double halfStep_deg)
{
    const auto magnetic = fleet.magneticOf(swing), compass = fleet.compassOf(swing);
    const double within = curve.fitted() ? halfStep_deg : std::min(halfStep_deg, kOnHeading_deg);
    double nearest = within + 1e-9, sum = 0;
    int count = 0;
    for (std::size_t r = 0; r < magnetic.size(); ++r) {
        const double distance = apart(magnetic[r], magnetic_deg);
        if (distance > nearest + 1e-9)
            continue;
        if (distance < nearest - 1e-9) {
            nearest = distance;
            sum = 0;
            count = 0;
        }
        const double deviation = wrap180(magnetic[r] - compass[r]);
        sum += distance < 1e-9 || !curve.fitted()
            ? deviation
            : deviation + curveAtMagnetic(curve.value_deg, magnetic_deg).deviation_deg - curveAtCompass_deg(curve.value_deg, compass[r]);
        ++count;
    }
    if (count > 0)
        return GridValue{sum / count, true};
    if (!curve.fitted())
        return {};
    return GridValue{curveAtMagnetic(curve.value_deg, magnetic_deg).deviation_deg, false};
}

std::vector<std::size_t> peaksOf(std::span<const double> around, bool highest)
{
    const std::size_t n = around.size();
    double largest = 0;
    for (const double value : around)
        largest = std::max(largest, std::abs(value));
    const auto step = [&](std::size_t from) { // to the next: 1 up, −1 down, 0 level to the digits that a mean has
        const double rise = (around[(from + 1) % n] - around[from]) * (highest ? 1 : -1);
        return rise > 1e-12 * largest ? 1 : rise < -1e-12 * largest ? -1 : 0;
    };
    std::vector<std::size_t> peaks;
    for (std::size_t i = 0; i < n; ++i) {
        if (step((i + n - 1) % n) != 1)
            continue;
        std::size_t level = 0;
        while (level < n && step((i + level) % n) == 0)
            ++level;
        if (level < n && step((i + level) % n) == -1)
            peaks.push_back(i);
    }
    return peaks;
}

PopulationPattern patternOf(const FleetSwings& fleet, const FleetCurves& curves, const PatternOptions& options)
{
    LUBBERLINE_EXPECT(options.grid >= 3 && options.grid <= 360, "a grid of 3 to 360 headings");
    Votes votes = votesOf(fleet, curves, options);
    PopulationPattern pattern;
    pattern.swings = votes.swings;
    for (std::size_t h = 0; h < votes.atHeading.size(); ++h) {
        PatternPoint point;
        auto& values = votes.atHeading[h];
        const auto moments = momentsOf(values);
        point.heading_deg = static_cast<double>(h) * 360.0 / options.grid;
        point.units = static_cast<int>(values.size());
        point.mean_deg = moments.mean;
        point.standardDeviation_deg = moments.standardDeviation;
        point.between_deg = betweenAt(votes, point.heading_deg);
        point.moved = votes.moved[h];
        setPercentiles(values, point.percentile5_deg, point.percentile50_deg, point.percentile95_deg);
        pattern.points.push_back(point);
    }
    for (std::size_t c = 0; c < 5; ++c)
        pattern.coefficients[c] = spreadOf(votes, c);
    findExtremes(pattern);
    pattern.mean = ordersOf(pattern.points, &PatternPoint::mean_deg);
    pattern.spread = ordersOf(pattern.points, &PatternPoint::standardDeviation_deg);
    return pattern;
}

} // namespace lubberline
