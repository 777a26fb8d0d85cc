#include "core/nmea/NmeaLog.h"

#include <algorithm>
#include <cmath>

namespace lubberline {

namespace {

/// A log has a handful of sources; each line looks for its own among them.
constexpr std::size_t kMostNmeaSources = 100;

/// The entry of a source, made where there is none yet; none where there are too many.
template <class Entry>
Entry* entryOf(std::vector<Entry>& entries, const NmeaSource& source)
{
    const auto found = std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) { return entry.source == source; });
    if (found != entries.end())
        return &*found;
    if (entries.size() == kMostNmeaSources)
        return nullptr;
    entries.emplace_back().source = source;
    return &entries.back();
}

} // namespace

void NmeaLog::take(std::string_view line)
{
    ++lines;
    for (const ParsedNmea& parsed : nmeaSentences(line)) {
        const bool lostItsChecksum
            = parsed.fault == NmeaFault::None && !parsed.sentence.hasChecksum && m_checking.contains(parsed.sentence.talker);
        if (parsed.fault == NmeaFault::BadChecksum || lostItsChecksum)
            ++badChecksums;
        else if (parsed.fault != NmeaFault::None)
            ++otherLines;
        else
            take(parsed.sentence);
    }
}

void NmeaLog::take(const NmeaSentence& sentence)
{
    if (sentence.hasChecksum)
        m_checking.insert(sentence.talker);
    ++sentences;
    ++m_place;
    withoutChecksum += sentence.hasChecksum ? 0 : 1;
    takeUnread(sentence);
    const NmeaValue value = valueOf(sentence);
    if (const auto* compass = std::get_if<NmeaCompass>(&value)) {
        take(*compass);
    } else if (const auto* heading = std::get_if<NmeaTrueHeading>(&value)) {
        ++ofMode[static_cast<std::size_t>(heading->mode)];
        send({heading->talker, heading->type}, NmeaNorth::True, heading->heading.degrees());
    } else if (const auto* water = std::get_if<NmeaWater>(&value)) {
        take(*water);
    } else if (const auto* track = std::get_if<NmeaTrack>(&value)) {
        take(*track);
    } else if (const auto* fix = std::get_if<NmeaFix>(&value)) {
        take(*fix);
    } else if (const auto* clock = std::get_if<NmeaClock>(&value)) {
        takeTime({clock->talker, sentence.type}, clock->time);
    } else if (std::holds_alternative<NmeaBadHeading>(value)) {
        ++badHeadings;
    } else if (std::holds_alternative<NmeaNoHeading>(value)) {
        ++noHeadings;
    }
}

void NmeaLog::takeUnread(const NmeaSentence& sentence)
{
    NmeaUnread unread = unreadOf(sentence);
    const auto count = [](std::string& written, std::int64_t& counted, std::string& first) {
        if (!written.empty() && counted++ == 0)
            first = std::move(written);
    };
    count(unread.time, unreadTimes, firstUnreads.time);
    count(unread.date, unreadDates, firstUnreads.date);
    count(unread.place, unreadPlaces, firstUnreads.place);
}

void NmeaLog::take(const NmeaCompass& compass)
{
    const NmeaSource source{compass.talker, compass.type};
    takeVariation(source, compass.variation, compass.unread);
    if (compass.deviation && compass.deviation->degrees() != 0.0) {
        ++deviations;
        if (!largestDeviation || std::abs(compass.deviation->degrees()) > std::abs(largestDeviation->degrees()))
            largestDeviation = compass.deviation;
    }
    send(source, NmeaNorth::Compass, compass.heading.degrees());
}

void NmeaLog::take(const NmeaWater& water)
{
    const NmeaSource source{water.talker, "VHW"};
    if (water.heading)
        send({water.talker, "VHW T"}, NmeaNorth::True, water.heading->degrees());
    if (water.compass)
        send(source, NmeaNorth::Compass, water.compass->degrees());
}

void NmeaLog::take(const NmeaTrack& track)
{
    const NmeaSource source{track.talker, track.type};
    ++(track.noFix ? noFixes : fixes);
    ++ofMode[static_cast<std::size_t>(track.mode)];
    takeVariation(source, track.variation, track.unread);
    takeTime(source, track.time);
    takePlace(track.latitude_deg, track.longitude_deg);
    send(source, NmeaNorth::Track, track.track ? std::optional(track.track->degrees()) : std::nullopt, track.speed_kt,
        track.type == "RMC" && !track.time);
}

void NmeaLog::take(const NmeaFix& fix)
{
    takeTime({fix.talker, "GGA"}, fix.time);
    takePlace(fix.latitude_deg, fix.longitude_deg);
    if (!altitude_m)
        altitude_m = fix.altitude_m;
}

void NmeaLog::takePlace(std::optional<double> latitude, std::optional<double> longitude)
{
    if (latitude_deg || !latitude || !longitude)
        return;
    latitude_deg = latitude;
    longitude_deg = longitude;
}

void NmeaLog::takeTime(const NmeaSource& source, const std::optional<NmeaTime>& time)
{
    if (!time)
        return;
    if (time->date)
        m_date = *time->date;
    if (firstDate.empty())
        firstDate = m_date;
    if (auto* clock = entryOf(m_clocks, source))
        clock->marks.push_back({m_place, time->secondsOfDay, m_date});
}

void NmeaLog::takeVariation(const NmeaSource& source, const std::optional<Variation>& variation, const std::string& unread)
{
    if (!unread.empty() && unreadAngles++ == 0)
        firstUnread = unread;
    if (auto* told = variation ? entryOf(m_variations, source) : nullptr)
        told->told_deg.push_back(variation->degrees());
}

void NmeaLog::send(const NmeaSource& source, NmeaNorth north, std::optional<double> angle_deg, std::optional<double> speed_kt, bool untimed)
{
    NmeaStream* stream = entryOf(m_streams, source);
    if (!stream) {
        ++otherLines;
        return;
    }
    stream->north = north;
    stream->sent.push_back({m_place, angle_deg, speed_kt, untimed});
    headings += north == NmeaNorth::Compass ? 1 : 0;
}

} // namespace lubberline
