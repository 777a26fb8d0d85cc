#pragma once
/// When a compass is to be swung: calendar rules, and the events after which sources want a new swing (AC 43.13-1B 12-37; CASA;
/// …: docs/bibliography.md). An event opens a flag that only a later signed swing or a recorded waiver clears.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/Date.h"
#include "core/base/Message.h"
#include "core/record/Aircraft.h"
#include "core/record/DueRule.h"

namespace lubberline {

struct DueEvent {
    RecordId record;
    Date date;
    DueCause cause = DueCause::Other;
    Message reason; ///< the crew's words, with the cause where they do not tell it
};

/// What the years of swings of a fleet expect of one of its compasses (core/fleet/Ranking.h).
struct DueForecast {
    double probability = 0; ///< of being out of limits at some time up to `by`
    Date by;                ///< its next date
    Date since;             ///< from when on it is as likely out as not; empty: not up to `by`
    Date lastSwing;         ///< the newest it knows of: one that is signed later makes it void
    Message reason;
};

/// From this chance on a compass is due: it is as likely out of limits before its next date as not.
inline constexpr double kForecastDue = 0.5;
/// From this one on it is due soon: more than one of five such compasses will be out.
inline constexpr double kForecastSoon = 0.2;

/// What the rules look at, for one compass.
struct DueInput {
    Date today;                     ///< UTC
    std::vector<Date> signedSwings; ///< their days, in any order
    std::vector<DueEvent> events;
    std::vector<Waiver> waivers;
    std::optional<DueRule> rule;       ///< calendar; none: no calendar rule applies
    Date installed;                    ///< since when the compass is on the aircraft; empty: not stated
    bool predictedOutOfLimits = false; ///< where the aircraft is based now (core/swing/Prediction.h)
    Message predictedReason;
    Date outOfLimitsSince = {}; ///< the day of the swing that says so; empty: it is within its limits, or they are not known
    Message outOfLimitsReason = {};
    std::optional<DueForecast> forecast = {}; ///< none: not known
};

enum class DueState { NotDue, DueSoon, Due, Overdue };

struct DueFlag {
    DueState state = DueState::Due;
    Date since; ///< the day of the event or installation, or the calendar's last day; empty: never swung, or not known
    Message reason;
    RecordId event;                         ///< that opened it; empty: calendar, installation, prediction or forecast
    std::optional<double> probability = {}; ///< of a forecast
};

struct DueAnswer {
    DueState state = DueState::NotDue; ///< the most urgent flag
    std::vector<DueFlag> flags;        ///< the most urgent first
    Date lastSigned;                   ///< empty: none
    Date nextByCalendar;               ///< the last day on which it is not overdue without grace; empty: no rule or never swung
};

/// Calendar: a swing of 23 November 2024 with 24 months is good through 23 November 2026, due from the day after, overdue when
/// the grace has passed, too. Never signed: due. Events: open while no signed swing is dated after the event's day, and no
/// waiver answers them; a swing of the same day does not tell whether it came after, so it does not clear (a waiver does), and no swing clears
/// an event whose day is not recorded or cannot be right (still to come, one from which clocks count).
/// Forecast: due and due soon from the chances above on, until a swing is signed that it does not know of.
/// Installed after the last signed swing: due, until one of that day or later is signed.
/// Out of limits: due, whatever is signed, until a signed swing says that it is within them.
[[nodiscard]] DueAnswer dueOf(const DueInput& input);

/// The rule for an aircraft type: its own, else one for all, else none. The first of several.
[[nodiscard]] std::optional<DueRule> ruleFor(std::span<const DueRule> rules, const RecordId& type);

} // namespace lubberline
