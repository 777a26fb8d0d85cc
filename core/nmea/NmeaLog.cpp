#include "core/nmea/NmeaLog.h"

#include <algorithm>

namespace lubberline {

namespace {

constexpr double kSecondsOfDay = 86400.0;

bool blank(std::string_view line) { return line.find_first_not_of(" \t\r\n") == std::string_view::npos; }

} // namespace

void NmeaLog::take(std::string_view line)
{
    ++lines;
    if (blank(line))
        return;
    const ParsedNmea parsed = parseNmea(line);
    if (parsed.fault == NmeaFault::BadChecksum) {
        ++badChecksums;
        return;
    }
    if (parsed.fault != NmeaFault::None) {
        ++otherLines;
        return;
    }
    if (parsed.sentence.hasChecksum)
        m_checking.insert(parsed.sentence.talker);
    else if (m_checking.contains(parsed.sentence.talker)) { // it sends checksums: this sentence has lost its own
        ++badChecksums;
        return;
    }
    ++sentences;
    withoutChecksum += parsed.sentence.hasChecksum ? 0 : 1;
    const NmeaValue value = valueOf(parsed.sentence);
    if (const auto* compass = std::get_if<NmeaCompass>(&value))
        take(*compass);
    else if (const auto* heading = std::get_if<NmeaTrueHeading>(&value))
        m_now.trueHeading = heading->heading;
    else if (const auto* track = std::get_if<NmeaTrack>(&value))
        take(*track);
    else if (const auto* fix = std::get_if<NmeaFix>(&value))
        take(*fix);
}

void NmeaLog::take(const NmeaCompass& compass)
{
    if (compass.variation)
        m_now.variation = compass.variation;
    NmeaHeadingEvent event = m_now;
    event.source = indexOf({compass.talker, compass.type});
    event.heading = compass.heading;
    ++m_counts[event.source];
    m_headings.push_back(std::move(event));
}

void NmeaLog::take(const NmeaTrack& track)
{
    m_now.track = track.track;
    m_now.speed_kt = track.speed_kt;
    if (track.variation)
        m_now.variation = track.variation;
    takeTime(track.time);
    if (!latitude_deg && track.latitude_deg && track.longitude_deg) {
        latitude_deg = track.latitude_deg;
        longitude_deg = track.longitude_deg;
    }
}

void NmeaLog::take(const NmeaFix& fix)
{
    takeTime(fix.time);
    if (!latitude_deg) {
        latitude_deg = fix.latitude_deg;
        longitude_deg = fix.longitude_deg;
    }
    if (!altitude_m)
        altitude_m = fix.altitude_m;
}

void NmeaLog::takeTime(const std::optional<NmeaTime>& time)
{
    if (!time)
        return;
    if (time->date) {
        m_now.date = *time->date;
        if (firstDate.empty())
            firstDate = *time->date;
    }
    // Past midnight the seconds of the day begin anew; a clock that is set back by less than half a day is a clock set back.
    if (m_now.seconds && m_midnights + time->secondsOfDay < *m_now.seconds - kSecondsOfDay / 2.0)
        m_midnights += kSecondsOfDay;
    m_now.seconds = m_midnights + time->secondsOfDay;
}

int NmeaLog::indexOf(const NmeaSource& source)
{
    const auto found = std::find(m_sources.begin(), m_sources.end(), source);
    if (found != m_sources.end())
        return static_cast<int>(found - m_sources.begin());
    m_sources.push_back(source);
    m_counts.push_back(0);
    return static_cast<int>(m_sources.size()) - 1;
}

} // namespace lubberline
