#include "core/inflight/ContinuousSwing.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include <boost/math/distributions/chi_squared.hpp>

#include "core/algebra/Spectra.h"
#include "core/angle/Angle.h"
#include "core/base/Number.h"

namespace lubberline {

namespace {

constexpr double kDay_s = 86400.0;
constexpr double kUntold_deg = 3.0; ///< a standard deviation above this says nothing of a coefficient
constexpr double kOwnShare = 0.99;  ///< of a coefficient outside the null directions
constexpr std::size_t kMostPoints = 500;

StateFilter filterOf(const ContinuousOptions& options)
{
    return options.start ? StateFilter(options.start->state_deg, options.start->covariance)
                         : StateFilter(coreStates(options.wholeModelOver_nT.has_value()) + 2 * static_cast<int>(options.loads.size()));
}

/// "A + 0.6 E", the largest first.
std::string directionText(const StateFilter::State& direction, const std::vector<std::string>& names)
{
    std::vector<Eigen::Index> order;
    for (Eigen::Index i = 0; i < direction.size(); ++i)
        if (std::abs(direction(i)) > 0.2 * direction.cwiseAbs().maxCoeff())
            order.push_back(i);
    std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) { return std::abs(direction(a)) > std::abs(direction(b)); });
    std::string text;
    for (const auto i : order) {
        const double share = direction(i) / direction(order.front());
        const std::string size = std::abs(share) > 0.95 ? std::string() : figureText(std::abs(share), 1) + " ";
        text += (text.empty() ? "" : share < 0 ? " \u2212 " : " + ") + size + names[static_cast<std::size_t>(i)];
    }
    return text;
}

constexpr double kUnknownLoad_deg_A = 10.0; ///< nobody has seen more of one ampere

} // namespace

StateFilter::State continuousRow(double compass_deg, const std::vector<double>& current_A, std::size_t loads)
{
    const double heading = toRadians(compass_deg);
    StateFilter::State row(static_cast<Eigen::Index>(5 + 2 * loads));
    row.head<5>() << 1.0, std::sin(heading), std::cos(heading), std::sin(2 * heading), std::cos(2 * heading);
    for (std::size_t load = 0; load < loads; ++load) {
        const double amperes = load < current_A.size() ? current_A[load] : 0.0;
        row(static_cast<Eigen::Index>(5 + 2 * load)) = amperes * row(1);
        row(static_cast<Eigen::Index>(6 + 2 * load)) = amperes * row(2);
    }
    return row;
}

ContinuousState withLoads(const ContinuousState& state, const std::vector<std::string>& loads)
{
    ContinuousState wide = state;
    const auto known = state.state_deg.size(), all = known + 2 * static_cast<Eigen::Index>(loads.size());
    wide.loads = loads;
    wide.state_deg = StateFilter::State::Zero(all);
    wide.state_deg.head(known) = state.state_deg;
    wide.covariance = StateFilter::Covariance::Identity(all, all) * (kUnknownLoad_deg_A * kUnknownLoad_deg_A);
    wide.covariance.topLeftCorner(known, known) = state.covariance;
    wide.covariance.topRightCorner(known, all - known).setZero();
    wide.covariance.bottomLeftCorner(all - known, known).setZero();
    return wide;
}

ContinuousSwing::ContinuousSwing(const ContinuousOptions& options)
    : m_options(options)
    , m_filter(filterOf(options))
    , m_watch(m_filter.states())
    , m_previousRow(StateFilter::State::Zero(m_filter.states()))
{
    if (options.wholeModelOver_nT)
        m_names.assign(kModelNames.begin(), kModelNames.end());
    else
        m_names = {"A", "B", "C", "D", "E"};
    for (const auto& load : options.loads)
        for (const char letter : {'B', 'C'})
            m_names.push_back(std::string(1, letter) + " per A of " + load);
    if (options.start)
        m_before = options.start->updates;
}

void ContinuousSwing::add(const ContinuousSample& sample)
{
    keepPrint(sample);
    const auto stated_deg = sample.referenceError_deg ? sample.referenceError_deg : m_options.noise_deg;
    if (!sample.leg) {
        endLeg();
        update(sample, stated_deg ? std::optional(*stated_deg * *stated_deg) : std::nullopt);
        const std::size_t place = static_cast<std::size_t>(wrap360(sample.compassHeading_deg) / 10.0) % 36;
        auto& sector = m_sectors[place];
        if (sector.samples == 0) {
            sector.time_s = sample.time_s;
            sector.compassHeading_deg = sample.compassHeading_deg;
            sector.deviation_deg = sample.deviation_deg;
        }
        // From the first of the sector, so that 359 and 1 are together, and +179 and −179 of a compass that reads the reciprocal.
        m_sectorOff[place] += wrap180(sample.compassHeading_deg - sector.compassHeading_deg);
        m_sectorDeviation[place] += wrap180(sample.deviation_deg - sector.deviation_deg);
        ++sector.samples;
        return;
    }
    if (m_legSamples > 0 && *sample.leg != m_leg)
        endLeg();
    if (m_legSamples == 0) {
        m_leg = *sample.leg;
        m_legFirst = sample.deviation_deg;
        m_legCurrent.assign(m_options.loads.size(), 0.0);
        m_legAt = {};
    }
    ++m_legSamples;
    m_legSine += std::sin(toRadians(sample.compassHeading_deg));
    m_legCosine += std::cos(toRadians(sample.compassHeading_deg));
    m_legDeviation += wrap180(sample.deviation_deg - m_legFirst);
    m_legStated = (m_legStated || m_legSamples == 1) && stated_deg.has_value();
    m_legVariance += stated_deg ? *stated_deg * *stated_deg : 0.0;
    m_legTime += sample.time_s;
    m_legAt.pitch_deg += sample.at.pitch_deg;
    m_legAt.roll_deg += sample.at.roll_deg;
    m_legAt.field.horizontal_nT += sample.at.field.horizontal_nT;
    m_legAt.field.down_nT += sample.at.field.down_nT;
    for (std::size_t i = 0; i < m_legCurrent.size() && i < sample.current_A.size(); ++i)
        m_legCurrent[i] += sample.current_A[i];
}

/// Readings of one leg share what is wrong with the reference: they are one update with the error of one.
void ContinuousSwing::endLeg()
{
    if (m_legSamples == 0)
        return;
    const double n = m_legSamples;
    LegMean mean{m_leg, m_legTime / n, wrap360(toDegrees(std::atan2(m_legSine, m_legCosine))), wrap180(m_legFirst + m_legDeviation / n),
        m_legSamples};
    ContinuousSample whole{mean.time_s, mean.compassHeading_deg, mean.deviation_deg, {}, {}, m_legCurrent,
        {m_legAt.pitch_deg / n, m_legAt.roll_deg / n, {m_legAt.field.horizontal_nT / n, m_legAt.field.down_nT / n}}};
    for (double& current : whole.current_A)
        current /= n;
    const auto variance = m_legStated ? std::optional(m_legVariance / n) : std::nullopt;
    m_legSamples = 0;
    m_legSine = m_legCosine = m_legDeviation = m_legVariance = m_legTime = 0;
    m_legs.push_back(mean);
    update(whole, variance);
}

StateFilter::State ContinuousSwing::rowOf(const ContinuousSample& sample) const
{
    StateFilter::State row = continuousRow(sample.compassHeading_deg, sample.current_A, m_options.loads.size());
    if (!m_options.wholeModelOver_nT)
        return row;
    const auto at = [&](double deviation_deg) {
        StateFilter::State whole(m_filter.states());
        whole << modelRow(sample.compassHeading_deg, deviation_deg, sample.at, *m_options.wholeModelOver_nT), row.tail(row.size() - 5);
        return whole;
    };
    // The field is turned by what is expected once it is told: turned by what was read, the row would hold the reading's own error, and draw
    // a, e and R after it.
    const StateFilter::State read = at(sample.deviation_deg);
    if (!m_filter.told())
        return read;
    const double expected_deg = toDegrees(std::asin(std::clamp(toRadians(read.dot(m_filter.state())), -1.0, 1.0)));
    return at(std::abs(sample.deviation_deg) > 90 ? 180.0 - expected_deg : expected_deg); // of the two with one sine
}

/// A deviation lies round a circle: the nearest turn to what is expected, or to the first while nothing is. Of a whole model it is a sine.
double ContinuousSwing::measured(const ContinuousSample& sample, const StateFilter::State& row) const
{
    if (m_options.wholeModelOver_nT)
        return toDegrees(std::sin(toRadians(sample.deviation_deg)));
    const double about_deg = m_filter.told() ? row.dot(m_filter.state()) : m_firstDeviation_deg.value_or(sample.deviation_deg);
    return about_deg + wrap180(sample.deviation_deg - about_deg);
}

void ContinuousSwing::update(const ContinuousSample& sample, std::optional<double> variance)
{
    constexpr std::size_t kToLearn = 100;
    m_unstated = m_unstated || !variance;
    m_turnSine += std::sin(toRadians(sample.deviation_deg));
    m_turnCosine += std::cos(toRadians(sample.deviation_deg));
    if (!m_firstDeviation_deg)
        m_firstDeviation_deg = sample.deviation_deg;
    if (m_learnt) {
        take(sample, variance.value_or(m_noiseFound));
        return;
    }
    m_waiting.push_back({sample, variance});
    if (m_waiting.size() == kToLearn)
        learnNoise();
}

void ContinuousSwing::take(const ContinuousSample& sample, double variance)
{
    const double time_s = sample.time_s;
    if (m_options.drift_deg > 0 && m_last_s)
        m_filter.widen(StateFilter::State::Constant(
            m_filter.states(), m_options.drift_deg * m_options.drift_deg * std::max(0.0, time_s - *m_last_s) / kDay_s));
    m_last_s = time_s;
    ++m_updates;
    Kept kept;
    m_lastAt = sample.at;
    kept.h = rowOf(sample);
    kept.before = m_filter.state();
    kept.z = measured(sample, kept.h);
    kept.time_s = time_s;
    const double ratio = noiseRatio();
    const auto innovation = m_filter.update(kept.h, kept.z, variance, kGate * std::sqrt(ratio));
    if (innovation.told) {
        m_gated += innovation.taken ? 0 : 1;
        kept.variance = innovation.variance * ratio;
        kept.noise = variance * ratio;
        const double square = innovation.value * innovation.value / innovation.variance;
        m_nis += square;
        m_scale.take(square);
        watch(kept, std::clamp(innovation.value / std::sqrt(kept.variance), -kGate, kGate)); // one update alone names nothing
    }
    keepPoint(time_s);
}

void ContinuousSwing::keepPoint(double time_s)
{
    if (!m_filter.told() || m_updates % m_stride != 0)
        return;
    if (m_options.wholeModelOver_nT) {
        const auto rows = levelRows(m_lastAt.field, *m_options.wholeModelOver_nT);
        const auto core = m_filter.covariance().topLeftCorner<kModelStates, kModelStates>();
        ContinuousPoint point{time_s, StateFilter::State(rows.size()), StateFilter::State(rows.size())};
        for (std::size_t c = 0; c < rows.size(); ++c) {
            const auto place = static_cast<Eigen::Index>(c);
            point.state_deg(place) = rows[c].dot(m_filter.state().head<kModelStates>());
            point.standardError_deg(place) = std::sqrt(noiseRatio() * std::max(0.0, rows[c].dot(core * rows[c])));
        }
        m_history.push_back(point);
    } else {
        m_history.push_back(
            {time_s, m_filter.state(), std::sqrt(noiseRatio()) * m_filter.covariance().diagonal().cwiseMax(0.0).cwiseSqrt()});
        m_history.back().state_deg(0) = wrap180(m_history.back().state_deg(0));
    }
    if (m_history.size() < kMostPoints)
        return;
    for (std::size_t i = 0; 2 * i < m_history.size(); ++i)
        m_history[i] = m_history[2 * i];
    m_history.resize(m_history.size() / 2);
    m_stride *= 2;
}

ContinuousResult ContinuousSwing::finish()
{
    endLeg();
    learnNoise();
    nameChange();
    ContinuousResult result;
    result.names = m_names;
    result.historyNames = m_options.wholeModelOver_nT ? std::vector<std::string>{"A", "B", "C", "D", "E"} : m_names;
    result.updates = m_updates;
    result.gated = m_gated;
    result.told = m_filter.told();
    result.alarms = m_alarms;
    result.history = m_history;
    if (m_whitened > 0) {
        const auto n = static_cast<double>(m_whitened);
        result.nisMean = m_nis / n;
        if (m_whitened > 20 && m_square > 0) {
            double statistic = 0; // Ljung and Box
            for (std::size_t lag = 1; lag <= m_lags.size(); ++lag)
                statistic += std::pow(m_lags[lag - 1] / m_square, 2) / (n - static_cast<double>(lag));
            result.whitenessP = cdf(complement(boost::math::chi_squared(static_cast<double>(m_lags.size())), n * (n + 2) * statistic));
            result.correlation = m_product / m_square;
        }
    }
    if (m_unstated || m_scale.scatter().contradicts())
        result.noiseRatio = m_scale.scatter().ratio;
    if (m_unstated) {
        result.noise_deg = std::sqrt(m_noiseFound * result.noiseRatio);
        result.warnings.push_back({MARKED("core", "no error of a pair of headings is stated: %1\u00B0 is taken, as they scatter"),
            figureText(*result.noise_deg, 2)});
    }
    if (m_turnCosine < -std::abs(m_turnSine))
        result.warnings.push_back(
            MARKED("core", "the compass reads the reciprocal: look whether it was read from the other side, or is mounted back to front"));
    if (const double rho = correlation(); rho > 0) {
        result.widened = widening();
        result.warnings.push_back(
            {MARKED("core",
                 "neighbouring innovations resemble each other (correlation %1): errors of the reference last longer than an update; standard errors are widened %2 times"),
                figureText(rho, 2), figureText(std::sqrt(result.widened), 1)});
    }

    // What the headings tell, and what not.
    const SymmetricParts parts = symmetricParts(m_filter.information());
    StateFilter::Covariance untold = StateFilter::Covariance::Zero(m_filter.states(), m_filter.states());
    for (int i = 0; i < m_filter.states(); ++i)
        if (parts.values(i) < 1.0 / (kUntold_deg * kUntold_deg)) {
            const StateFilter::State direction = parts.vectors.col(i);
            untold += direction * direction.transpose();
            result.nullDirections.push_back(
                {MARKED("core", "%1 is not told by the headings and loads so far"), directionText(direction, m_names)});
        }
    const auto partial = m_filter.partial();
    // What a row makes of the state, with its standard error; nothing where it is not told.
    const auto tell = [&](const StateFilter::State& row, std::optional<double>& value, std::optional<double>& error) {
        const double left = row.dot(untold * row);
        if (left >= (1.0 - kOwnShare) * row.squaredNorm())
            return;
        double variance = left * 4.0; // a usual size of what is not told leaks
        for (int j = 0; j < m_filter.states(); ++j)
            if (parts.values(j) >= 1.0 / (kUntold_deg * kUntold_deg))
                variance += std::pow(parts.vectors.col(j).dot(row), 2) / parts.values(j);
        value = row.dot(partial);
        error = std::sqrt(variance * result.widened * result.noiseRatio);
    };
    for (int i = 0; i < m_filter.states(); ++i)
        tell(StateFilter::State::Unit(m_filter.states(), i), result.state_deg.emplace_back(), result.standardError_deg.emplace_back());
    if (!m_options.wholeModelOver_nT && result.state_deg.front())
        result.state_deg.front() = wrap180(*result.state_deg.front()); // A, of one that reads the reciprocal
    if (const auto over_nT = m_options.wholeModelOver_nT; over_nT && m_last_s) {
        result.whole.emplace().field = m_lastAt.field;
        if (std::all_of(result.state_deg.begin(), result.state_deg.begin() + kModelStates, [](const auto& one) { return one.has_value(); }))
            result.whole->model = modelOf(partial, *over_nT);
        const auto rows = levelRows(m_lastAt.field, *over_nT);
        for (std::size_t c = 0; c < rows.size(); ++c) {
            StateFilter::State row = StateFilter::State::Zero(m_filter.states());
            row.head<kModelStates>() = rows[c];
            tell(row, result.whole->level_deg[c], result.whole->levelError_deg[c]);
        }
    }
    if (result.told && m_last_s)
        result.state = {*m_last_s, m_before + m_updates, m_options.loads, m_options.wholeModelOver_nT, m_filter.state(),
            keptCovariance(result.noiseRatio), m_options.start ? m_options.start->logs : std::vector<TakenLog>()};
    result.state.logs.push_back(m_log);
    result.log = m_log;
    for (const auto& alarm : m_alarms) {
        Message words{MARKED("core", "the iron changed: %1 by %2\u00B0 \u00B1 %3\u00B0, between %4 s and %5 s"), alarm.coefficient,
            signedFigureText(alarm.change_deg, 2), figureText(alarm.standardError_deg, 2), figureText(alarm.from_s, 0),
            figureText(alarm.to_s, 0)};
        if (!alarm.orElse.empty()) {
            std::string others = alarm.orElse.front();
            for (std::size_t i = 1; i < alarm.orElse.size(); ++i)
                others += ", " + alarm.orElse[i];
            words = {MARKED("core", "%1; or another coefficient did, which explains as much on the headings since: %2"), words, others};
        }
        result.warnings.push_back(words);
    }
    if (result.nisMean && m_whitened > 40 && (*result.nisMean > 1.5 || *result.nisMean < 0.6))
        result.warnings.push_back(m_unstated
                ? Message{MARKED("core",
                              "the error of the headings changed on the way: in all they scatter %1 times as much as the first of them"),
                    figureText(std::sqrt(*result.nisMean), 1)}
                : Message{
                    MARKED("core",
                        "the innovations are %1 times what the stated errors allow: the error of the reference is stated wrongly, or it changed; alarms and standard errors are by the innovations where they are the larger"),
                    figureText(std::sqrt(*result.nisMean), 1)});
    if (m_gated > 0)
        result.warnings.push_back({MARKED_N("core", "%n reading(s) not taken, too far from what was expected"), m_gated});
    result.legs = m_legs;
    if (result.legs.empty())
        for (std::size_t i = 0; i < m_sectors.size(); ++i)
            if (LegMean mean = m_sectors[i]; mean.samples > 0) {
                mean.compassHeading_deg = wrap360(mean.compassHeading_deg + m_sectorOff[i] / mean.samples);
                mean.deviation_deg = wrap180(mean.deviation_deg + m_sectorDeviation[i] / mean.samples);
                result.legs.push_back(mean);
            }
    return result;
}

} // namespace lubberline
