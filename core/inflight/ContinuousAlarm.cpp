#include "core/inflight/ContinuousSwing.h"

#include <algorithm>
#include <cmath>

#include "core/algebra/Products.h"
#include "core/algebra/Spectra.h"

namespace lubberline {

namespace {

constexpr std::int64_t kEnoughForCorrelation = 40;
constexpr double kAfterAlarm_deg = 3.0;
constexpr double kMostCorrelation = 0.995, kErrorsOfCorrelation = 2.0;
/// Of χ²: two walks of a log-likelihood, before and after the moment, both stay below this with 95 %: (1 − e^(−y/2))² = 0.95
/// [Siegmund 1988]; there are fewer moments than in his limit, so that it is more.
constexpr double kNearlyAsLikely = 7.4;
constexpr std::size_t kLookedBackOn = 4 * InnovationWatch::kWindows.back(); ///< updates: errors that last delay an alarm
constexpr double kClearlyLess = 9.0; ///< of χ²: what explains less than the best by more than this is not what changed

} // namespace

/// Of the first updates, before any of them is taken: an error that is found later would have raised false alarms by then.
void ContinuousSwing::learnNoise()
{
    if (m_learnt)
        return;
    m_learnt = true;
    std::vector<HeadingRow> rows;
    for (const auto& [sample, variance] : m_waiting) {
        HeadingRow row{rowOf(sample), 0, variance.value_or(m_noiseFound)};
        row.z = measured(sample, row.h);
        rows.push_back(row);
    }
    constexpr double kExact_deg = 0.01; // no log is surer
    const HeadingScatter scatter = scatterOf(rows);
    m_noiseFound = std::max(m_noiseFound * scatter.blended(), kExact_deg * kExact_deg);
    if (!m_unstated && scatter.contradicts())
        m_scale = NoiseScale(scatter);
    const auto waiting = std::move(m_waiting);
    for (const auto& [sample, variance] : waiting)
        take(sample, variance.value_or(m_noiseFound));
}

/// What nobody stated may have been found too large as well as too small.
double ContinuousSwing::noiseRatio() const { return m_unstated ? m_scale.ratio() : std::max(1.0, m_scale.ratio()); }

/// As sure as the innovations show this flight to be; what was known before it stays as sure as it was.
StateFilter::Covariance ContinuousSwing::keptCovariance(double ratio) const
{
    if (!m_options.start || m_options.drift_deg > 0)
        return m_filter.covariance() * ratio;
    if (ratio <= 1)
        return m_filter.covariance();
    const StateFilter before(m_options.start->state_deg, m_options.start->covariance);
    const SymmetricParts parts = symmetricParts(m_filter.information() / ratio + before.information() * (1.0 - 1.0 / ratio));
    return composed(parts.vectors, parts.values.cwiseMax(1e-30).cwiseInverse());
}

double ContinuousSwing::correlation() const
{
    if (m_pairs < kEnoughForCorrelation || m_square <= 0)
        return 0;
    const double rho = m_product / m_square;
    const double chance = 2.6 / std::sqrt(static_cast<double>(m_pairs)); // 1 % of white innovations, two-sided
    return rho > chance ? std::min(rho, kMostCorrelation) : 0.0;
}

double ContinuousSwing::widening() const
{
    const double rho = correlation();
    return (1 + rho) / (1 - rho);
}

/// By how much of the innovation before one is whitened. Few updates tell a correlation badly, and too small [Kendall 1954]; while none is
/// told for sure, what they show is taken for one all the same: errors that last would else look like iron that changed.
double ContinuousSwing::whitening() const
{
    if (m_pairs < 2 || m_square <= 0)
        return 0;
    const double own = m_product / m_square;
    if (own <= 0 || (m_pairs >= kEnoughForCorrelation && correlation() == 0))
        return 0;
    return std::min(own + (1.0 + 3.0 * own) / static_cast<double>(m_pairs), kMostCorrelation);
}

/// By how much wider sums of whitened innovations may be: what is left of a correlation that is known to ±√((1 − ρ²)/n).
double ContinuousSwing::leftOfCorrelation(double rho) const
{
    const auto n = static_cast<double>(m_pairs);
    const double left = std::min(0.9, 3.0 / std::sqrt(n)), apart = 1.0 - rho;
    // Near 1 a little more of it lasts much longer: sums of errors go with (1 + ρ)/(1 − ρ).
    const double longest = std::max(apart - kErrorsOfCorrelation * std::sqrt((1.0 - rho * rho) / n), 0.1 * apart);
    return std::max((1 + left) / (1 - left), apart / longest);
}

void ContinuousSwing::watch(const Kept& kept, double white)
{
    ++m_whitened;
    for (std::size_t lag = 1; lag <= std::min(m_recent.size(), m_lags.size()); ++lag)
        m_lags[lag - 1] += white * m_recent[m_recent.size() - lag];
    m_recent.push_back(white);
    if (m_recent.size() > m_lags.size())
        m_recent.pop_front();
    const double rho = whitening();
    const StateFilter::State row = kept.h / std::sqrt(kept.variance);
    StateFilter::State whiteRow = row;
    double whiter = white;
    if (m_whitened > 1) {
        m_product += white * m_previous;
        ++m_pairs;
        if (rho > 0) { // what a change would show is whitened with it
            const double root = std::sqrt(1.0 - rho * rho);
            whiter = std::clamp((white - rho * m_previous) / root, -kGate, kGate) / std::sqrt(leftOfCorrelation(rho));
            whiteRow = (row - rho * m_previousRow) / root;
        }
    }
    m_square += white * white;
    m_previous = white;
    m_previousRow = row;
    m_kept.push_back(kept);
    if (m_kept.size() > kLookedBackOn)
        m_kept.pop_front();
    if (!m_naming.empty()) {
        constexpr std::size_t kUpdatesToName = 30, kMostToName = 1000;
        constexpr int kHeadingsToName = 12;    // on one leg any coefficient explains a change, however many updates it has
        constexpr double kOtherHeading = 0.97; // cosine of 14°
        if (kept.h(1) * m_namedOn(1) + kept.h(2) * m_namedOn(2) < kOtherHeading) {
            ++m_namedHeadings;
            m_namedOn = kept.h;
        }
        m_naming.push_back(kept);
        const std::size_t since = m_naming.size() - m_namedFrom;
        if ((since >= kUpdatesToName && m_namedHeadings >= kHeadingsToName) || since >= kMostToName) {
            nameChange();
            m_naming.clear();
        }
    }
    if (const auto found = m_watch.take(whiteRow, whiter)) {
        nameChange();
        raise(found->window, found->p);
    }
}

/// What changed, and since when: each coefficient alone, from each update on, against what it leaves of the state before the window. Within
/// the few headings of its delay one may look like another, so the updates that come after the alarm have a say.
void ContinuousSwing::nameChange()
{
    if (m_naming.empty())
        return;
    constexpr int kFewestSince = 4;
    ContinuousAlarm& alarm = m_alarms.back();
    const StateFilter::State reference = m_naming.front().before;
    const double known = m_naming.front().variance - m_naming.front().noise; // how well the state was known
    const double widened = widening();
    double most = -1;
    Eigen::Index best = 0;
    StateFilter::State explained = StateFilter::State::Constant(m_filter.states(), -1);
    for (int i = 0; i < m_filter.states(); ++i) {
        double information = 0, product = 0;
        int count = 0;
        for (auto one = m_naming.rbegin(); one != m_naming.rend(); ++one) {
            const double variance = one->noise + known;
            information += one->h(i) * one->h(i) / variance;
            product += one->h(i) * (one->z - one->h.dot(reference)) / variance;
            const bool before = one->time_s <= alarm.time_s; // it began then
            if (++count < kFewestSince || !before || information <= 0)
                continue;
            explained(i) = std::max(explained(i), product * product / information);
            if (explained(i) <= most)
                continue;
            most = explained(i);
            alarm.coefficient = m_names[static_cast<std::size_t>(i)];
            alarm.change_deg = product / information;
            alarm.standardError_deg = std::sqrt(widened / information);
            alarm.since_s = one->time_s;
            best = i;
        }
    }
    placeChange(best, most);
    alarm.orElse.clear();
    for (int i = 0; i < m_filter.states(); ++i)
        if (const auto& name = m_names[static_cast<std::size_t>(i)];
            name != alarm.coefficient && explained(i) > 0 && explained(i) > most - kClearlyLess * widened)
            alarm.orElse.push_back(name);
}

/// Between which updates a coefficient changed: all moments from which on a change explains nearly as much as from the likeliest.
void ContinuousSwing::placeChange(Eigen::Index coefficient, double most)
{
    ContinuousAlarm& alarm = m_alarms.back();
    const StateFilter::State reference = m_naming.front().before;
    const double known = m_naming.front().variance - m_naming.front().noise, least = most - kNearlyAsLikely * widening();
    double information = 0, product = 0;
    alarm.from_s = alarm.to_s = alarm.since_s;
    for (std::size_t place = m_naming.size(); place-- > 0;) {
        const Kept& one = m_naming[place];
        const double variance = one.noise + known, h = one.h(coefficient);
        information += h * h / variance;
        product += h * (one.z - one.h.dot(reference)) / variance;
        if (one.time_s > alarm.time_s || information <= 0 || product * product / information < least)
            continue;
        alarm.to_s = std::max(alarm.to_s, one.time_s);
        alarm.from_s = std::min(alarm.from_s, m_naming[place > 0 ? place - 1 : 0].time_s); // after the update before
    }
}

void ContinuousSwing::raise(int window, double p)
{
    const auto begin = m_kept.end() - window;
    m_naming.assign(m_kept.begin(), m_kept.end());
    m_namedFrom = m_naming.size();
    m_namedHeadings = 0;
    m_namedOn = m_kept.back().h;
    m_alarms.push_back({m_kept.back().time_s, begin->time_s, window, p, {}, {}, 0, 0, begin->time_s, m_kept.back().time_s});
    nameChange();
    m_kept.clear();
    m_watch.forget();
    // The filter is sure of what is no more: it learns anew.
    m_filter.widen(StateFilter::State::Constant(m_filter.states(), kAfterAlarm_deg * kAfterAlarm_deg));
    constexpr std::size_t kMostAlarms = 1000;
    if (m_alarms.size() > kMostAlarms) {
        m_alarms.resize(kMostAlarms);
        m_naming.clear();
    }
}

} // namespace lubberline
