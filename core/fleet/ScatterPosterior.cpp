#include "core/fleet/ScatterPosterior.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

namespace lubberline {

namespace {

constexpr std::array kSwings_deg{0.0, 0.05, 0.1, 0.17, 0.25, 0.35, 0.5, 0.7, 1.0, 1.5, 2.2};
constexpr std::array kWanders_deg{0.0, 0.05, 0.1, 0.15, 0.2, 0.28, 0.4, 0.55, 0.8, 1.2, 1.8}; ///< in the root of a year
constexpr std::size_t kMostHistories = 150;                                                   ///< that are asked: more tell little more
constexpr double kNeverAJump = 0.3;             ///< a chance above it never comes to be a discovery
constexpr double kNoWeight = 1e-6, kNoLog = 14; ///< its logarithm

template <std::size_t n>
double widthAt(const std::array<double, n>& grid, std::size_t i)
{
    return (i + 1 < n ? grid[i + 1] : 1.3 * grid[i]) - (i > 0 ? grid[i - 1] : 0.0);
}

std::vector<double> normalised(const std::vector<double>& logs)
{
    const double largest = *std::ranges::max_element(logs);
    std::vector<double> weights;
    double sum = 0;
    for (const double each : logs)
        sum += weights.emplace_back(std::exp(each - largest));
    for (double& each : weights)
        each = each < kNoWeight * sum ? 0.0 : each / sum;
    return weights;
}

/// A mixture of normal distributions.
struct Mixture {
    std::vector<double> weight, mean, error;
    [[nodiscard]] double above(double x) const
    {
        double chance = 0;
        for (std::size_t i = 0; i < weight.size(); ++i)
            chance += weight[i] * normalTail((x - mean[i]) / error[i]);
        return chance;
    }
    [[nodiscard]] double below(double x) const
    {
        double chance = 0;
        for (std::size_t i = 0; i < weight.size(); ++i)
            chance += weight[i] * normalTail((mean[i] - x) / error[i]);
        return chance;
    }
    [[nodiscard]] std::pair<double, double> moments() const
    {
        double middle = 0, square = 0;
        for (std::size_t i = 0; i < weight.size(); ++i)
            middle += weight[i] * mean[i];
        for (std::size_t i = 0; i < weight.size(); ++i)
            square += weight[i] * (error[i] * error[i] + (mean[i] - middle) * (mean[i] - middle));
        return {middle, std::sqrt(square)};
    }
    /// Where so much is above. By Newton's steps, which are halved away where they leave what is known to hold it.
    [[nodiscard]] double quantile(double chanceAbove, double start) const
    {
        double low = mean.front(), high = low;
        for (std::size_t i = 0; i < weight.size(); ++i) {
            low = std::min(low, mean[i] - 8 * error[i]);
            high = std::max(high, mean[i] + 8 * error[i]);
        }
        constexpr int most = 60;
        double x = std::clamp(start, low, high);
        for (int step = 0; step < most; ++step) {
            double beyond = -chanceAbove, density = 0;
            for (std::size_t i = 0; i < weight.size(); ++i) {
                const double z = (x - mean[i]) / error[i];
                beyond += weight[i] * normalTail(z);
                density += weight[i] * std::exp(-0.5 * z * z) / (error[i] * std::sqrt(2 * std::numbers::pi));
            }
            (beyond > 0 ? low : high) = x;
            double next = density > 0 ? x + beyond / density : low;
            if (!(next > low && next < high))
                next = 0.5 * (low + high);
            if (std::abs(next - x) <= 1e-12 * (high - low) + 1e-11 * std::abs(x))
                return next;
            x = next;
        }
        return x;
    }
};

} // namespace

ScatterPosterior::ScatterPosterior(const std::map<std::size_t, std::vector<DatedValue>>& series)
{
    std::vector<std::size_t> coarse, fine;
    for (std::size_t s = 0; s < kSwings_deg.size(); ++s)
        for (std::size_t w = 0; w < kWanders_deg.size(); ++w) {
            const double swing = kSwings_deg[s], wander = kWanders_deg[w];
            (s % 2 == 0 && w % 2 == 0 ? coarse : fine).push_back(m_sizes.size());
            m_sizes.push_back({swing * swing, wander * wander});
            m_log.push_back(std::log(widthAt(kSwings_deg, s) * widthAt(kWanders_deg, w)) - 2 * std::log1p(std::pow(swing / 0.5, 2))
                + std::log(wander + 0.02) - 1.75 * std::log1p(std::pow(wander / 0.35, 2)));
        }
    std::map<std::size_t, std::vector<DatedValue>> asked;
    std::size_t number = 0;
    for (const auto& [history, values] : series) { // evenly among them where there are many
        const std::size_t before = number * kMostHistories / series.size(), after = (number + 1) * kMostHistories / series.size();
        ++number;
        if ((series.size() <= kMostHistories || after > before) && values.size() >= 3)
            asked[history] = values;
    }
    tell(asked, coarse);
    // Between the coarse sizes only where something is possible.
    constexpr std::size_t wanders = kWanders_deg.size();
    double largest = -std::numeric_limits<double>::infinity();
    for (const auto i : coarse)
        largest = std::max(largest, m_log[i]);
    std::erase_if(fine, [&](std::size_t i) {
        return std::ranges::none_of(coarse, [&](std::size_t j) {
            const auto apart = [](std::size_t a, std::size_t b) { return a > b ? a - b : b - a; };
            return apart(i / wanders, j / wanders) < 2 && apart(i % wanders, j % wanders) < 2 && m_log[j] > largest - kNoLog;
        });
    });
    tell(asked, fine);
    std::vector<std::size_t> kept = coarse;
    kept.insert(kept.end(), fine.begin(), fine.end());
    std::ranges::sort(kept);
    for (const auto i : kept)
        largest = std::max(largest, m_log[i]);
    std::erase_if(kept, [&](std::size_t i) { return m_log[i] < largest - kNoLog; });
    keep(kept);
}

/// Adds to the logarithms of these sizes.
void ScatterPosterior::tell(const std::map<std::size_t, std::vector<DatedValue>>& series, const std::vector<std::size_t>& sizes)
{
    SeriesFit fit;
    for (const auto& [history, values] : series) {
        Told& told = m_told[history];
        for (auto* column : {&told.log, &told.perYear, &told.perYearError})
            column->resize(m_sizes.size());
        SeriesFitter fitter(values, true, {});
        for (const auto i : sizes) {
            fitter.fit(m_sizes[i], SeriesSteps::Asked, fit);
            told.log[i] = withRareStep(fit);
            told.perYear[i] = fit.perYear.value_or(0);
            told.perYearError[i] = fit.perYearError;
            m_log[i] += told.log[i];
        }
    }
}

void ScatterPosterior::keep(const std::vector<std::size_t>& sizes)
{
    const auto picked = [&](auto& column) {
        auto some = column;
        some.clear();
        for (const auto i : sizes)
            some.push_back(column[i]);
        column = std::move(some);
    };
    picked(m_sizes);
    picked(m_log);
    for (auto& [history, told] : m_told)
        for (auto* column : {&told.log, &told.perYear, &told.perYearError})
            picked(*column);
}

ScatterSize ScatterPosterior::mean() const
{
    const auto weights = normalised(m_log);
    ScatterSize mean;
    for (std::size_t i = 0; i < m_sizes.size(); ++i) {
        mean.swing_deg2 += weights[i] * m_sizes[i].swing_deg2;
        mean.wander_deg2_year += weights[i] * m_sizes[i].wander_deg2_year;
    }
    return mean;
}

std::vector<double> ScatterPosterior::without(std::size_t history) const
{
    auto logs = m_log;
    if (const auto own = m_told.find(history); own != m_told.end())
        for (std::size_t i = 0; i < logs.size(); ++i)
            logs[i] -= own->second.log[i];
    return logs;
}

std::optional<Drift> ScatterPosterior::drift(std::size_t history, std::span<const DatedValue> series, std::span<const std::size_t> at) const
{
    if (series.size() < 3)
        return {};
    if (const auto own = m_told.find(history); own != m_told.end() && at.empty())
        return mixed(m_log, own->second);
    auto logs = without(history);
    Told told;
    SeriesFitter fitter(series, true, at);
    SeriesFit fit;
    for (std::size_t i = 0; i < m_sizes.size(); ++i) {
        fitter.fit(m_sizes[i], SeriesSteps::Asked, fit);
        told.perYear.push_back(fit.perYear.value_or(0));
        told.perYearError.push_back(fit.perYearError);
        logs[i] += withRareStep(fit);
    }
    return mixed(logs, told);
}

std::optional<Drift> ScatterPosterior::mixed(const std::vector<double>& logs, const Told& told) const
{
    const auto weights = normalised(logs);
    Mixture mixture;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        if (!(told.perYearError[i] > 0)) // the dates do not tell it
            return {};
        if (weights[i] > 0) {
            mixture.weight.push_back(weights[i]);
            mixture.mean.push_back(told.perYear[i]);
            mixture.error.push_back(told.perYearError[i]);
        }
    }
    Drift drift;
    std::tie(drift.perYear, drift.standardError) = mixture.moments();
    drift.p = std::min(1.0, 2 * std::min(mixture.above(0), mixture.below(0)));
    const double half = studentFactor(0) * drift.standardError;
    drift.interval95 = {mixture.quantile(0.975, drift.perYear - half), mixture.quantile(0.025, drift.perYear + half)};
    return drift;
}

std::optional<Jump> ScatterPosterior::jump(
    std::size_t history, std::span<const DatedValue> series, std::span<const std::size_t> at, bool trend) const
{
    constexpr int fewest = 2; // one degree of freedom is no choice of places
    if (series.size() < 3)
        return {};
    SeriesFitter fitter(series, trend, at);
    std::vector<SeriesFit> fits(1);
    fitter.fit(m_sizes.front(), SeriesSteps::Asked, fits.front());
    const std::size_t count = fits.front().places.size();
    if (count == 0 || fits.front().freedom < fewest)
        return {};
    const auto chanceIn = [count](double statistic) { // of any place, or less
        return std::min(1.0, static_cast<double>(count) * 2 * normalTail(std::abs(statistic)));
    };
    // What is nothing in the least scatter is nothing in more.
    if (std::ranges::all_of(fits.front().places, [&](auto& place) { return chanceIn(place.statistic) > kNeverAJump; }))
        return Jump{fits.front().places.front().place - 1, fits.front().places.front().place, 0, 0, 0, 1};
    fits.resize(m_sizes.size());
    for (std::size_t i = 1; i < m_sizes.size(); ++i)
        fitter.fit(m_sizes[i], SeriesSteps::Asked, fits[i]);
    if (std::ranges::any_of(fits, [&](auto& fit) { return fit.places.size() != count; }))
        return {};
    auto logs = without(history);
    std::size_t best = 0;
    double largest = -1;
    const auto before = normalised(logs);
    for (std::size_t place = 0; place < count; ++place) {
        double statistic = 0;
        for (std::size_t i = 0; i < fits.size(); ++i)
            statistic += before[i] * std::abs(fits[i].places[place].statistic);
        if (statistic > largest) {
            largest = statistic;
            best = place;
        }
    }
    for (std::size_t i = 0; i < fits.size(); ++i)
        logs[i] += withStepAt(fits[i], fits[i].places[best]);
    const auto weights = normalised(logs);
    Mixture sizes;
    double chance = 0;
    for (std::size_t i = 0; i < fits.size(); ++i) {
        if (!(weights[i] > 0))
            continue;
        const auto& place = fits[i].places[best];
        sizes.weight.push_back(weights[i]);
        sizes.error.push_back(1 / std::sqrt(place.length2));
        sizes.mean.push_back(place.statistic * sizes.error.back());
        chance += weights[i] * chanceIn(place.statistic);
    }
    Jump jump;
    jump.before = fits.front().places[best].place;
    jump.after = jump.before - 1;
    std::tie(jump.change, jump.standardError) = sizes.moments();
    jump.statistic = jump.change / jump.standardError;
    jump.p = std::min(1.0, chance);
    return jump;
}

} // namespace lubberline
