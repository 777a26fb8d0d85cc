#include "core/fleet/JumpTest.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include <boost/math/distributions/students_t.hpp>

#include "core/algebra/Cholesky.h"
#include "core/fleet/FleetRandom.h"
#include "core/fleet/FleetSwings.h"
#include "core/fleet/JumpChances.h"
#include "core/fleet/SeriesFit.h"

namespace lubberline {

namespace {

/// A column that keeps less than this of its length is in the span of the others.
constexpr double kInSpan = 1e-6;

void orthogonalise(const Eigen::MatrixXd& basis, Eigen::VectorXd& column)
{
    for (int twice = 0; twice < 2; ++twice) // once leaves rounding behind
        column -= basis * (basis.transpose() * column);
}

bool addTo(Eigen::MatrixXd& basis, Eigen::VectorXd column)
{
    const double length = column.norm();
    orthogonalise(basis, column);
    if (!(column.norm() > kInSpan * length))
        return false;
    basis.conservativeResize(Eigen::NoChange, basis.cols() + 1);
    basis.col(basis.cols() - 1) = column.normalized();
    return true;
}

/// L⁻¹ of the covariance LLᵀ: errors of each figure, and what it wanders by from the first day on (which the level takes up).
Eigen::MatrixXd whitenerOf(std::span<const DatedValue> series, double walk_year)
{
    const auto n = static_cast<Eigen::Index>(series.size());
    if (!(walk_year > 0)) {
        Eigen::VectorXd weight(n);
        for (Eigen::Index i = 0; i < n; ++i)
            weight[i] = 1.0 / std::sqrt(series[static_cast<std::size_t>(i)].variance);
        return weight.asDiagonal();
    }
    Eigen::MatrixXd covariance(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j <= i; ++j) {
            const auto& first = series[static_cast<std::size_t>(j)];
            covariance(i, j) = walk_year * (first.day - series.front().day) / kDaysPerYear + (i == j ? first.variance : 0.0);
        }
    return whitened(choleskyFactor(covariance), Eigen::MatrixXd::Identity(n, n));
}

Eigen::VectorXd stepAt(const Eigen::MatrixXd& whitener, std::size_t place)
{
    return whitener.rightCols(whitener.cols() - static_cast<Eigen::Index>(place)).rowwise().sum();
}

Eigen::VectorXd yearsOf(std::span<const DatedValue> series, const Eigen::MatrixXd& whitener)
{
    Eigen::VectorXd years(whitener.cols());
    for (std::size_t i = 0; i < series.size(); ++i)
        years[static_cast<Eigen::Index>(i)] = (series[i].day - series.front().day) / kDaysPerYear;
    return whitener * years;
}

/// Level, corrections and known jumps.
Eigen::MatrixXd levelsOf(std::span<const DatedValue> series, const JumpOptions& options, const Eigen::MatrixXd& whitener)
{
    Eigen::MatrixXd basis(whitener.rows(), 0);
    addTo(basis, stepAt(whitener, 0));
    for (std::size_t i = 1; i < series.size(); ++i)
        if (series[i].corrected)
            addTo(basis, stepAt(whitener, i));
    for (const auto place : options.at)
        addTo(basis, stepAt(whitener, place));
    return basis;
}

Eigen::VectorXd whitened(std::span<const DatedValue> series, const Eigen::MatrixXd& whitener)
{
    Eigen::VectorXd values(whitener.cols());
    for (std::size_t i = 0; i < series.size(); ++i)
        values[static_cast<Eigen::Index>(i)] = series[i].value - series.front().value;
    return whitener * values;
}

constexpr int kSimulations = 20000;
constexpr double kNeverFound = 0.1; ///< no jump of a p above the false discovery rate is ever kept

} // namespace

JumpDesign::JumpDesign(std::span<const DatedValue> series, const JumpOptions& options) : m_scale(options.scale)
{
    if (series.size() < 3)
        return;
    m_whitener = whitenerOf(series, options.walk_year);
    m_null = levelsOf(series, options, m_whitener);
    if (options.trend)
        addTo(m_null, yearsOf(series, m_whitener));
    m_freedom = static_cast<int>(m_whitener.rows() - m_null.cols());
    if (m_freedom < (m_scale == ErrorScale::Known ? 2 : 3)) // one is no choice of places, or no scatter
        return;
    const auto n = series.size(), edge = static_cast<std::size_t>(options.leastSegment);
    m_steps.resize(static_cast<Eigen::Index>(n), m_whitener.rows());
    m_length.resize(static_cast<Eigen::Index>(n));
    for (std::size_t place = edge; place + edge <= n; ++place) {
        if (series[place].corrected || series[place].day == series[place - 1].day)
            continue;
        Eigen::VectorXd step = stepAt(m_whitener, place);
        const double whole = step.norm();
        orthogonalise(m_null, step);
        const double length = step.norm();
        if (!(length > kInSpan * whole))
            continue;
        const auto row = static_cast<Eigen::Index>(m_places.size());
        m_steps.row(row) = step / length;
        m_length[row] = length;
        m_places.push_back(place);
    }
    m_steps.conservativeResize(static_cast<Eigen::Index>(m_places.size()), Eigen::NoChange);
    m_length.conservativeResize(static_cast<Eigen::Index>(m_places.size()));
}

std::vector<double> JumpDesign::worthOfPlaces(std::span<const double> statistics, int draws) const
{
    const auto count = static_cast<Eigen::Index>(m_places.size()), n = m_whitener.rows();
    ContentSeed seed;
    for (Eigen::Index i = 0; i < m_steps.size(); ++i)
        seed.add(std::round(m_steps.data()[i] * 1e6)); // of the dates, not of their rounding
    FleetRandom random(seed.value());
    const Eigen::MatrixXd correlation = m_steps * m_steps.transpose();
    const auto asked = static_cast<Eigen::Index>(statistics.size());
    Eigen::MatrixXd beyond(asked, draws); // what a place has that is beyond: each an equal share of the tail
    for (Eigen::Index c = 0; c < asked; ++c) {
        const double limit = statistics[static_cast<std::size_t>(c)], tail = normalTail(limit);
        for (int draw = 0; draw < draws; ++draw)
            beyond(c, draw) = tail > 0 ? normalTailQuantile(tail * (draw + 0.5) / draws) : limit;
    }
    Eigen::VectorXd noise(n), z(count);
    std::vector<double> worth(statistics.size(), 0.0);
    for (int draw = 0; draw < draws; ++draw)
        for (Eigen::Index place = 0; place < count; ++place) {
            for (Eigen::Index i = 0; i < n; ++i)
                noise[i] = random.normal();
            z.noalias() = m_steps * noise;
            z -= z[place] * correlation.col(place);
            for (Eigen::Index c = 0; c < asked; ++c) {
                const double limit = statistics[static_cast<std::size_t>(c)], here = beyond(c, draw);
                const auto others = ((z + here * correlation.col(place)).array().abs() >= limit).count();
                worth[static_cast<std::size_t>(c)] += 1.0 / std::max<double>(1.0, static_cast<double>(others));
            }
        }
    for (double& each : worth)
        each = std::clamp(each / draws, 1.0, std::max<double>(1.0, static_cast<double>(count)));
    return worth;
}

std::vector<double> JumpDesign::simulated(int draws) const
{
    ContentSeed seed;
    for (Eigen::Index i = 0; i < m_steps.size(); ++i)
        seed.add(std::round(m_steps.data()[i] * 1e6));
    FleetRandom random(seed.value());
    std::vector<double> statistics;
    Eigen::VectorXd noise(m_whitener.rows());
    for (int draw = 0; draw < draws; ++draw) {
        for (Eigen::Index i = 0; i < noise.size(); ++i)
            noise[i] = random.normal();
        const double squares = noise.squaredNorm() - (m_null.transpose() * noise).squaredNorm();
        const double z2 = (m_steps * noise).array().square().maxCoeff();
        statistics.push_back(std::sqrt(z2 * (m_freedom - 1) / std::max(squares - z2, 1e-300)));
    }
    std::ranges::sort(statistics);
    return statistics;
}

double JumpDesign::chanceBeyond(double statistic, int draws) const
{
    if (m_places.empty())
        return 1.0;
    if (m_scale == ErrorScale::Known) {
        const double c = std::abs(statistic);
        return std::min(1.0, 2 * normalTail(c) * worthOfPlaces({&c, 1}, draws).front());
    }
    const auto all = simulated(draws);
    const auto beyond = all.end() - std::ranges::lower_bound(all, std::abs(statistic));
    return (static_cast<double>(beyond) + 1) / (static_cast<double>(all.size()) + 1);
}

double JumpDesign::criticalValue(double chance, int draws) const
{
    if (m_scale == ErrorScale::Unknown)
        return percentileOf(simulated(draws), 1 - chance);
    double low = normalTailQuantile(0.5 * chance),
           high = normalTailQuantile(0.5 * chance / std::max<std::size_t>(1, m_places.size())) + 0.01;
    for (int round = 0; round < 24; ++round) {
        const double middle = 0.5 * (low + high);
        (chanceBeyond(middle, draws) > chance ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

namespace {

/// With errors that are known. The chance of its place alone: the least that the chance of any place can be.
std::optional<Jump> largestKnown(std::span<const DatedValue> series, const JumpOptions& options)
{
    constexpr int fewest = 2; // one degree of freedom is no choice of places
    if (series.size() < 3)
        return {};
    const SeriesFit fit = fitSeries(series, {0, options.walk_year}, options.trend, options.at);
    if (fit.freedom < fewest)
        return {};
    const auto edge = static_cast<std::size_t>(options.leastSegment);
    const SeriesPlace* best = nullptr;
    for (const auto& each : fit.places)
        if (each.place >= edge && each.place + edge <= series.size() && (!best || std::abs(each.statistic) > std::abs(best->statistic)))
            best = &each;
    if (!best)
        return {};
    const double error = 1 / std::sqrt(best->length2);
    return Jump{best->place - 1, best->place, best->statistic * error, error, best->statistic, 2 * normalTail(std::abs(best->statistic))};
}

} // namespace

struct JumpFinder {
    static std::optional<Jump> largestUnknown(std::span<const DatedValue> series, const JumpOptions& options)
    {
        const JumpDesign design(series, options);
        if (design.m_places.empty())
            return {};
        const Eigen::VectorXd values = whitened(series, design.m_whitener);
        const Eigen::VectorXd z = design.m_steps * values;
        Eigen::Index best = 0;
        z.array().abs().maxCoeff(&best);
        Jump jump;
        jump.before = design.m_places[static_cast<std::size_t>(best)];
        jump.after = jump.before - 1;
        jump.change = z[best] / design.m_length[best];
        const double squares = values.squaredNorm() - (design.m_null.transpose() * values).squaredNorm() - z[best] * z[best];
        const double sigma = std::sqrt(std::max(squares, 0.0) / (design.m_freedom - 1));
        if (!(sigma > 1e-9 * std::abs(z[best]))) // all on steps: no scatter to hold them against
            return {};
        jump.standardError = sigma / design.m_length[best];
        jump.statistic = z[best] / sigma;
        jump.p = design.chanceBeyond(jump.statistic, kSimulations);
        return jump;
    }
};

std::optional<Jump> largestJump(std::span<const DatedValue> series, const JumpOptions& options, JumpChance chance)
{
    if (options.scale == ErrorScale::Unknown)
        return JumpFinder::largestUnknown(series, options);
    auto jump = largestKnown(series, options);
    if (!jump || chance == JumpChance::Least)
        return jump;
    jump->p = chance == JumpChance::Exact || jump->p < kNeverFound
        ? jumpChances().of(jumpPatternOf(series, options))->chanceBeyond(jump->statistic)
        : 1.0;
    return jump;
}

std::optional<Drift> driftOf(std::span<const DatedValue> series, const JumpOptions& options)
{
    if (series.size() < 3)
        return {};
    if (options.scale == ErrorScale::Known) {
        const SeriesFit fit = fitSeries(series, {0, options.walk_year}, true, options.at, SeriesSteps::NotAsked);
        if (!fit.perYear)
            return {};
        const double half = studentFactor(0) * fit.perYearError;
        return Drift{*fit.perYear, fit.perYearError, 2 * normalTail(std::abs(*fit.perYear / fit.perYearError)),
            {*fit.perYear - half, *fit.perYear + half}};
    }
    const Eigen::MatrixXd whitener = whitenerOf(series, options.walk_year);
    Eigen::MatrixXd basis = levelsOf(series, options, whitener);
    const auto levels = basis.cols();
    Eigen::VectorXd years = yearsOf(series, whitener);
    const double whole = years.norm();
    orthogonalise(basis, years);
    const double length = years.norm();
    if (!(length > kInSpan * whole))
        return {};
    const Eigen::VectorXd values = whitened(series, whitener);
    const double z = years.dot(values) / length;
    const int freedom = static_cast<int>(whitener.rows() - levels) - 1;
    if (freedom < 2)
        return {};
    const double sigma = std::sqrt(std::max(0.0, values.squaredNorm() - (basis.transpose() * values).squaredNorm() - z * z) / freedom);
    if (!(sigma > 1e-12))
        return {};
    Drift drift;
    drift.perYear = z / length;
    drift.standardError = sigma / length;
    drift.p = 2 * cdf(complement(boost::math::students_t(freedom), std::abs(z / sigma)));
    const double half = studentFactor(freedom) * drift.standardError;
    drift.interval95 = {drift.perYear - half, drift.perYear + half};
    return drift;
}

} // namespace lubberline
