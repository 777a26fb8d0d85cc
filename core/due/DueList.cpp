#include "core/due/DueList.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <tuple>

#include "core/base/Number.h"
#include "core/record/RecordWords.h"

namespace lubberline {

namespace {

/// The first that is found decides: the longer words stand before those that are part of others. A word stands for all that
/// begin with it, so that "removed" does not speak of moving, nor "restored" of storage.
struct Word {
    std::string_view word;
    DueCause cause;
};
constexpr std::array kWords{Word{"lightning", DueCause::Lightning}, Word{"thunder", DueCause::ElectricalStorm},
    Word{"electrical storm", DueCause::ElectricalStorm}, Word{"storm", DueCause::ElectricalStorm},
    Word{"hard landing", DueCause::HardLanding}, Word{"heavy landing", DueCause::HardLanding}, Word{"accident", DueCause::HardLanding},
    Word{"turbulence", DueCause::HardLanding}, Word{"shock", DueCause::HardLanding}, Word{"suspect", DueCause::AccuracySuspected},
    Word{"inaccura", DueCause::AccuracySuspected}, Word{"doubt", DueCause::AccuracySuspected}, Word{"magneto", DueCause::EngineChange},
    Word{"engine", DueCause::EngineChange}, Word{"avionic", DueCause::Modification}, Word{"modif", DueCause::Modification},
    Word{"electric", DueCause::ElectricalChange}, Word{"wiring", DueCause::ElectricalChange}, Word{"rewir", DueCause::ElectricalChange},
    Word{"cargo", DueCause::MagneticCargo}, Word{"magnet", DueCause::MagneticCargo}, Word{"moved", DueCause::Moved},
    Word{"relocat", DueCause::Moved}, Word{"parked", DueCause::ParkedOverAYear}, Word{"stored", DueCause::ParkedOverAYear},
    Word{"storage", DueCause::ParkedOverAYear}, Word{"new compass", DueCause::PartsReplaced}, Word{"replac", DueCause::PartsReplaced},
    Word{"repair", DueCause::PartsReplaced}, Word{"removed", DueCause::PartsReplaced}, Word{"fitted", DueCause::PartsReplaced},
    Word{"install", DueCause::PartsReplaced}, Word{"reinstall", DueCause::PartsReplaced}, Word{"overhaul", DueCause::PartsReplaced}};

std::string lowerCase(std::string_view words)
{
    std::string lower(words);
    std::transform(
        lower.begin(), lower.end(), lower.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return lower;
}

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (static_cast<unsigned char>(c) & 0x80) != 0; }

bool speaksOf(std::string_view text, std::string_view word)
{
    for (auto at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1))
        if (at == 0 || !isLetter(text[at - 1]))
            return true;
    return false;
}

/// The crew's words, with the cause where they do not tell it.
Message reasonOf(const Event& event)
{
    if (event.kind.empty() || event.kind == fileWord(event.cause)) // as an exchange file has it
        return shownWord(event.cause);
    if (causeInWords(event.kind) == event.cause)
        return Message::verbatim(event.kind);
    return {MARKED("core", "%1 (%2)"), event.kind, shownWord(event.cause)};
}

/// Of the swings of one day: those as left, where there are any; the worst of them (a swing for each configuration).
const LimitsFinding* worstOfDay(std::span<const LimitsFinding> findings, Date day)
{
    const auto weight = [](const LimitsFinding& one) {
        return std::tuple(one.stage == SwingStage::AsLeft, one.status, one.maxAbsDeviation_deg.value_or(0));
    };
    const LimitsFinding* worst = nullptr;
    for (const auto& one : findings)
        if (one.date == day && one.status != Status::NotKnown && (!worst || weight(one) > weight(*worst)))
            worst = &one;
    return worst;
}

Message outOfLimitsWords(const LimitsFinding& finding, const DueCompass& compass)
{
    const std::string source = compass.limitDocument.empty() ? std::string() : " (" + compass.limitDocument + ")";
    if (!finding.maxAbsDeviation_deg || !compass.limit_deg || *finding.maxAbsDeviation_deg <= *compass.limit_deg)
        return {MARKED("core", "OUT OF LIMITS by the swing of %1"), finding.date};
    return {MARKED("core", "OUT OF LIMITS by the swing of %1: up to %2°, %3° is allowed%4"), finding.date,
        figureText(*finding.maxAbsDeviation_deg, 1), shortestNumber(*compass.limit_deg), source};
}

Date dayOf(const DueLine& line) { return line.answer.flags.empty() ? line.answer.nextByCalendar : line.answer.flags.front().since; }

} // namespace

std::optional<LimitsFinding> outOfLimits(std::span<const LimitsFinding> newestFirst)
{
    const auto isSigned = [](const LimitsFinding& one) { return one.isSigned && one.status != Status::NotKnown; };
    const auto newest = std::find_if(newestFirst.begin(), newestFirst.end(), isSigned);
    std::vector<LimitsFinding> signedOnes;
    std::copy_if(newestFirst.begin(), newestFirst.end(), std::back_inserter(signedOnes), isSigned);
    if (newest != newestFirst.end())
        if (const auto* worst = worstOfDay(signedOnes, newest->date); worst->status == Status::OutOfLimits)
            return *worst;
    for (const auto& one : newestFirst) { // the newest day after it
        if (newest != newestFirst.end() && one.date <= newest->date)
            break;
        if (const auto* worst = worstOfDay(newestFirst, one.date))
            return worst->status == Status::OutOfLimits ? std::optional(*worst) : std::nullopt;
    }
    return {};
}

DueInput inputFor(const DueCompass& compass, std::span<const DueRule> rules, std::span<const MovePrediction> moves, Date today,
    std::span<const CompassForecast> forecasts)
{
    DueInput input;
    input.today = today;
    input.signedSwings = compass.signedSwings;
    for (const auto& event : compass.events)
        input.events.push_back({event.record, event.date, event.cause, reasonOf(event)});
    input.waivers = compass.waivers;
    input.rule = ruleFor(rules, compass.typeRecord);
    input.installed = compass.installed;
    if (const auto finding = outOfLimits(compass.findings)) {
        input.outOfLimitsSince = finding->date;
        input.outOfLimitsReason = outOfLimitsWords(*finding, compass);
    }
    const auto move = std::find_if(
        moves.begin(), moves.end(), [&](const MovePrediction& one) { return one.compass == compass.compass && !one.reason.empty(); });
    if (move != moves.end()) {
        input.predictedOutOfLimits = true;
        input.predictedReason = move->reason;
    }
    const auto forecast = std::ranges::lower_bound(forecasts, compass.compass, {}, &CompassForecast::compass);
    if (forecast != forecasts.end() && forecast->compass == compass.compass)
        input.forecast = forecast->forecast;
    return input;
}

std::vector<DueLine> dueList(std::span<const DueCompass> compasses, std::span<const DueRule> rules, std::span<const MovePrediction> moves,
    Date today, std::span<const CompassForecast> forecasts)
{
    std::vector<DueLine> lines;
    lines.reserve(compasses.size());
    for (const auto& compass : compasses)
        lines.push_back({compass, dueOf(inputFor(compass, rules, moves, today, forecasts))});
    std::stable_sort(lines.begin(), lines.end(), [](const DueLine& a, const DueLine& b) {
        if (a.answer.state != b.answer.state)
            return a.answer.state > b.answer.state;
        return dayOf(a) < dayOf(b);
    });
    return lines;
}

std::vector<CalendarEntry> calendarOf(std::span<const DueLine> lines)
{
    std::vector<CalendarEntry> entries;
    for (const auto& line : lines) {
        const std::string whose = line.compass.registration + ", " + line.compass.compassName;
        if (!line.answer.nextByCalendar.empty())
            entries.push_back({"swing-" + line.compass.compassRecord + "@lubberline", line.answer.nextByCalendar,
                "Compass swing of " + whose + " falls due", "last signed swing " + line.answer.lastSigned.text()});
        for (const auto& flag : line.answer.flags) {
            const bool calendarsOwn = flag.since == line.answer.nextByCalendar && !flag.probability;
            if (flag.since.empty() || calendarsOwn)
                continue; // no day to stand on; or told above
            const std::string what = flag.probability ? "forecast-" : flag.event.empty() ? "place-" : "event-" + flag.event + "-";
            entries.push_back({what + line.compass.compassRecord + "@lubberline", flag.since,
                "Compass swing of " + whose + (flag.state == DueState::DueSoon ? " is due soon" : " is due"), flag.reason.english()});
        }
    }
    return entries;
}

std::string_view nameOf(DueState state)
{
    static constexpr std::array<std::string_view, 4> kNames{"not_due", "due_soon", "due", "overdue"};
    return kNames[static_cast<std::size_t>(state)];
}

std::string inWords(DueCause cause)
{
    std::string words(fileWord(cause));
    std::replace(words.begin(), words.end(), '_', ' ');
    return words;
}

std::vector<DueRule> knownRules()
{
    return {{{}, "CASA, 24 months", 24, 0, 60, "CASA AWB 34-008, as reported in \"Staying true\"", "Issue 3", {}},
        {{}, "South Africa, 12 months", 12, 0, 60, "CATS 43.02.18, as quoted", {}, {}}};
}

DueCause causeInWords(std::string_view words)
{
    const std::string lower = lowerCase(words);
    const auto found = std::find_if(kWords.begin(), kWords.end(), [&](const Word& one) { return speaksOf(lower, one.word); });
    return found == kWords.end() ? DueCause::Other : found->cause;
}

} // namespace lubberline
