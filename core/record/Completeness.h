#pragma once

#include <string_view>

#include "core/base/Message.h"
#include "core/record/Swing.h"

namespace lubberline {

/// Swing::procedure of the two-minute check (core/check): two or three readings, which are held against the compass's history.
inline constexpr std::string_view kCheckProcedure = "two-minute check";

/// Doubt of a date that is more than a day after today; empty: none.
[[nodiscard]] Message comesLater(Date date, Date today);

/// Whether somebody has said how he knows that it was that day (ClockDates.h).
enum class DayKnown { No, Yes };

/// What keeps a swing from being completed: no date, one that is still to come, or one that a clock shows which does not know the day; half a reading; fewer than four that count (two of a two-minute check);
/// one person as adjuster and inspector. Empty: nothing. @param today ISO 8601, of the clock that the caller was given (core/base/Clock.h).
[[nodiscard]] Message missingIn(const Swing& swing, Date today, DayKnown day = DayKnown::No);

} // namespace lubberline
