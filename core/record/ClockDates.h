#pragma once
/// Days that a clock shows which does not know the date: a swing or a log of such a day is doubted.

#include "core/base/Date.h"
#include "core/base/Message.h"

namespace lubberline {

/// The week count of GPS begins anew after 1024 weeks; a receiver that misses it is that much behind.
inline constexpr int kGpsRollOver_days = 1024 * 7;

/// The GPS week count begins on this day: 1980-01-06 and every 1024 weeks from it.
[[nodiscard]] bool beginsGpsWeeks(Date date);

/// Doubt of a day on which receivers, computers or spreadsheets begin to count; a whole number
/// of 1024 weeks before one of the last seven days; and of one before there were aircraft. Empty: none. Somebody who was there may know that it was that day all the same.
[[nodiscard]] Message doubtOfClock(Date date, Date today);

/// The same, and of a day that is more than a day after today, which nobody can know better.
[[nodiscard]] Message doubtOfDate(Date date, Date today);

} // namespace lubberline
