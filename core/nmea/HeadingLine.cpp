#include "core/nmea/HeadingLine.h"

#include <algorithm>
#include <cmath>

#include "core/angle/Angle.h"
#include "core/base/Middle.h"

namespace lubberline {

namespace {

constexpr double kSameMoment_s = 1e-6;
/// Over less, the last figure of a compass looks like a turn.
constexpr double kLeastApart_s = 1.0;

auto firstFrom(const std::vector<TimedHeading>& headings, double seconds)
{
    return std::lower_bound(
        headings.begin(), headings.end(), seconds, [](const TimedHeading& one, double wanted) { return one.seconds < wanted; });
}

std::optional<double> rateBetween(const TimedHeading& before, const TimedHeading& after)
{
    const double apart_s = after.seconds - before.seconds;
    if (apart_s <= 0.0 || apart_s > kMostApart_s)
        return {};
    return wrap180(*after.heading_deg - *before.heading_deg) / apart_s;
}

} // namespace

std::optional<TimedHeading> HeadingLine::at(double seconds) const
{
    const auto behind = firstFrom(m_headings, seconds + kSameMoment_s);
    if (behind == m_headings.begin())
        return {};
    const TimedHeading& before = *std::prev(behind);
    if (!before.heading_deg)
        return {};
    if (std::abs(before.seconds - seconds) <= kSameMoment_s)
        return before;
    if (behind == m_headings.end() || !behind->heading_deg || behind->seconds - before.seconds > kMostApart_s)
        return {};
    const double part = (seconds - before.seconds) / (behind->seconds - before.seconds);
    TimedHeading found{seconds, wrap360(*before.heading_deg + part * wrap180(*behind->heading_deg - *before.heading_deg)), {}};
    if (before.speed_kt && behind->speed_kt)
        found.speed_kt = *before.speed_kt + part * (*behind->speed_kt - *before.speed_kt);
    return found;
}

std::optional<double> HeadingLine::rateAt(double seconds, double half_s) const
{
    double count = 0.0, times = 0.0, angles = 0.0, squares = 0.0, products = 0.0, first_deg = 0.0;
    for (auto one = firstFrom(m_headings, seconds - half_s); one != m_headings.end() && one->seconds <= seconds + half_s; ++one) {
        if (!one->heading_deg)
            continue;
        if (count == 0.0)
            first_deg = *one->heading_deg;
        const double time = one->seconds - seconds, angle = wrap180(*one->heading_deg - first_deg);
        count += 1.0;
        times += time;
        angles += angle;
        squares += time * time;
        products += time * angle;
    }
    const double spread = squares - times * times / std::max(1.0, count);
    if (count < 3.0 || spread <= 0.0)
        return {};
    return (products - times * angles / count) / spread;
}

double HeadingLine::step_s() const
{
    std::vector<double> steps;
    for (std::size_t i = 1; i < m_headings.size(); ++i)
        if (const double step = m_headings[i].seconds - m_headings[i - 1].seconds; step > 0.0)
            steps.push_back(step);
    if (steps.empty())
        return 1.0;
    return middleOf(std::move(steps));
}

std::vector<std::optional<double>> turnRates(const std::vector<TimedHeading>& headings)
{
    std::vector<std::optional<double>> rates(headings.size());
    std::size_t before = 0, after = 0;
    for (std::size_t i = 0; i < headings.size(); ++i) {
        while (before < i && headings[i].seconds - headings[before + 1].seconds >= kLeastApart_s - 1e-9)
            ++before;
        after = std::max(after, i);
        while (after + 1 < headings.size() && headings[after].seconds - headings[i].seconds < kLeastApart_s - 1e-9)
            ++after;
        const auto left = before < i ? rateBetween(headings[before], headings[i]) : std::nullopt;
        const auto right = after > i ? rateBetween(headings[i], headings[after]) : std::nullopt;
        rates[i] = !left || !right ? (left ? left : right) : std::abs(*left) > std::abs(*right) ? left : right;
    }
    return rates;
}

} // namespace lubberline
