#include "core/nmea/SettlingWindow.h"

#include <algorithm>
#include <cmath>

#include "core/angle/Angle.h"

namespace lubberline {

void SettlingWindow::add(double time_s, double heading_deg)
{
    const bool interrupted = !m_headings.empty() && (time_s < m_headings.back().time_s || time_s - m_headings.back().time_s > m_length_s);
    if (interrupted)
        m_headings.clear();
    if (m_headings.empty())
        m_since_s = time_s;
    m_headings.push_back({time_s, heading_deg});
    while (m_headings.front().time_s < time_s - m_length_s)
        m_headings.pop_front();
}

std::optional<SettledHeading> SettlingWindow::at(double time_s) const
{
    if (m_headings.empty() || std::abs(time_s - m_headings.back().time_s) > m_length_s)
        return {};
    const double first = m_headings.front().heading_deg;
    double sum = 0.0, squares = 0.0, least = 0.0, most = 0.0, unrolled = 0.0, last = first;
    double times = 0.0, timesSquared = 0.0, angles = 0.0, products = 0.0; // of the line through them, unrolled past 180°
    for (const auto& heading : m_headings) {
        const double off = wrap180(heading.heading_deg - first);
        sum += off;
        squares += off * off;
        least = std::min(least, off);
        most = std::max(most, off);
        unrolled += wrap180(heading.heading_deg - last);
        last = heading.heading_deg;
        const double time = heading.time_s - m_headings.front().time_s;
        times += time;
        timesSquared += time * time;
        angles += unrolled;
        products += time * unrolled;
    }
    const auto count = static_cast<double>(m_headings.size());
    const double mean = sum / count;
    SettledHeading settled{
        wrap360(first + mean), most - least, 0.0, {}, static_cast<int>(m_headings.size()), time_s - m_headings.back().time_s, false};
    constexpr double kLeast_s = 1.0;
    if (m_headings.back().time_s - m_headings.front().time_s >= kLeast_s)
        settled.turnRate_deg_s = (products - times * angles / count) / (timesSquared - times * times / count);
    if (count > 1)
        settled.standardDeviation_deg = std::sqrt(std::max(0.0, (squares - count * mean * mean) / (count - 1.0)));
    settled.settled = m_headings.back().time_s - m_since_s >= m_length_s && settled.spread_deg <= m_mostSpread_deg;
    return settled;
}

} // namespace lubberline
