#include "core/base/DateText.h"

#include <array>

#include "core/base/FileText.h"

namespace lubberline {

std::optional<Date> dateAsWritten(std::string_view text, DateOrder order)
{
    if (const auto day = Date::read(text))
        return day;
    std::array<int, 3> parts{};
    std::array<std::size_t, 3> digits{};
    std::size_t part = 0;
    for (const char c : trimmed(text)) {
        if (c >= '0' && c <= '9') {
            if (++digits[part] > 4)
                return {};
            parts[part] = 10 * parts[part] + (c - '0');
        } else if ((c == '.' || c == '/' || c == '-') && part < 2 && digits[part] > 0) {
            ++part;
        } else {
            return {};
        }
    }
    const std::size_t year = order == DateOrder::YearMonthDay ? 0 : 2;
    const std::size_t month = order == DateOrder::MonthDayYear ? 0 : 1, day = 3 - year - month;
    if (part != 2 || digits[year] != 4 || digits[month] == 0 || digits[month] > 2 || digits[day] == 0 || digits[day] > 2)
        return {};
    const std::chrono::year_month_day ymd(std::chrono::year(parts[year]), std::chrono::month(static_cast<unsigned>(parts[month])),
        std::chrono::day(static_cast<unsigned>(parts[day])));
    return ymd.ok() ? std::optional(Date(ymd)) : std::nullopt;
}

std::optional<Date> plainDate(std::string_view text)
{
    if (const auto day = dateAsWritten(text, DateOrder::YearMonthDay))
        return day;
    return text.find_first_of("/-") == text.npos ? dateAsWritten(text, DateOrder::DayMonthYear) : std::nullopt;
}

} // namespace lubberline
