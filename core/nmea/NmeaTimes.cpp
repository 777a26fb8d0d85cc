#include "core/nmea/NmeaTimes.h"

#include "core/base/Middle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

namespace lubberline {

namespace {

constexpr double kSecondsOfDay = 86400.0;
/// What lies on both sides of a clock that was set back has nothing to do with each other.
constexpr double kBreak_s = 1000.0;
/// So many of the intervals hold the same number of sentences where a log is a row of cycles.
constexpr double kCyclicShare = 0.9;

int rankOf(const NmeaSource& source) { return source.type == "RMC" ? 2 : source.type == "GGA" ? 1 : 0; }

const NmeaMarks* clockOf(const NmeaLog& log, const NmeaSource& reference)
{
    const NmeaMarks* best = nullptr;
    for (const auto& clock : log.clocks()) {
        if (clock.source == reference)
            return &clock;
        const auto worth = [](const NmeaMarks& one) { return std::pair(one.marks.size(), rankOf(one.source)); };
        if (!best || worth(clock) > worth(*best))
            best = &clock;
    }
    return best;
}

} // namespace

NmeaTimes::NmeaTimes(const NmeaLog& log, const NmeaStream& reference)
{
    if (const auto* clock = clockOf(log, reference.source)) {
        m_told = true;
        takeClock(*clock);
    } else {
        takeSteps(reference);
    }
    std::vector<double> steps;
    for (std::size_t i = 1; i < m_marks.size(); ++i)
        if (m_marks[i].follows)
            steps.push_back(m_marks[i].seconds - m_marks[i - 1].seconds);
    if (steps.empty())
        return;
    m_typical_s = middleOf(std::move(steps));
}

void NmeaTimes::takeClock(const NmeaMarks& clock)
{
    m_clock = clock.source;
    for (const auto& told : clock.marks) {
        Mark mark{told.place, 0.0, told.secondsOfDay, told.date, true};
        if (!m_marks.empty()) {
            double passed_s = told.secondsOfDay - m_marks.back().secondsOfDay;
            if (passed_s < -kSecondsOfDay / 2.0)
                passed_s += kSecondsOfDay; // past midnight the seconds of the day begin anew
            if (passed_s == 0.0)
                continue; // the same moment once more
            mark.follows = passed_s > 0.0;
            mark.seconds = m_marks.back().seconds + (mark.follows ? passed_s : kBreak_s);
        }
        m_marks.push_back(std::move(mark));
    }
}

void NmeaTimes::takeSteps(const NmeaStream& reference)
{
    m_clock = reference.source;
    for (std::size_t i = 0; i < reference.sent.size(); ++i)
        m_marks.push_back({reference.sent[i].place, static_cast<double>(i), 0.0, {}, true});
}

void NmeaTimes::stretch(double secondsOfStep)
{
    for (auto& mark : m_marks)
        mark.seconds *= secondsOfStep;
    m_typical_s *= secondsOfStep;
}

/// The newest mark at or before a place; null before the first.
const NmeaTimes::Mark* NmeaTimes::markAt(std::size_t place) const
{
    const auto next
        = std::upper_bound(m_marks.begin(), m_marks.end(), place, [](std::size_t wanted, const Mark& mark) { return wanted < mark.place; });
    return next == m_marks.begin() ? nullptr : &*std::prev(next);
}

/// The sentences before the first mark, between each two, and behind the last.
std::vector<std::vector<std::size_t>> NmeaTimes::intervalsOf(const NmeaStream& stream) const
{
    std::vector<std::vector<std::size_t>> intervals(m_marks.size() + 1);
    std::size_t interval = 0;
    for (std::size_t i = 0; i < stream.sent.size(); ++i) {
        while (interval < m_marks.size() && m_marks[interval].place <= stream.sent[i].place)
            ++interval;
        intervals[interval].push_back(i);
    }
    return intervals;
}

NmeaTimes::Spread NmeaTimes::spreadOf(const NmeaStream& stream, const std::vector<std::vector<std::size_t>>& intervals) const
{
    std::map<std::size_t, std::size_t> held;
    std::size_t whole = 0;
    for (std::size_t i = 1; i + 1 < intervals.size(); ++i)
        ++held[intervals[i].size()], ++whole;
    const bool headingFirst = !stream.sent.empty() && stream.sent.front().place < m_marks.front().place;
    const double cyclic = headingFirst ? 1.0 : 0.0;
    if (whole == 0)
        return {1.0, cyclic};
    const auto most = std::max_element(held.begin(), held.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    const bool inCycles = most->first > 0 && static_cast<double>(most->second) >= kCyclicShare * static_cast<double>(whole);
    const double mean = static_cast<double>(stream.sent.size()) / static_cast<double>(whole);
    return {inCycles ? static_cast<double>(most->first) : std::max(mean, 1e-3), inCycles ? cyclic : 0.5};
}

std::vector<std::optional<double>> NmeaTimes::of(const NmeaStream& stream) const
{
    std::vector<std::optional<double>> times(stream.sent.size());
    if (m_marks.empty())
        return times;
    const auto intervals = intervalsOf(stream);
    const Spread spread = spreadOf(stream, intervals);
    const double usual_s = m_typical_s / std::max(1.0, spread.perInterval);
    for (std::size_t i = 0; i < intervals.size(); ++i) {
        const auto& inside = intervals[i];
        const auto count = static_cast<double>(inside.size());
        for (std::size_t k = 0; k < inside.size(); ++k) {
            const double behind = static_cast<double>(k) + spread.offset, before = count - behind; // in spacings
            auto& time = times[inside[k]];
            if (i == 0)
                time = m_marks.front().seconds - before * usual_s;
            else if (i == m_marks.size())
                time = m_marks.back().seconds + behind * usual_s;
            else if (m_marks[i].follows)
                time = m_marks[i - 1].seconds + behind / count * (m_marks[i].seconds - m_marks[i - 1].seconds);
        }
    }
    if (stream.source == m_clock)
        for (std::size_t i = 0; i < times.size(); ++i)
            if (const Mark* mark = markAt(stream.sent[i].place);
                mark && !stream.sent[i].untimed && (stream.sent[i].angle_deg || mark->place == stream.sent[i].place))
                times[i] = mark->seconds; // a sentence that repeats the time has no mark of its own
    return times;
}

double NmeaTimes::spacing_s(const NmeaStream& stream) const
{
    if (m_marks.empty())
        return m_typical_s;
    return m_typical_s / std::max(1.0, spreadOf(stream, intervalsOf(stream)).perInterval);
}

std::string NmeaTimes::utc(double seconds) const
{
    if (!m_told || m_marks.empty())
        return {};
    auto next = std::upper_bound(
        m_marks.begin(), m_marks.end(), seconds + 1e-9, [](double wanted, const Mark& mark) { return wanted < mark.seconds; });
    const Mark& mark = next == m_marks.begin() ? m_marks.front() : *std::prev(next);
    if (mark.date.empty())
        return {};
    const double ofDay = std::fmod(mark.secondsOfDay + (seconds - mark.seconds) + kSecondsOfDay, kSecondsOfDay);
    const auto thousandths = static_cast<int>(ofDay * 1000.0 + 0.5) % 86'400'000;
    const int whole = thousandths / 1000;
    std::array<char, 48> time{};
    std::snprintf(time.data(), time.size(), "T%02d:%02d:%02d.%03dZ", whole / 3600, whole / 60 % 60, whole % 60, thousandths % 1000);
    return mark.date.text() + time.data();
}

std::vector<TimedHeading> inTime(const NmeaStream& stream, const NmeaTimes& times)
{
    const auto seconds = times.of(stream);
    std::vector<TimedHeading> headings;
    for (std::size_t i = 0; i < stream.sent.size(); ++i)
        if (seconds[i])
            headings.push_back({*seconds[i], stream.sent[i].angle_deg, stream.sent[i].speed_kt});
    std::stable_sort(headings.begin(), headings.end(), [](const auto& a, const auto& b) { return a.seconds < b.seconds; });
    return headings;
}

} // namespace lubberline
