#pragma once
/// Days of the calendar as ISO 8601 text (YYYY-MM-DD): the order of the text is the order of the days, and there are no time
/// zones. All dates of records are UTC; "today" is asked of the caller.

#include <string>

namespace lubberline {

/// The same day `months` later; where that month has no such day, its last one (29 February + 12 months is 28 February).
/// The date must be a day of the calendar (isIsoDate).
[[nodiscard]] std::string addMonths(const std::string& date, int months);
[[nodiscard]] std::string addDays(const std::string& date, int days);
/// to − from, in days.
[[nodiscard]] int daysBetween(const std::string& from, const std::string& to);

} // namespace lubberline
