#include "core/base/Calendar.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cstdio>

#include "core/base/Contract.h"
#include "core/base/FileText.h"

namespace lubberline {

namespace {

using namespace std::chrono;

year_month_day calendarDay(const std::string& date)
{
    LUBBERLINE_EXPECT(isIsoDate(date), "a date is YYYY-MM-DD and a day of the calendar");
    int parts[3] = {};
    const char* begin = date.data();
    std::from_chars(begin, begin + 4, parts[0]);
    std::from_chars(begin + 5, begin + 7, parts[1]);
    std::from_chars(begin + 8, begin + 10, parts[2]);
    return {year(parts[0]), month(static_cast<unsigned>(parts[1])), day(static_cast<unsigned>(parts[2]))};
}

std::string textOf(const year_month_day& date)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%04d-%02u-%02u", static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
        static_cast<unsigned>(date.day()));
    return text.data();
}

} // namespace

std::string addMonths(const std::string& date, int count)
{
    const year_month_day from = calendarDay(date);
    const year_month month = year_month(from.year(), from.month()) + months(count);
    const year_month_day last(month / std::chrono::last);
    return textOf({month.year(), month.month(), std::min(from.day(), last.day())});
}

std::string addDays(const std::string& date, int count) { return textOf(year_month_day(sys_days(calendarDay(date)) + days(count))); }

int daysBetween(const std::string& from, const std::string& to)
{
    return static_cast<int>((sys_days(calendarDay(to)) - sys_days(calendarDay(from))).count());
}

} // namespace lubberline
