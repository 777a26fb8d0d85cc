// Which logs a state has taken.

#include <algorithm>

#include "core/fleet/FleetRandom.h"
#include "core/inflight/ContinuousSwing.h"

namespace lubberline {

namespace {

constexpr std::int64_t kBeginning = 20;    ///< readings that two flights do not share to the last digit
constexpr double kSecondsOfAClock_s = 1e8; ///< since 1970; less is counted from the beginning of a log, and says nothing of another one

} // namespace

void ContinuousSwing::keepPrint(const ContinuousSample& sample)
{
    if (m_log.samples == 0)
        m_log.from_s = sample.time_s;
    m_log.to_s = sample.time_s;
    ContentSeed print;
    print.add(m_log.print).add(sample.time_s).add(sample.compassHeading_deg).add(sample.deviation_deg);
    m_log.print = print.value() >> 12;
    if (++m_log.samples <= kBeginning)
        m_log.beginning = m_log.print;
}

TakenBefore takenBefore(const TakenLog& log, const std::vector<TakenLog>& before)
{
    const auto any = [&](const auto& isLike) { return std::any_of(before.begin(), before.end(), isLike); };
    if (any([&](const TakenLog& one) { return one.print == log.print && one.samples == log.samples; }))
        return TakenBefore::Whole;
    if (any([&](const TakenLog& one) { return one.beginning == log.beginning; }))
        return TakenBefore::Beginning;
    const auto atOneTime = [&](const TakenLog& one) {
        return std::min(log.from_s, one.from_s) > kSecondsOfAClock_s && log.from_s <= one.to_s && one.from_s <= log.to_s;
    };
    return any(atOneTime) ? TakenBefore::Time : TakenBefore::Nothing;
}

} // namespace lubberline
