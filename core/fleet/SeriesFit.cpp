#include "core/fleet/SeriesFit.h"

#include <algorithm>
#include <cmath>

#include "core/fleet/FleetSwings.h"

namespace lubberline {

namespace {

constexpr double kExplained = 1e-12;     ///< of a step's squared length: less is rounding
constexpr double kLeastVariance = 1e-60; ///< of a figure that is said to have no error [deg²]
constexpr double kRareStep = 0.01, kStepVariance_deg2 = 4.0;

/// Half the logarithm of a product of variances; logarithms are taken seldom.
class HalfLog {
public:
    void times(double variance)
    {
        m_product *= variance;
        if (m_product > 1e150 || m_product < 1e-150)
            take();
    }
    [[nodiscard]] double value() const { return m_sum + 0.5 * std::log(m_product); }

private:
    void take()
    {
        m_sum += 0.5 * std::log(m_product);
        m_product = 1;
    }
    double m_sum = 0, m_product = 1;
};

} // namespace

SeriesFitter::SeriesFitter(std::span<const DatedValue> series, bool trend, std::span<const std::size_t> at) : m_trend(trend)
{
    m_figures.reserve(series.size());
    for (std::size_t i = 0; i < series.size(); ++i) {
        const DatedValue &one = series[i], &before = series[i == 0 ? 0 : i - 1];
        const bool known = i == 0 || one.corrected || std::ranges::find(at, i) != at.end();
        m_figures.push_back({one.value - series.front().value, (one.day - series.front().day) / kDaysPerYear,
            (one.day - before.day) / kDaysPerYear, one.variance, one.swingShare, known, !known && one.day != before.day});
        m_levels += known ? 1 : 0;
    }
    m_error.resize(series.size());
    m_before.resize(series.size());
}

void SeriesFitter::fit(const ScatterSize& size, SeriesSteps steps, SeriesFit& into)
{
    into.places.clear();
    into.perYear.reset();
    into.logLikelihood = into.perYearError = 0;
    into.freedom = static_cast<int>(m_figures.size()) - m_levels;
    HalfLog logs;
    double yearsSquared = 0, along = 0, valuesSquared = 0; // products of innovations over their variances
    Level level{};
    for (std::size_t i = 0; i < m_figures.size(); ++i) {
        const Figure& figure = m_figures[i];
        const double error = m_error[i] = std::max(figure.variance + figure.swingShare * size.swing_deg2, kLeastVariance);
        if (figure.known) {
            level = {error, figure.value, figure.years};
        } else {
            const double expected = level.variance + size.wander_deg2_year * figure.gap, variance = expected + error;
            const double value = figure.value - level.value, years = figure.years - level.years;
            const double weight = 1 / variance, gain = expected * weight;
            logs.times(variance);
            valuesSquared += value * value * weight;
            along += value * years * weight;
            yearsSquared += years * years * weight;
            level = {error * gain, level.value + gain * value, level.years + gain * years};
        }
        m_before[i] = level;
    }
    double trend = 0;
    into.logLikelihood = -logs.value();
    if (m_trend && yearsSquared > 0) {
        trend = along / yearsSquared;
        into.perYear = trend;
        into.perYearError = 1 / std::sqrt(yearsSquared);
        into.freedom -= 1;
        into.logLikelihood -= 0.5 * std::log(yearsSquared);
        valuesSquared -= along * trend;
    }
    into.logLikelihood -= 0.5 * std::max(0.0, valuesSquared);
    if (steps == SeriesSteps::NotAsked || m_figures.empty())
        return;
    const double ofTrend = into.perYear ? 1 / yearsSquared : 0;
    into.places.reserve(m_figures.size() - 1);
    level = {m_error.back(), m_figures.back().value, m_figures.back().years};
    for (std::size_t i = m_figures.size() - 1; i > 0; --i) { // level: from this figure and those after it
        const Figure &figure = m_figures[i], &next = m_figures[i - 1];
        const double expected = level.variance + size.wander_deg2_year * figure.gap;
        if (figure.asked) {
            const double weight = 1 / (m_before[i - 1].variance + expected);
            const double step = (level.value - m_before[i - 1].value) * weight, years = (level.years - m_before[i - 1].years) * weight;
            const double length2 = weight - years * years * ofTrend;
            if (length2 > kExplained * weight)
                into.places.push_back({i, (step - years * trend) / std::sqrt(length2), length2});
        }
        const double error = m_error[i - 1];
        if (figure.known) {
            level = {error, next.value, next.years};
        } else {
            const double gain = expected / (expected + error);
            level = {error * gain, level.value + gain * (next.value - level.value), level.years + gain * (next.years - level.years)};
        }
    }
    std::ranges::reverse(into.places);
}

SeriesFit fitSeries(
    std::span<const DatedValue> series, const ScatterSize& size, bool trend, std::span<const std::size_t> at, SeriesSteps steps)
{
    SeriesFit fit;
    SeriesFitter(series, trend, at).fit(size, steps, fit);
    return fit;
}

double withRareStep(const SeriesFit& fit)
{
    if (fit.places.empty())
        return fit.logLikelihood;
    const auto spreadOf = [](const SeriesPlace& place) { return kStepVariance_deg2 * place.length2; }; // of the step against its error
    const auto explained = [&](const SeriesPlace& place) {
        const double spread = spreadOf(place);
        return 0.5 * place.statistic * place.statistic * spread / (1 + spread);
    };
    double largest = 0;
    for (const auto& place : fit.places)
        largest = std::max(largest, explained(place));
    double gains = 0;
    for (const auto& place : fit.places)
        gains += std::exp(explained(place) - largest) / std::sqrt(1 + spreadOf(place));
    const double sum = (1 - kRareStep) * std::exp(-largest) + kRareStep / static_cast<double>(fit.places.size()) * gains;
    return fit.logLikelihood + largest + std::log(sum);
}

double withStepAt(const SeriesFit& fit, const SeriesPlace& place)
{
    return fit.logLikelihood + 0.5 * place.statistic * place.statistic - 0.5 * std::log(place.length2);
}

} // namespace lubberline
