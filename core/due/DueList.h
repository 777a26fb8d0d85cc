#pragma once
/// What is due in a fleet, the most urgent first.

#include <span>
#include <string>
#include <vector>

#include "core/due/CalendarFile.h"
#include "core/due/DueRules.h"
#include "core/record/FleetRows.h"

namespace lubberline {

/// An aircraft that is based elsewhere than where its compass was last swung, and what is predicted for it there.
struct MovePrediction {
    CompassId compass;
    Message reason; ///< empty: it stays within its limits
};

/// What is expected of a compass by the history of its fleet.
struct CompassForecast {
    CompassId compass;
    DueForecast forecast;
};

struct DueLine {
    DueCompass compass;
    DueAnswer answer;
};

/// The swing by which a compass is out of its limits; none: it is within them as far as is known. Of the signed swings those of the
/// newest day decide, as left before as found; a newer one that is complete and not signed can only say that it is out.
[[nodiscard]] std::optional<LimitsFinding> outOfLimits(std::span<const LimitsFinding> newestFirst);

/// Events and waivers of the compass's aircraft as the rules take them.
/// @param moves, forecasts  of any compasses; its own is looked for. Forecasts are in the order of their compasses.
[[nodiscard]] DueInput inputFor(const DueCompass& compass, std::span<const DueRule> rules, std::span<const MovePrediction> moves,
    Date today, std::span<const CompassForecast> forecasts = {});

/// Every compass, overdue first, then due, due soon, not due; in each by the day since which it is, then by name.
[[nodiscard]] std::vector<DueLine> dueList(std::span<const DueCompass> compasses, std::span<const DueRule> rules,
    std::span<const MovePrediction> moves, Date today, std::span<const CompassForecast> forecasts = {});

/// Whole-day entries: for each compass with a calendar rule its last day, and for each other open flag the day since which it
/// is open or expected. A compass that was never swung has no such day: the list tells it, the calendar cannot.
[[nodiscard]] std::vector<CalendarEntry> calendarOf(std::span<const DueLine> lines);

[[nodiscard]] std::string_view nameOf(DueState state); ///< "not_due", "due_soon", "due", "overdue"

/// Calendar rules whose source was read; none applies before the user takes it over: 24 months (CASA AWB 34-008, as reported by
/// the trade press), 12 months (South Africa, CATS 43.02.18, as quoted).
[[nodiscard]] std::vector<DueRule> knownRules();

/// "hard landing".
[[nodiscard]] std::string inWords(DueCause cause);

/// The cause that the crew's words speak of ("struck by lightning" → Lightning); Other where they speak of none.
[[nodiscard]] DueCause causeInWords(std::string_view words);

} // namespace lubberline
