#include "core/nmea/NmeaValues.h"

#include <cstdio>

#include "core/base/FileText.h"
#include "core/base/Number.h"

namespace lubberline {

namespace {

std::optional<double> number(std::string_view text)
{
    const FileNumber read = readNumber(text);
    return text.empty() || read.fault != NumberFault::None ? std::nullopt : std::optional(read.value);
}

/// A heading of [0, 360]; 360 is 0.
std::optional<double> headingOf(std::string_view text)
{
    const auto value = number(text);
    return value && *value >= 0.0 && *value <= 360.0 ? value : std::nullopt;
}

/// A size and its side: "2.2", "W" is −2.2.
template <class Angle>
std::optional<Angle> sided(std::string_view size, std::string_view side)
{
    const auto value = number(size);
    if (!value || *value < 0.0 || *value > 180.0 || (side != "E" && side != "W"))
        return {};
    return Angle::fromDegrees(side == "W" ? -*value : *value);
}

/// ddmm.mmm or dddmm.mmm with its hemisphere, in degrees.
std::optional<double> coordinate(std::string_view text, std::string_view hemisphere, char positive, char negative, double most)
{
    const auto value = number(text);
    if (!value || hemisphere.size() != 1 || (hemisphere[0] != positive && hemisphere[0] != negative))
        return {};
    const double degrees = std::floor(*value / 100.0), minutes = *value - 100.0 * degrees;
    const double result = degrees + minutes / 60.0;
    if (*value < 0.0 || minutes >= 60.0 || result > most)
        return {};
    return hemisphere[0] == negative ? -result : result;
}

/// hhmmss or hhmmss.sss.
std::optional<NmeaTime> timeOf(std::string_view text)
{
    const auto value = number(text);
    if (!value || text.size() < 6 || *value < 0.0)
        return {};
    const int whole = static_cast<int>(*value / 100.0);
    const int hours = whole / 100, minutes = whole % 100;
    const double seconds = *value - 100.0 * whole;
    if (hours > 23 || minutes > 59 || seconds >= 61.0)
        return {};
    return NmeaTime{hours * 3600.0 + minutes * 60.0 + seconds, {}};
}

/// ddmmyy: 80…99 are of the last century, as GPS began then.
std::optional<std::string> dateOf(std::string_view text)
{
    const auto value = number(text);
    if (!value || text.size() != 6 || *value < 0.0)
        return {};
    const int all = static_cast<int>(*value), year = all % 100;
    char iso[32];
    std::snprintf(iso, sizeof iso, "%04d-%02d-%02d", year >= 80 ? 1900 + year : 2000 + year, all / 100 % 100, all / 10000);
    return isIsoDate(iso) ? std::optional<std::string>(iso) : std::nullopt;
}

template <class Heading>
std::optional<Heading> typed(std::optional<double> heading_deg)
{
    return heading_deg ? std::optional(Heading::fromDegrees(*heading_deg)) : std::nullopt;
}

NmeaValue compassOf(const NmeaSentence& sentence)
{
    const auto heading = headingOf(sentence.field(0));
    if (!heading)
        return {};
    NmeaCompass compass{sentence.talker, sentence.type, CompassHeading::fromDegrees(*heading), {}, {}};
    if (sentence.type == "HDG") {
        compass.deviation = sided<Deviation>(sentence.field(1), sentence.field(2));
        compass.variation = sided<Variation>(sentence.field(3), sentence.field(4));
    }
    return compass;
}

NmeaValue recommendedMinimum(const NmeaSentence& sentence)
{
    if (sentence.field(1) != "A" || sentence.field(11) == "N")
        return NmeaTrack{sentence.talker, {}, {}, {}, {}, {}, {}};
    NmeaTrack track{sentence.talker, typed<TrueHeading>(headingOf(sentence.field(7))), number(sentence.field(6)),
        sided<Variation>(sentence.field(9), sentence.field(10)), timeOf(sentence.field(0)),
        coordinate(sentence.field(2), sentence.field(3), 'N', 'S', 90.0),
        coordinate(sentence.field(4), sentence.field(5), 'E', 'W', 180.0)};
    if (track.time)
        track.time->date = dateOf(sentence.field(8));
    return track;
}

NmeaValue trackMadeGood(const NmeaSentence& sentence)
{
    if (sentence.field(8) == "N" || (!sentence.field(1).empty() && sentence.field(1) != "T"))
        return NmeaTrack{sentence.talker, {}, {}, {}, {}, {}, {}};
    return NmeaTrack{sentence.talker, typed<TrueHeading>(headingOf(sentence.field(0))), number(sentence.field(4)), {}, {}, {}, {}};
}

NmeaValue fixOf(const NmeaSentence& sentence)
{
    const auto latitude = coordinate(sentence.field(1), sentence.field(2), 'N', 'S', 90.0);
    const auto longitude = coordinate(sentence.field(3), sentence.field(4), 'E', 'W', 180.0);
    if (!latitude || !longitude || sentence.field(5) == "0" || sentence.field(5).empty())
        return {};
    return NmeaFix{sentence.talker, timeOf(sentence.field(0)), *latitude, *longitude, number(sentence.field(8))};
}

} // namespace

NmeaValue valueOf(const NmeaSentence& sentence)
{
    if (sentence.talker == "P")
        return {};
    if (sentence.type == "HDG" || sentence.type == "HDM")
        return compassOf(sentence);
    if (sentence.type == "HDT") {
        const auto heading = headingOf(sentence.field(0));
        return heading ? NmeaValue(NmeaTrueHeading{sentence.talker, TrueHeading::fromDegrees(*heading)}) : NmeaValue();
    }
    if (sentence.type == "RMC")
        return recommendedMinimum(sentence);
    if (sentence.type == "VTG")
        return trackMadeGood(sentence);
    if (sentence.type == "GGA")
        return fixOf(sentence);
    return {};
}

} // namespace lubberline
