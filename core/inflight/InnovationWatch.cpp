#include "core/inflight/InnovationWatch.h"

#include <algorithm>
#include <cmath>

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>

namespace lubberline {

namespace {

constexpr int kStatistics = 5;                       ///< A, B, C, B with C, D with E
constexpr int kSumAnew = 1000;                       ///< updates, after which rounding of what was added and taken away again is got rid of
constexpr double kUsual = 0.6;                       ///< standard deviations of a window's scatter, up to which it is as stated
constexpr double kCut = 1.5, kScatterOfCut = 0.8824; ///< standard deviations; what is left of one
constexpr double kLeastApart = 1e-3; ///< of two rows: the sine of the angle between them, squared; below, they say one thing

} // namespace

InnovationWatch::InnovationWatch(int states) : m_states(states)
{
    const int loads = (states - 5) / 2;
    // As many false alarms with loads as without.
    const double chance = kChance * kStatistics / (kStatistics + std::max(0, loads));
    for (std::size_t w = 0; w < kWindows.size(); ++w)
        for (const int freedom : {1, 2}) {
            const boost::math::fisher_f ratio(freedom, kWindows[w] - freedom);
            m_limits[w][static_cast<std::size_t>(freedom - 1)] = {quantile(complement(boost::math::chi_squared(freedom), chance)),
                freedom * quantile(complement(ratio, chance)), freedom * quantile(complement(ratio, kChanceCut)),
                freedom * quantile(complement(ratio, kChanceCutUsual)), 1.0 + kUsual * std::sqrt(2.0 / kWindows[w])};
        }
    forget();
}

void InnovationWatch::forget()
{
    const StateFilter::State zero = StateFilter::State::Zero(m_states);
    m_sums.fill({zero, zero, zero, zero, 0, 0});
    m_entries.clear();
    m_sinceAnew = 0;
}

void InnovationWatch::add(Sums& sums, const Entry& entry, double sign)
{
    const auto states = entry.row.size();
    sums.score += sign * entry.white * entry.row;
    sums.cutScore += sign * entry.cut * entry.row;
    sums.size += sign * entry.white * entry.white;
    sums.cutSize += sign * entry.cut * entry.cut;
    sums.square += sign * entry.row.cwiseAbs2();
    sums.cross.head(states - 1) += sign * entry.row.head(states - 1).cwiseProduct(entry.row.tail(states - 1));
}

void InnovationWatch::sumAnew()
{
    const auto entries = std::move(m_entries);
    forget();
    m_entries = entries;
    for (std::size_t w = 0; w < kWindows.size(); ++w)
        for (std::size_t back = 1; back <= std::min<std::size_t>(m_entries.size(), static_cast<std::size_t>(kWindows[w])); ++back)
            add(m_sums[w], m_entries[m_entries.size() - back], 1);
}

/// How many times its limit a statistic is, by the scatter that counts; 0 where most innovations do not show it.
double InnovationWatch::beyond(const Statistic& statistic, int freedom, const Sums& sums, std::size_t window) const
{
    const Limits& limits = m_limits[window][static_cast<std::size_t>(freedom - 1)];
    const double left = kWindows[window] - freedom, scatter = (sums.size - statistic.whole) / left;
    const double cutScatter = std::max(1.0, (sums.cutSize - statistic.cut) / left);
    if (scatter <= limits.usual)
        return statistic.cut < limits.cutUsual * cutScatter ? 0 : statistic.whole / limits.chance;
    if (statistic.cut < limits.cut * cutScatter)
        return 0;
    return statistic.whole / (limits.own * scatter);
}

std::optional<InnovationWatch::Found> InnovationWatch::largestOf(const Sums& sums, std::size_t window) const
{
    double most = 1;
    int freedom = 0;
    const auto hold = [&](const Statistic& statistic, int ownFreedom) {
        if (const double times = beyond(statistic, ownFreedom, sums, window); times > most) {
            most = times;
            freedom = ownFreedom;
        }
    };
    for (Eigen::Index i = 0; i < m_states; ++i) {
        const double own = sums.square(i);
        if (i < 3 && own > 0)
            hold({sums.score(i) * sums.score(i) / own, sums.cutScore(i) * sums.cutScore(i) / own}, 1);
        if (i % 2 == 0 || i + 1 >= m_states)
            continue;
        const double next = sums.square(i + 1), cross = sums.cross(i), apart = own * next - cross * cross;
        const auto both = [&](const StateFilter::State& score) {
            return (score(i) * (score(i) * next - 2 * score(i + 1) * cross) + score(i + 1) * score(i + 1) * own) / apart;
        };
        if (apart > kLeastApart * own * next)
            hold({both(sums.score), both(sums.cutScore)}, 2);
    }
    if (freedom == 0)
        return {};
    const double limit = m_limits[window][static_cast<std::size_t>(freedom - 1)].chance;
    return Found{kWindows[window], cdf(complement(boost::math::chi_squared(freedom), most * limit))};
}

std::optional<InnovationWatch::Found> InnovationWatch::take(const StateFilter::State& row, double white)
{
    m_entries.push_back({row, white, std::clamp(white, -kCut, kCut) / kScatterOfCut});
    std::optional<Found> best;
    for (std::size_t w = 0; w < kWindows.size(); ++w) {
        const auto length = static_cast<std::size_t>(kWindows[w]);
        add(m_sums[w], m_entries.back(), 1);
        if (m_entries.size() > length)
            add(m_sums[w], m_entries[m_entries.size() - 1 - length], -1);
        if (m_entries.size() < length)
            continue;
        if (const auto one = largestOf(m_sums[w], w); one && (!best || one->p < best->p))
            best = one;
    }
    if (m_entries.size() > static_cast<std::size_t>(kWindows.back()))
        m_entries.pop_front();
    if (++m_sinceAnew == kSumAnew)
        sumAnew();
    return best;
}

} // namespace lubberline
