#include "core/base/Clock.h"

#include <cstdio>

namespace lubberline {

namespace {

using namespace std::chrono;

Date dateOf(Clock::Time time) { return Date(year_month_day(floor<days>(time))); }

std::string textOf(Clock::Time time, bool withMilliseconds)
{
    const hh_mm_ss day(time - floor<days>(time));
    char text[32];
    std::snprintf(text, sizeof text, "T%02d:%02d:%02d", static_cast<int>(day.hours().count()), static_cast<int>(day.minutes().count()),
        static_cast<int>(day.seconds().count()));
    std::string result = dateOf(time).text() + text;
    if (withMilliseconds) {
        std::snprintf(text, sizeof text, ".%03d", static_cast<int>(day.subseconds().count()));
        result += text;
    }
    return result + "Z";
}

} // namespace

Date Clock::today() const { return dateOf(now()); }
std::string Clock::nowUtc() const { return textOf(now(), false); }
std::string Clock::nowUtc_ms() const { return textOf(now(), true); }

Clock machineClock()
{
    return {[] { return floor<milliseconds>(system_clock::now()); }};
}

} // namespace lubberline
