#include "core/fleet/SeriesFit.h"

#include <algorithm>
#include <cmath>

#include "core/fleet/FleetSwings.h"

namespace lubberline {

namespace {

constexpr double kExplained = 1e-12; ///< of a column's squared length: less is rounding
constexpr double kRareStep = 0.01, kStepVariance_deg2 = 4.0;

/// Whitened columns, each less what those before it explain. One allocation: a hundred sizes are asked of each series.
class Whitened {
public:
    Whitened(std::span<const DatedValue> series, const ScatterSize& size) : m_n(series.size()), m_room(2 * m_n * m_n + 2 * m_n)
    {
        for (std::size_t i = 0; i < m_n; ++i) {
            for (std::size_t j = 0; j <= i; ++j) {
                const auto& first = series[j];
                double covariance = size.wander_deg2_year * (first.day - series.front().day) / kDaysPerYear
                    + (i == j ? first.variance + first.swingShare * size.swing_deg2 : 0.0);
                for (std::size_t k = 0; k < j; ++k)
                    covariance -= lower(i)[k] * lower(j)[k];
                lower(i)[j] = i == j ? std::sqrt(std::max(covariance, 1e-300)) : covariance / lower(j)[j];
            }
            m_logs += std::log(lower(i)[i]);
        }
    }

    /// Where a column is put before it is whitened.
    [[nodiscard]] std::span<double> column() { return {basis(m_columns), m_n}; }
    void setStep(std::size_t place)
    {
        for (std::size_t i = 0; i < m_n; ++i)
            column()[i] = i < place ? 0.0 : 1.0;
    }

    /// @return its squared length; it starts with zeros up to a place
    double whiten(std::size_t from = 0)
    {
        double* x = basis(m_columns);
        double whole = 0;
        for (std::size_t i = from; i < m_n; ++i) {
            for (std::size_t k = from; k < i; ++k)
                x[i] -= lower(i)[k] * x[k];
            x[i] /= lower(i)[i];
            whole += x[i] * x[i];
        }
        return whole;
    }

    /// Less what the others explain. @return the squared length that is left
    double takeOut()
    {
        double* x = basis(m_columns);
        for (std::size_t b = 0; b < m_columns; ++b) {
            const double along = product(basis(b), x);
            for (std::size_t i = 0; i < m_n; ++i)
                x[i] -= along * basis(b)[i];
        }
        return product(x, x);
    }

    /// The column as one that explains. @return the length that was left of it; 0: it is in the span of the others
    double explain()
    {
        const double whole = whiten();
        takeOut();
        const double left = takeOut(); // once leaves rounding behind
        if (!(left > kExplained * whole))
            return 0;
        const double length = std::sqrt(left);
        for (double& each : column())
            each /= length;
        m_logs += std::log(length);
        ++m_columns;
        return length;
    }

    /// A copy of the column that stays.
    std::span<double> setAside()
    {
        const std::span<double> aside(basis(m_n + 1), m_n);
        std::ranges::copy(column(), aside.begin());
        return aside;
    }

    [[nodiscard]] std::span<const double> last() { return {basis(m_columns - 1), m_n}; }
    [[nodiscard]] int columns() const { return static_cast<int>(m_columns); }
    [[nodiscard]] double logs() const { return m_logs; } ///< of the determinants' roots

    [[nodiscard]] double product(const double* a, const double* b) const
    {
        double sum = 0;
        for (std::size_t i = 0; i < m_n; ++i)
            sum += a[i] * b[i];
        return sum;
    }

private:
    double* lower(std::size_t row) { return m_room.data() + row * m_n; } ///< covariance LLᵀ
    double* basis(std::size_t column) { return m_room.data() + (m_n + column) * m_n; }
    std::size_t m_n, m_columns = 0;
    std::vector<double> m_room;
    double m_logs = 0;
};

} // namespace

SeriesFit fitSeries(
    std::span<const DatedValue> series, const ScatterSize& size, bool trend, std::span<const std::size_t> at, SeriesSteps steps)
{
    SeriesFit fit;
    const std::size_t n = series.size();
    if (n == 0)
        return fit;
    Whitened space(series, size);
    space.setStep(0);
    space.explain();
    for (std::size_t i = 1; i < n; ++i)
        if (series[i].corrected || std::ranges::find(at, i) != at.end()) {
            space.setStep(i);
            space.explain();
        }
    for (std::size_t i = 0; i < n; ++i)
        space.column()[i] = series[i].value - series.front().value;
    space.whiten();
    space.takeOut();
    space.takeOut();
    const std::span<double> residual = space.setAside();
    if (trend) {
        for (std::size_t i = 0; i < n; ++i)
            space.column()[i] = (series[i].day - series.front().day) / kDaysPerYear;
        if (const double length = space.explain(); length > 0) {
            const double along = space.product(space.last().data(), residual.data());
            fit.perYear = along / length;
            fit.perYearError = 1 / length;
            for (std::size_t i = 0; i < n; ++i)
                residual[i] -= along * space.last()[i];
        }
    }
    fit.freedom = static_cast<int>(n) - space.columns();
    fit.logLikelihood = -space.logs() - 0.5 * space.product(residual.data(), residual.data());
    if (steps == SeriesSteps::NotAsked)
        return fit;
    fit.places.reserve(n - 1);
    for (std::size_t place = 1; place < n; ++place) {
        if (series[place].corrected || series[place].day == series[place - 1].day)
            continue;
        space.setStep(place);
        const double whole = space.whiten(place), length2 = space.takeOut();
        if (length2 > kExplained * whole)
            fit.places.push_back({place, space.product(space.column().data(), residual.data()) / std::sqrt(length2), length2});
    }
    return fit;
}

double withRareStep(const SeriesFit& fit)
{
    if (fit.places.empty())
        return fit.logLikelihood;
    double largest = 0;
    std::vector<double> gains;
    gains.reserve(fit.places.size());
    for (const auto& place : fit.places) {
        const double spread = kStepVariance_deg2 * place.length2; // of the step against its error
        gains.push_back(0.5 * (place.statistic * place.statistic * spread / (1 + spread) - std::log1p(spread)));
        largest = std::max(largest, gains.back());
    }
    double sum = (1 - kRareStep) * std::exp(-largest);
    for (const double gain : gains)
        sum += kRareStep / static_cast<double>(gains.size()) * std::exp(gain - largest);
    return fit.logLikelihood + largest + std::log(sum);
}

double withStepAt(const SeriesFit& fit, const SeriesPlace& place)
{
    return fit.logLikelihood + 0.5 * place.statistic * place.statistic - 0.5 * std::log(place.length2);
}

} // namespace lubberline
