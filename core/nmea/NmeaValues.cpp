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

/// A size and side that say something which sided() does not take, as they are written: "-15.2,W".
std::string unreadOf(std::string_view size, std::string_view side)
{
    return size.empty() || sided<Variation>(size, side) ? std::string() : std::string(size) + "," + std::string(side);
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

/// @return none for what is no day of the calendar.
std::optional<Date> dateOf(int year, int month, int day)
{
    char iso[48];
    std::snprintf(iso, sizeof iso, "%04d-%02d-%02d", year, month, day);
    return Date::read(iso);
}

/// ddmmyy: 80…99 are of the last century, as GPS began then.
std::optional<Date> shortDateOf(std::string_view text)
{
    const auto value = number(text);
    if (!value || text.size() != 6 || *value < 0.0)
        return {};
    const int all = static_cast<int>(*value), year = all % 100;
    return dateOf(year >= 80 ? 1900 + year : 2000 + year, all / 100 % 100, all / 10000);
}

NmeaMode modeOf(std::string_view letter)
{
    return letter == "E" ? NmeaMode::Estimated
        : letter == "M"  ? NmeaMode::Manual
        : letter == "S"  ? NmeaMode::Simulated
                         : NmeaMode::Measured;
}

template <class Heading>
std::optional<Heading> typed(std::optional<double> heading_deg)
{
    return heading_deg ? std::optional(Heading::fromDegrees(*heading_deg)) : std::nullopt;
}

/// A figure that stands where a heading is expected and is none.
bool isBadHeading(std::string_view text) { return number(text) && !headingOf(text); }

NmeaValue compassOf(const NmeaSentence& sentence)
{
    if (isBadHeading(sentence.field(0)))
        return NmeaBadHeading{sentence.talker};
    const auto heading = headingOf(sentence.field(0));
    if (!heading)
        return {};
    NmeaCompass compass{sentence.talker, sentence.type, CompassHeading::fromDegrees(*heading), {}, {}};
    if (sentence.type == "HDG") {
        compass.deviation = sided<Deviation>(sentence.field(1), sentence.field(2));
        compass.variation = sided<Variation>(sentence.field(3), sentence.field(4));
        compass.unread = unreadOf(sentence.field(3), sentence.field(4));
        if (compass.unread.empty())
            compass.unread = unreadOf(sentence.field(1), sentence.field(2));
    }
    return compass;
}

/// HDT, and THS with its mode (V: not valid).
NmeaValue trueHeadingOf(const NmeaSentence& sentence)
{
    const bool hasMode = sentence.type == "THS";
    if (hasMode && sentence.field(1) == "V")
        return NmeaNoHeading{sentence.talker};
    if (isBadHeading(sentence.field(0)))
        return NmeaBadHeading{sentence.talker};
    const auto heading = headingOf(sentence.field(0));
    if (!heading)
        return {};
    return NmeaTrueHeading{
        sentence.talker, sentence.type, TrueHeading::fromDegrees(*heading), hasMode ? modeOf(sentence.field(1)) : NmeaMode::Measured};
}

NmeaValue waterOf(const NmeaSentence& sentence)
{
    NmeaWater water{sentence.talker, {}, {}};
    if (sentence.field(1) == "T")
        water.heading = typed<TrueHeading>(headingOf(sentence.field(0)));
    if (sentence.field(3) == "M")
        water.compass = typed<CompassHeading>(headingOf(sentence.field(2)));
    return water.heading || water.compass ? NmeaValue(water) : NmeaValue();
}

/// Day, month, year of four figures.
std::optional<Date> longDateOf(const NmeaSentence& sentence)
{
    const auto day = number(sentence.field(1)), month = number(sentence.field(2)), year = number(sentence.field(3));
    const bool inside = day && month && year && *year >= 1000 && *year <= 9999 && *month >= 1 && *month <= 12 && *day >= 1 && *day <= 31;
    return inside ? dateOf(static_cast<int>(*year), static_cast<int>(*month), static_cast<int>(*day)) : std::nullopt;
}

/// hhmmss.ss, and the date.
NmeaValue clockOf(const NmeaSentence& sentence)
{
    auto time = timeOf(sentence.field(0));
    if (!time)
        return {};
    time->date = longDateOf(sentence);
    return NmeaClock{sentence.talker, *time};
}

NmeaTrack withoutFix(const NmeaSentence& sentence) { return {sentence.talker, sentence.type, true, {}, {}, {}, {}, {}, {}, {}}; }

NmeaValue recommendedMinimum(const NmeaSentence& sentence)
{
    if (sentence.field(1) != "A" || sentence.field(11) == "N")
        return withoutFix(sentence);
    NmeaTrack track{sentence.talker, sentence.type, false, modeOf(sentence.field(11)), typed<TrueHeading>(headingOf(sentence.field(7))),
        number(sentence.field(6)), sided<Variation>(sentence.field(9), sentence.field(10)), timeOf(sentence.field(0)),
        coordinate(sentence.field(2), sentence.field(3), 'N', 'S', 90.0), coordinate(sentence.field(4), sentence.field(5), 'E', 'W', 180.0),
        unreadOf(sentence.field(9), sentence.field(10))};
    if (track.time)
        track.time->date = shortDateOf(sentence.field(8));
    return track;
}

constexpr double kKilometresPerKnot = 1.852; // the nautical mile, by definition

/// Each figure with its letter behind it (T, M, N, K), or with that place left empty; in the oldest form the four figures alone.
NmeaValue trackMadeGood(const NmeaSentence& sentence)
{
    if (sentence.field(8) == "N")
        return withoutFix(sentence);
    std::optional<double> track_deg, knots, kilometres;
    bool letters = false;
    for (std::size_t i = 0; i + 1 < sentence.fields.size() && i < 8; i += 2) {
        const std::string_view letter = sentence.field(i + 1);
        letters = letters || letter == "T" || letter == "M" || letter == "N" || letter == "K";
        if (letter == "T")
            track_deg = headingOf(sentence.field(i));
        else if (letter == "N")
            knots = number(sentence.field(i));
        else if (letter == "K")
            kilometres = number(sentence.field(i));
    }
    if (!letters) { // each where its letter would stand behind it, or one after the other
        const bool places = sentence.fields.size() >= 7;
        track_deg = headingOf(sentence.field(0));
        knots = number(sentence.field(places ? 4 : 2));
        kilometres = number(sentence.field(places ? 6 : 3));
    }
    if (!knots && kilometres)
        knots = *kilometres / kKilometresPerKnot;
    return NmeaTrack{
        sentence.talker, sentence.type, false, modeOf(sentence.field(8)), typed<TrueHeading>(track_deg), knots, {}, {}, {}, {}};
}

/// Qualities 6, 7, 8: estimated, typed in, simulated.
NmeaMode qualityMode(std::string_view quality) { return modeOf(quality == "6" ? "E" : quality == "7" ? "M" : quality == "8" ? "S" : "A"); }

NmeaValue fixOf(const NmeaSentence& sentence)
{
    const auto latitude = coordinate(sentence.field(1), sentence.field(2), 'N', 'S', 90.0);
    const auto longitude = coordinate(sentence.field(3), sentence.field(4), 'E', 'W', 180.0);
    if (!latitude || !longitude || sentence.field(5) == "0" || sentence.field(5).empty())
        return {};
    return NmeaFix{
        sentence.talker, qualityMode(sentence.field(5)), timeOf(sentence.field(0)), *latitude, *longitude, number(sentence.field(8))};
}

} // namespace

NmeaUnread unreadOf(const NmeaSentence& sentence)
{
    const bool minimum = sentence.type == "RMC", fix = sentence.type == "GGA", clock = sentence.type == "ZDA";
    if (sentence.talker == "P" || (!minimum && !fix && !clock))
        return {};
    const auto written = [&sentence](std::size_t first, std::size_t count) {
        std::string text;
        for (std::size_t i = first; i < first + count; ++i)
            text += (i > first ? "," : "") + std::string(sentence.field(i));
        return text.find_first_not_of(',') == std::string::npos ? std::string() : text;
    };
    NmeaUnread unread;
    if (!timeOf(sentence.field(0)))
        unread.time = written(0, 1);
    if (minimum && !shortDateOf(sentence.field(8)))
        unread.date = written(8, 1);
    if (clock && !longDateOf(sentence))
        unread.date = written(1, 3);
    const std::size_t place = minimum ? 2 : 1;
    const bool tells = minimum ? sentence.field(1) == "A" : fix && sentence.field(5) != "0" && !sentence.field(5).empty();
    if (tells
        && (!coordinate(sentence.field(place), sentence.field(place + 1), 'N', 'S', 90.0)
            || !coordinate(sentence.field(place + 2), sentence.field(place + 3), 'E', 'W', 180.0)))
        unread.place = written(place, 4);
    return unread;
}

NmeaValue valueOf(const NmeaSentence& sentence)
{
    if (sentence.talker == "P")
        return {};
    if (sentence.type == "HDG" || sentence.type == "HDM")
        return compassOf(sentence);
    if (sentence.type == "HDT" || sentence.type == "THS")
        return trueHeadingOf(sentence);
    if (sentence.type == "VHW")
        return waterOf(sentence);
    if (sentence.type == "ZDA")
        return clockOf(sentence);
    if (sentence.type == "RMC")
        return recommendedMinimum(sentence);
    if (sentence.type == "VTG")
        return trackMadeGood(sentence);
    if (sentence.type == "GGA")
        return fixOf(sentence);
    return {};
}

} // namespace lubberline
