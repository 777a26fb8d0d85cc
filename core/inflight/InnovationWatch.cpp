#include "core/inflight/InnovationWatch.h"

#include <algorithm>
#include <cmath>

#include <boost/math/distributions/chi_squared.hpp>

namespace lubberline {

namespace {

constexpr int kStatistics = 5;       ///< A, B, C, B with C, D with E
constexpr int kSumAnew = 1000;       ///< updates, after which rounding of what was added and taken away again is got rid of
constexpr double kLeastApart = 1e-3; ///< of two rows: the sine of the angle between them, squared; below, they say one thing

} // namespace

InnovationWatch::InnovationWatch(int states) : m_states(states)
{
    const int loads = (states - 5) / 2;
    // As many false alarms with loads as without.
    const double chance = kChance * kStatistics / (kStatistics + std::max(0, loads));
    m_limitOne = quantile(complement(boost::math::chi_squared(1), chance));
    m_limitTwo = quantile(complement(boost::math::chi_squared(2), chance));
    forget();
}

void InnovationWatch::forget()
{
    const StateFilter::State zero = StateFilter::State::Zero(m_states);
    m_sums.fill({zero, zero, zero});
    m_entries.clear();
    m_sinceAnew = 0;
}

void InnovationWatch::add(Sums& sums, const Entry& entry, double sign)
{
    const auto states = entry.row.size();
    sums.score += sign * entry.white * entry.row;
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

std::optional<InnovationWatch::Found> InnovationWatch::largestOf(const Sums& sums, int window) const
{
    double most = 1, found = 0;
    int freedom = 0;
    const auto hold = [&](double statistic, double limit, int ownFreedom) {
        if (statistic > most * limit) { // how far beyond its own limit
            most = statistic / limit;
            found = statistic;
            freedom = ownFreedom;
        }
    };
    for (Eigen::Index i = 0; i < m_states; ++i) {
        const double own = sums.square(i);
        if (i < 3 && own > 0)
            hold(sums.score(i) * sums.score(i) / own, m_limitOne, 1);
        if (i % 2 == 0 || i + 1 >= m_states)
            continue;
        const double next = sums.square(i + 1), cross = sums.cross(i), apart = own * next - cross * cross;
        if (apart > kLeastApart * own * next)
            hold((sums.score(i) * (sums.score(i) * next - 2 * sums.score(i + 1) * cross) + sums.score(i + 1) * sums.score(i + 1) * own)
                    / apart,
                m_limitTwo, 2);
    }
    if (freedom == 0)
        return {};
    return Found{window, cdf(complement(boost::math::chi_squared(freedom), found))};
}

std::optional<InnovationWatch::Found> InnovationWatch::take(const StateFilter::State& row, double white)
{
    m_entries.push_back({row, white});
    std::optional<Found> best;
    for (std::size_t w = 0; w < kWindows.size(); ++w) {
        const auto length = static_cast<std::size_t>(kWindows[w]);
        add(m_sums[w], m_entries.back(), 1);
        if (m_entries.size() > length)
            add(m_sums[w], m_entries[m_entries.size() - 1 - length], -1);
        if (m_entries.size() < length)
            continue;
        if (const auto one = largestOf(m_sums[w], kWindows[w]); one && (!best || one->p < best->p))
            best = one;
    }
    if (m_entries.size() > static_cast<std::size_t>(kWindows.back()))
        m_entries.pop_front();
    if (++m_sinceAnew == kSumAnew)
        sumAnew();
    return best;
}

} // namespace lubberline
