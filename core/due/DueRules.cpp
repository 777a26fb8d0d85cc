#include "core/due/DueRules.h"

#include <algorithm>
#include <cmath>

#include "core/record/ClockDates.h"

namespace lubberline {

namespace {

std::optional<DueFlag> calendarFlag(const DueInput& input, Date lastSigned)
{
    if (!input.rule)
        return {};
    if (lastSigned.empty())
        return DueFlag{DueState::Due, {}, MARKED("core", "no signed swing is on record"), {}};
    const Date last = addMonths(lastSigned, input.rule->months);
    const int left = daysBetween(input.today, last);
    const Message words{MARKED_N("core", "%1: %n month(s) after the swing of %2"), input.rule->months, input.rule->name, lastSigned};
    if (left < -input.rule->graceDays)
        return DueFlag{DueState::Overdue, last, words, {}};
    if (left < 0)
        return DueFlag{DueState::Due, last, words, {}};
    if (left <= input.rule->warnDays)
        return DueFlag{DueState::DueSoon, last, words, {}};
    return {};
}

/// Every source wants a swing after the installation. One on the day itself is of the compass as installed: before, there was
/// none to swing.
std::optional<DueFlag> installationFlag(const DueInput& input, Date lastSigned)
{
    if (input.installed.empty() || input.installed > input.today || lastSigned >= input.installed)
        return {};
    return DueFlag{DueState::Due, input.installed, {MARKED("core", "installed on %1, and no swing signed since"), input.installed}, {}};
}

std::optional<DueFlag> forecastFlag(const DueInput& input, Date lastSigned)
{
    if (!input.forecast || input.forecast->probability < kForecastSoon || lastSigned > input.forecast->lastSwing)
        return {};
    const DueForecast& forecast = *input.forecast;
    const bool due = forecast.probability >= kForecastDue;
    const auto percent = static_cast<int>(std::lround(100 * forecast.probability));
    const Message words = percent > 99
        ? Message{MARKED("core", "over 99 % likely out of limits by %1: %2"), forecast.by, forecast.reason}
        : Message{MARKED("core", "%1 % likely out of limits by %2: %3"), percent, forecast.by, forecast.reason};
    const Date since = due && !forecast.since.empty() ? std::min(forecast.since, forecast.by) : forecast.by;
    return DueFlag{due ? DueState::Due : DueState::DueSoon, since, words, {}, forecast.probability};
}

/// An engine's change can be planned; nobody plans to be struck by lightning. What is of tomorrow happened where the day has begun already.
bool isToCome(const DueEvent& event, Date today)
{
    switch (event.cause) {
    case DueCause::Lightning:
    case DueCause::ElectricalStorm:
    case DueCause::HardLanding:
    case DueCause::AccuracySuspected: return event.date > today && doubtOfDate(event.date, today).empty();
    default: return event.date > today;
    }
}

/// Not written, still to come, or one from which clocks count: whether the compass was swung after it nobody can tell.
bool dayIsKnown(const DueEvent& event, Date today) { return !event.date.empty() && doubtOfDate(event.date, today).empty(); }

Message wordsOf(const DueEvent& event, bool dayKnown)
{
    if (dayKnown)
        return event.reason;
    return event.date.empty()
        ? Message{MARKED("core", "%1, on a day that is not recorded: it may have been after the last swing"), event.reason}
        : Message{MARKED("core", "%1, dated %2, which cannot be right: it may have been after the last swing"), event.reason, event.date};
}

bool answered(const DueEvent& event, const DueInput& input, Date lastSigned)
{
    const bool swung = dayIsKnown(event, input.today) && !lastSigned.empty() && lastSigned > event.date;
    return swung
        || std::any_of(input.waivers.begin(), input.waivers.end(), [&](const Waiver& waiver) { return waiver.event == event.record; });
}

} // namespace

DueAnswer dueOf(const DueInput& input)
{
    DueAnswer answer;
    if (!input.signedSwings.empty())
        answer.lastSigned = *std::max_element(input.signedSwings.begin(), input.signedSwings.end());
    if (input.rule && !answer.lastSigned.empty())
        answer.nextByCalendar = addMonths(answer.lastSigned, input.rule->months);
    if (auto flag = calendarFlag(input, answer.lastSigned))
        answer.flags.push_back(std::move(*flag));
    if (auto flag = installationFlag(input, answer.lastSigned))
        answer.flags.push_back(std::move(*flag));
    for (const auto& event : input.events) {
        if (event.cause == DueCause::Other || isToCome(event, input.today) || answered(event, input, answer.lastSigned))
            continue;
        const bool known = dayIsKnown(event, input.today);
        if (known && !input.installed.empty() && input.installed <= input.today && event.date < input.installed)
            continue; // before this compass was on the aircraft
        answer.flags.push_back({DueState::Due, known ? event.date : Date(), wordsOf(event, known), event.record});
    }
    if (!input.outOfLimitsSince.empty())
        answer.flags.push_back({DueState::Due, input.outOfLimitsSince, input.outOfLimitsReason, {}});
    if (input.predictedOutOfLimits)
        answer.flags.push_back({DueState::Due, input.today, input.predictedReason, {}});
    if (auto flag = forecastFlag(input, answer.lastSigned); flag && input.outOfLimitsSince.empty()) // where it is out, no chance is told
        answer.flags.push_back(std::move(*flag));
    std::stable_sort(answer.flags.begin(), answer.flags.end(),
        [](const DueFlag& a, const DueFlag& b) { return a.state != b.state ? a.state > b.state : a.since < b.since; });
    if (!answer.flags.empty())
        answer.state = answer.flags.front().state;
    return answer;
}

std::optional<DueRule> ruleFor(std::span<const DueRule> rules, const RecordId& type)
{
    const auto own = std::find_if(rules.begin(), rules.end(), [&](const DueRule& rule) { return !rule.type.empty() && rule.type == type; });
    if (own != rules.end())
        return *own;
    const auto common = std::find_if(rules.begin(), rules.end(), [](const DueRule& rule) { return rule.type.empty(); });
    return common != rules.end() ? std::optional(*common) : std::nullopt;
}

} // namespace lubberline
