#include "core/base/UtcTime.h"

#include <cmath>

#include "core/base/Date.h"
#include "core/base/FileText.h"
#include "core/base/Number.h"

namespace lubberline {

namespace {

/// Two digits and no more than `most`; −1: none.
int twoDigits(std::string_view& text, int most)
{
    if (text.size() < 2 || text[0] < '0' || text[0] > '9' || text[1] < '0' || text[1] > '9')
        return -1;
    const int value = 10 * (text[0] - '0') + text[1] - '0';
    text.remove_prefix(2);
    return value <= most ? value : -1;
}

bool take(std::string_view& text, char sign)
{
    if (text.empty() || text.front() != sign)
        return false;
    text.remove_prefix(1);
    return true;
}

} // namespace

Result<UtcTime> readUtcTime(std::string_view iso)
{
    const std::string_view whole = trimmed(iso);
    const auto wrong = [&whole](Pattern why) { return Error{ErrorCode::InvalidInput, {why, inQuotes(whole)}}; };
    constexpr Pattern kNone = MARKED("core", "%1 is no time; expected YYYY-MM-DDTHH:MM:SSZ");
    const auto date = whole.size() > 11 ? Date::read(whole.substr(0, 10)) : std::nullopt;
    if (!date || (whole[10] != 'T' && whole[10] != ' '))
        return wrong(kNone);
    std::string_view rest = whole.substr(11);
    const int hour = twoDigits(rest, 23), minute = take(rest, ':') ? twoDigits(rest, 59) : -1;
    if (hour < 0 || minute < 0)
        return wrong(kNone);
    double seconds = 0;
    if (take(rest, ':')) {
        const auto end = rest.find_first_not_of("0123456789.");
        const FileNumber number = readNumber(rest.substr(0, end));
        if (end == 0 || number.fault != NumberFault::None || number.value < 0 || number.value >= 61)
            return wrong(kNone);
        seconds = number.value;
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end);
    }
    int offset_min = 0;
    if (rest.empty())
        return wrong(MARKED("core", "%1 does not say which clock it is of; expected Z (UTC) or an offset as +02:00 behind it"));
    if (!take(rest, 'Z')) {
        const bool west = take(rest, '-');
        if (!west && !take(rest, '+'))
            return wrong(kNone);
        const int hours = twoDigits(rest, 14);
        take(rest, ':');
        const int minutes = twoDigits(rest, 59);
        if (hours < 0 || minutes < 0)
            return wrong(kNone);
        offset_min = (west ? -1 : 1) * (60 * hours + minutes);
    }
    if (!rest.empty())
        return wrong(kNone);
    return UtcTime(std::chrono::sys_days(date->day()) + std::chrono::hours(hour) + std::chrono::minutes(minute - offset_min)
        + std::chrono::milliseconds(std::llround(seconds * 1000)));
}

bool isUtcText(std::string_view iso) { return iso.size() > 10 && iso[10] == 'T' && iso.back() == 'Z' && readUtcTime(iso).ok(); }

double daysSince2000(UtcTime time)
{
    constexpr std::chrono::sys_days kDay = std::chrono::year(2000) / 1 / 1;
    return std::chrono::duration<double, std::ratio<86400>>(time - kDay).count() - 0.5;
}

} // namespace lubberline
