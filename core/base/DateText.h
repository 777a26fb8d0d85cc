#pragma once
/// Days as people and spreadsheets write them.

#include <optional>
#include <string_view>

#include "core/base/Date.h"

namespace lubberline {

enum class DateOrder { YearMonthDay, DayMonthYear, MonthDayYear };

/// A day as it is written on paper: 2019-12-31, or in the given order with dots, strokes or hyphens between.
[[nodiscard]] std::optional<Date> dateAsWritten(std::string_view text, DateOrder order);
/// A day whose order nobody has to say: 2019-12-31 and 2019/12/31 begin with the year, and dots are set between day, month and year
/// (31.12.2019, as spreadsheets of half of Europe write it), never between month, day and year.
[[nodiscard]] std::optional<Date> plainDate(std::string_view text);

} // namespace lubberline
