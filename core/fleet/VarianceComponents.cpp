#include "core/fleet/VarianceComponents.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

#include <boost/math/distributions/fisher_f.hpp>

#include "core/fleet/VarianceModel.h"

namespace lubberline {

namespace {

/// Crews and sites together: a Cholesky of this size takes a tenth of a second, and a fleet's profile asks for thousands.
constexpr std::int32_t kMostLevels = 800;

using Point = std::vector<double>;
using Function = std::function<double(const Point&)>;

/// The downhill simplex of Nelder and Mead, for one to four unknowns. @return the least value; `at` is where
double leastOf(const Function& f, Point& at, double step)
{
    const std::size_t n = at.size();
    if (n == 0)
        return f(at);
    std::vector<std::pair<double, Point>> corners{{f(at), at}};
    for (std::size_t i = 0; i < n; ++i) {
        Point corner = at;
        corner[i] += step * std::max(0.1, std::abs(corner[i]));
        corners.emplace_back(f(corner), corner);
    }
    for (int round = 0; round < 400; ++round) {
        std::ranges::sort(corners);
        double size = 0;
        for (std::size_t i = 0; i < n; ++i)
            size = std::max(
                size, std::abs(corners.back().second[i] - corners.front().second[i]) / (1e-3 + std::abs(corners.front().second[i])));
        if (size < 1e-7 || corners.back().first - corners.front().first < 1e-12 * (1 + std::abs(corners.front().first)))
            break;
        Point middle(n, 0.0);
        for (std::size_t c = 0; c < n; ++c)
            for (std::size_t i = 0; i < n; ++i)
                middle[i] += corners[c].second[i] / static_cast<double>(n);
        const auto along = [&](double t) {
            Point to(n);
            for (std::size_t i = 0; i < n; ++i)
                to[i] = middle[i] + t * (corners.back().second[i] - middle[i]);
            return std::pair(f(to), to);
        };
        auto tried = along(-1.0);
        if (tried.first < corners.front().first) {
            if (auto further = along(-2.0); further.first < tried.first)
                tried = std::move(further);
        } else if (tried.first >= corners[n - 1].first) {
            tried = along(tried.first < corners.back().first ? -0.5 : 0.5);
        }
        if (tried.first < corners.back().first) {
            corners.back() = std::move(tried);
            continue;
        }
        for (std::size_t c = 1; c <= n; ++c) { // shrink
            for (std::size_t i = 0; i < n; ++i)
                corners[c].second[i] = 0.5 * (corners[c].second[i] + corners[0].second[i]);
            corners[c].first = f(corners[c].second);
        }
    }
    std::ranges::sort(corners);
    at = corners.front().second;
    return corners.front().first;
}

/// A simplex stops where values do not differ any more, which is half of the digits: Newton by five-point derivatives, one unknown
/// after the other, gives the others.
void polish(const Function& f, Point& at)
{
    for (int round = 0; round < 8; ++round)
        for (double& x : at) {
            const double middle = x, h = 2e-3 * std::abs(x);
            if (h < 1e-6)
                continue;
            const auto value = [&](double offset) {
                x = middle + offset;
                return f(at);
            };
            const double f0 = value(0), f1 = value(h), b1 = value(-h), f2 = value(2 * h), b2 = value(-2 * h);
            const double slope = (8 * (f1 - b1) - (f2 - b2)) / (12 * h), bend = (f1 - 2 * f0 + b1) / (h * h);
            x = bend > 0 ? middle - std::clamp(slope / bend, -10 * h, 10 * h) : middle;
        }
}

/// The criterion by standard deviations, in units of one that is about the whole: unknowns are |x|, so that zero is no wall.
class Criterion {
public:
    Criterion(const VarianceModel& model, std::vector<std::size_t> factors, double unit)
        : m_model(model)
        , m_factors(std::move(factors))
        , m_unit(unit)
    {
    }
    [[nodiscard]] std::size_t factors() const { return m_factors.size(); }
    [[nodiscard]] std::array<double, 3> lambda(const Point& ratio) const
    {
        std::array<double, 3> lambda{};
        for (std::size_t i = 0; i < m_factors.size(); ++i)
            lambda[m_factors[i]] = ratio[i] * ratio[i];
        return lambda;
    }
    /// σ² at its best.
    [[nodiscard]] double profiled(const Point& ratio) const
    {
        const auto value = m_model.at(lambda(ratio));
        const double n = m_model.count() - 1;
        return n * std::log(value.squares / n) + value.logDeterminant + n * (1 + std::log(2 * kTurn));
    }
    /// All of them given: factors, then residual, as standard deviations / unit.
    [[nodiscard]] double full(const Point& deviation) const
    {
        const double sigma = std::max(std::abs(deviation.back()), 1e-6) * m_unit;
        Point ratio(m_factors.size());
        for (std::size_t i = 0; i < ratio.size(); ++i)
            ratio[i] = deviation[i] * m_unit / sigma;
        const auto value = m_model.at(lambda(ratio));
        const double n = m_model.count() - 1;
        return n * std::log(sigma * sigma) + value.squares / (sigma * sigma) + value.logDeterminant + n * std::log(2 * kTurn);
    }

private:
    static constexpr double kTurn = 3.14159265358979323846;
    const VarianceModel& m_model;
    std::vector<std::size_t> m_factors;
    double m_unit;
};

struct Profile {
    const Criterion& criterion;
    Point best; ///< standard deviations / unit
    double least;
    double rise; ///< that bounds the interval

    /// How far the criterion stands above its least with one of them held.
    [[nodiscard]] double above(std::size_t which, double held, Point& others) const
    {
        const auto f = [&](const Point& free) {
            Point all = free;
            all.insert(all.begin() + static_cast<std::ptrdiff_t>(which), held);
            return criterion.full(all);
        };
        return leastOf(f, others, 0.15) - least - rise;
    }

    [[nodiscard]] Point othersOf(std::size_t which) const
    {
        Point others = best;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(which));
        return others;
    }

    /// Where it has risen, between a place below and one above the bound; false position with halving (Illinois).
    [[nodiscard]] double crossing(std::size_t which, double inside, double outside, double outsideAbove) const
    {
        Point others = othersOf(which);
        double low = inside, high = outside, fLow = -rise, fHigh = outsideAbove;
        for (int round = 0; round < 40 && std::abs(high - low) > 1e-5 * (std::abs(high) + std::abs(low)); ++round) {
            const double middle = high - fHigh * (high - low) / (fHigh - fLow);
            const double f = above(which, middle, others);
            if (std::abs(f) < 1e-4)
                return middle;
            if ((f < 0) == (fHigh < 0))
                fLow *= 0.5;
            else
                low = high, fLow = fHigh;
            high = middle;
            fHigh = f;
        }
        return high;
    }

    [[nodiscard]] Interval of(std::size_t which) const
    {
        const bool residual = which + 1 == best.size();
        Interval interval;
        Point others = othersOf(which);
        const double zero = residual ? 1e-3 * best[which] : 0.0;
        if (const double atZero = above(which, zero, others); atZero > 0)
            interval.low = crossing(which, best[which], zero, atZero);
        others = othersOf(which);
        double far = std::max(best[which], 0.05), atFar = 0;
        do
            far *= 1.6;
        while ((atFar = above(which, far, others)) < 0 && far < 1e4);
        interval.high = atFar > 0 ? crossing(which, best[which], far, atFar) : std::numeric_limits<double>::infinity();
        return interval;
    }
};

/// Levels counted from 0 in the order of their old numbers. @return how many
std::int32_t renumber(std::vector<VarianceRow>& rows, std::int32_t VarianceRow::*level)
{
    std::vector<std::int32_t> seen;
    for (const auto& row : rows)
        seen.push_back(row.*level);
    std::ranges::sort(seen);
    seen.erase(std::unique(seen.begin(), seen.end()), seen.end()); // clang 14, which fuzzes, cannot read std::ranges::unique
    for (auto& row : rows)
        row.*level = static_cast<std::int32_t>(std::ranges::lower_bound(seen, row.*level) - seen.begin());
    return static_cast<std::int32_t>(seen.size());
}

/// Whether every level of one lies in one level of the other, and the other way round: they are the same partition.
bool samePartition(const std::vector<VarianceRow>& rows, std::int32_t VarianceRow::*a, std::int32_t VarianceRow::*b)
{
    std::set<std::pair<std::int32_t, std::int32_t>> pairs;
    std::set<std::int32_t> as, bs;
    for (const auto& row : rows) {
        pairs.emplace(row.*a, row.*b);
        as.insert(row.*a);
        bs.insert(row.*b);
    }
    return pairs.size() == as.size() && pairs.size() == bs.size();
}

struct Factors {
    bool aircraft = false, crew = false, site = false;
};

std::size_t stated(const std::vector<VarianceRow>& rows, std::int32_t VarianceRow::*level)
{
    return static_cast<std::size_t>(std::ranges::count_if(rows, [&](const VarianceRow& row) { return row.*level >= 0; }));
}

/// What can be told apart; rows without a crew or site are left out where most have one.
Factors factorsOf(std::vector<VarianceRow>& rows, std::vector<Message>& notTold)
{
    Factors factors;
    factors.crew = 2 * stated(rows, &VarianceRow::crew) > rows.size();
    factors.site = 2 * stated(rows, &VarianceRow::site) > rows.size();
    std::erase_if(rows, [&](const VarianceRow& row) { return (factors.crew && row.crew < 0) || (factors.site && row.site < 0); });
    if (!factors.crew)
        notTold.push_back(MARKED("core", "crew: most swings name none"));
    if (!factors.site)
        notTold.push_back(MARKED("core", "base: most swings name none"));
    const auto aircraft = renumber(rows, &VarianceRow::aircraft), crews = renumber(rows, &VarianceRow::crew),
               sites = renumber(rows, &VarianceRow::site);
    const auto n = static_cast<std::int32_t>(rows.size());
    factors.aircraft = aircraft > 1 && aircraft < n;
    if (!factors.aircraft)
        notTold.push_back(aircraft > 1 ? MARKED("core", "aircraft: each has one swing, so that it cannot be told from a reading")
                                       : MARKED("core", "aircraft: there is one"));
    const auto drop = [&](bool& factor, bool when, Pattern why) {
        if (factor && when) {
            factor = false;
            notTold.push_back(why);
        }
    };
    drop(factors.site, sites < 2, MARKED("core", "base: there is one"));
    drop(factors.crew, crews < 2, MARKED("core", "crew: there is one"));
    drop(factors.crew, crews == n, MARKED("core", "crew: each made one swing"));
    drop(factors.site, sites == n, MARKED("core", "base: each had one swing"));
    drop(factors.crew, samePartition(rows, &VarianceRow::crew, &VarianceRow::aircraft),
        MARKED("core", "crew: each had one aircraft, and each aircraft one crew"));
    drop(factors.site, samePartition(rows, &VarianceRow::site, &VarianceRow::aircraft),
        MARKED("core", "base: each had one aircraft, and each aircraft one base"));
    drop(factors.crew, factors.site && samePartition(rows, &VarianceRow::crew, &VarianceRow::site),
        MARKED("core", "crew and base: each base has one crew, so that what is told as the base's may be the crew's"));
    drop(factors.crew, crews + (factors.site ? sites : 0) > kMostLevels,
        MARKED("core", "crew: there are more of them than are told apart here"));
    drop(factors.site, sites > kMostLevels, MARKED("core", "base: there are more of them than are told apart here"));
    return factors;
}

std::optional<VarianceComponent>& componentOf(VarianceReport& report, std::size_t factor)
{
    return factor == 0 ? report.aircraft : factor == 1 ? report.crew : report.site;
}

double spreadOf(const std::vector<VarianceRow>& rows)
{
    double mean = 0, squares = 0;
    for (const auto& row : rows)
        mean += row.value / static_cast<double>(rows.size());
    for (const auto& row : rows)
        squares += (row.value - mean) * (row.value - mean);
    return std::sqrt(squares / static_cast<double>(rows.size() - 1));
}

bool before(const VarianceRow& a, const VarianceRow& b)
{
    return std::tie(a.aircraft, a.crew, a.site, a.value) < std::tie(b.aircraft, b.crew, b.site, b.value);
}

} // namespace

Result<VarianceReport> varianceComponents(std::vector<VarianceRow> rows, double confidence, const Progress& progress)
{
    VarianceReport report;
    const Factors factors = factorsOf(rows, report.notTold);
    if (rows.size() < 2)
        return Error{ErrorCode::InvalidInput, MARKED("core", "fewer than two swings: no variance can be told")};
    std::ranges::sort(rows, before);
    const double unit = spreadOf(rows);
    if (!(unit > 1e-12))
        return Error{ErrorCode::Numeric, MARKED("core", "all swings are equal: there is no variance to be divided")};
    const VarianceModel model(rows, factors.crew, factors.site);
    std::vector<std::size_t> used;
    for (std::size_t i = 0; i < 3; ++i)
        if (std::array{factors.aircraft, factors.crew, factors.site}[i])
            used.push_back(i);
    const Criterion criterion(model, used, unit);

    Point ratio(used.size(), 0.7);
    report.criterion = leastOf([&](const Point& at) { return criterion.profiled(at); }, ratio, 0.5);
    for (const double start : {0.1, 3.0}) { // a simplex may stay at a wall
        Point other(used.size(), start);
        if (const double value = leastOf([&](const Point& at) { return criterion.profiled(at); }, other, 0.5);
            value < report.criterion - 1e-9) {
            report.criterion = value;
            ratio = other;
        }
    }
    polish([&](const Point& at) { return criterion.profiled(at); }, ratio);
    const auto lambda = criterion.lambda(ratio);
    const auto value = model.at(lambda);
    report.rows = rows.size();
    report.residual.variance = value.squares / (model.count() - 1);
    report.mean = value.mean;
    report.meanStandardError = std::sqrt(report.residual.variance / value.weight);

    Profile profile{criterion, {}, report.criterion, std::pow(normalTailQuantile(0.5 * (1 - confidence)), 2)};
    const double sigma = std::sqrt(report.residual.variance) / unit;
    for (const double each : ratio)
        profile.best.push_back(std::abs(each) * sigma);
    profile.best.push_back(sigma);
    for (std::size_t i = 0; i < profile.best.size(); ++i) {
        if (progress && !progress(static_cast<double>(i) / static_cast<double>(profile.best.size())))
            return Error{ErrorCode::Cancelled, MARKED("core", "cancelled")};
        Interval interval = profile.of(i);
        interval = {std::pow(interval.low * unit, 2), std::pow(interval.high * unit, 2)};
        if (i < used.size())
            componentOf(report, used[i]) = VarianceComponent{lambda[used[i]] * report.residual.variance, interval};
        else
            report.residual.interval = interval;
    }
    return report;
}

Interval intraclassInterval(double F, int groups, int each, double confidence)
{
    const boost::math::fisher_f fisher(groups - 1, groups * (each - 1));
    const double half = 0.5 * (1 - confidence);
    const auto share = [&](double bound) { return (F / bound - 1) / (F / bound + each - 1); };
    return {share(quantile(complement(fisher, half))), share(quantile(fisher, half))};
}

} // namespace lubberline
