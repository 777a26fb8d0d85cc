#include "core/base/Date.h"

#include <algorithm>
#include <cstdio>

#include "core/base/Contract.h"

namespace lubberline {

using std::chrono::sys_days, std::chrono::year_month, std::chrono::year_month_day;

Date::Date(year_month_day day)
    : Date(static_cast<int>(day.year()), static_cast<int>(static_cast<unsigned>(day.month())),
        static_cast<int>(static_cast<unsigned>(day.day())))
{
    LUBBERLINE_EXPECT(day.ok() && m_year >= 0 && m_year <= 9999, "a date is a day of the calendar, of the years 0 to 9999");
}

year_month_day Date::day() const
{
    LUBBERLINE_EXPECT(!empty(), "a day is asked of a date that is stated");
    return {std::chrono::year(m_year), std::chrono::month(m_month), std::chrono::day(m_day)};
}

std::string Date::text() const
{
    if (empty())
        return {};
    char text[32];
    std::snprintf(text, sizeof text, "%04d-%02d-%02d", m_year, m_month, m_day);
    return text;
}

Date addMonths(Date date, int count)
{
    const year_month_day from = date.day();
    const year_month month = year_month(from.year(), from.month()) + std::chrono::months(count);
    const auto last = year_month_day(month / std::chrono::last).day();
    return Date({month.year(), month.month(), std::min(from.day(), last)});
}

Date addDays(Date date, int count) { return Date(year_month_day(sys_days(date.day()) + std::chrono::days(count))); }

int daysBetween(Date from, Date to) { return static_cast<int>((sys_days(to.day()) - sys_days(from.day())).count()); }

} // namespace lubberline
