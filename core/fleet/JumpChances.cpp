#include "core/fleet/JumpChances.h"

#include <algorithm>
#include <cmath>

#include "core/fleet/FleetSwings.h"

namespace lubberline {

namespace {

constexpr int kPositionsADistance = 8, kDraws = 64;
constexpr double kErrorSteps = 4, kWanderSteps = 2; ///< of a doubling
constexpr double kSmallestLog = -60, kLargestLog = 60;

std::int32_t stepsOf(double ratio, double steps)
{
    return static_cast<std::int32_t>(std::lround(steps * std::clamp(std::log2(ratio), kSmallestLog, kLargestLog)));
}

} // namespace

JumpPattern jumpPatternOf(std::span<const DatedValue> series, const JumpOptions& options)
{
    JumpPattern pattern;
    pattern.leastSegment = options.leastSegment;
    pattern.trend = options.trend;
    if (series.size() < 2)
        return pattern;
    const auto n = static_cast<double>(series.size());
    const int span = series.back().day - series.front().day;
    double logs = 0;
    for (const auto& each : series)
        logs += std::log2(each.variance);
    const double middle = std::exp2(logs / n); // of the variances
    if (options.walk_year > 0 && span > 0)
        pattern.wander = stepsOf(options.walk_year * span / kDaysPerYear / (n - 1) / middle, kWanderSteps);
    for (std::size_t i = 0; i < series.size(); ++i) {
        JumpPattern::Figure figure;
        if (i > 0 && span > 0) { // other days stay other ones, however near
            const auto& before = pattern.figures.back();
            const double at = static_cast<double>(series[i].day - series.front().day) / span * (n - 1) * kPositionsADistance;
            figure.position
                = std::max(static_cast<std::int32_t>(std::lround(at)), before.position + (series[i].day > series[i - 1].day ? 1 : 0));
            if (series[i].day == series[i - 1].day)
                figure.position = before.position;
        }
        figure.error = static_cast<std::int16_t>(stepsOf(std::sqrt(series[i].variance / middle), kErrorSteps));
        figure.known = i > 0 && (series[i].corrected || std::ranges::find(options.at, i) != options.at.end());
        pattern.figures.push_back(figure);
    }
    return pattern;
}

JumpTable::JumpTable(const JumpPattern& pattern)
{
    std::vector<DatedValue> series;
    for (const auto& figure : pattern.figures)
        series.push_back({figure.position, 0, std::exp2(2 * figure.error / kErrorSteps), figure.known});
    JumpOptions options;
    options.trend = pattern.trend;
    options.leastSegment = pattern.leastSegment;
    if (pattern.wander != JumpPattern::kStill)
        options.walk_year = std::exp2(pattern.wander / kWanderSteps) * kDaysPerYear / kPositionsADistance;
    const JumpDesign design(series, options);
    if (design.places().empty())
        return;
    std::array<double, kSteps> statistics{};
    for (std::size_t i = 0; i < kSteps; ++i)
        statistics[i] = kStep * static_cast<double>(i);
    std::ranges::copy(design.worthOfPlaces(statistics, kDraws), m_worth.begin());
}

double JumpTable::chanceBeyond(double statistic) const
{
    if (!(m_worth.front() > 0))
        return 1.0;
    const double c = std::abs(statistic), at = std::min(c / kStep, static_cast<double>(kSteps - 1));
    const auto below = std::min(static_cast<std::size_t>(at), kSteps - 2);
    const double worth = std::lerp(m_worth[below], m_worth[below + 1], at - static_cast<double>(below));
    return std::min(1.0, 2 * normalTail(c) * worth);
}

double JumpTable::criticalValue(double chance) const
{
    double low = 0, high = normalTailQuantile(0.5 * chance / std::max(1.0, *std::ranges::max_element(m_worth))) + 0.01;
    for (int round = 0; round < 60; ++round) {
        const double middle = 0.5 * (low + high);
        (chanceBeyond(middle) > chance ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

std::shared_ptr<const JumpTable> JumpChances::of(const JumpPattern& pattern)
{
    {
        const std::scoped_lock lock(m_mutex);
        if (const auto known = m_tables.find(pattern); known != m_tables.end())
            return known->second;
    }
    auto table = std::make_shared<const JumpTable>(pattern); // two at once make the same
    const std::scoped_lock lock(m_mutex);
    if (m_tables.size() < kMost)
        m_tables.try_emplace(pattern, table);
    return table;
}

std::size_t JumpChances::patterns() const
{
    const std::scoped_lock lock(m_mutex);
    return m_tables.size();
}

JumpChances& jumpChances()
{
    static JumpChances chances;
    return chances;
}

} // namespace lubberline
