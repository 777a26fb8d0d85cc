#include "core/fleet/FleetReport.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/Number.h"
#include "core/fleet/SignCheck.h"

namespace lubberline {

namespace {

Error cancelled() { return {ErrorCode::Cancelled, MARKED("core", "cancelled")}; }

/// A part of the whole work.
Progress part(const Progress& whole, double from, double to)
{
    if (!whole)
        return {};
    return [&whole, from, to](double fraction) { return whole(from + (to - from) * fraction); };
}

void addLeftOut(FleetCounts& counts, const char* reason, std::int64_t swings)
{
    if (swings > 0)
        counts.leftOut.push_back({reason, swings});
}

FleetCounts countsOf(const FleetSwings& fleet, const FleetCurves& curves, const FleetOptions& options)
{
    FleetCounts counts;
    counts.leftOut = fleet.leftOut;
    std::set<std::pair<std::string, std::string>> aircraft;
    std::set<std::int32_t> compasses;
    std::int64_t otherStage = 0, noFit = 0, farOut = 0;
    for (std::size_t row = 0; row < fleet.swings.size(); ++row) {
        const auto& swing = fleet.swings[row];
        if (options.stage && swing.stage != *options.stage) {
            ++otherStage;
            continue;
        }
        if (!curves.curves[row].fitted()) {
            ++(curves.curves[row].farOut ? farOut : noFit);
            continue;
        }
        ++counts.used;
        if (compasses.insert(swing.compass).second) {
            const auto& compass = fleet.compasses[static_cast<std::size_t>(swing.compass)];
            aircraft.emplace(compass.type, compass.aircraft);
        }
    }
    counts.aircraft = static_cast<std::int64_t>(aircraft.size());
    counts.compasses = static_cast<std::int64_t>(compasses.size());
    addLeftOut(counts, "other stage", otherStage);
    addLeftOut(counts, "too few headings for a curve", noFit);
    addLeftOut(counts, "the compass is far out as a whole", farOut);
    counts.swings = counts.used;
    for (const auto& each : counts.leftOut)
        counts.swings += each.swings;
    std::ranges::sort(counts.leftOut, {}, &SwingsLeftOut::reason);
    return counts;
}

CoefficientVariance varianceOf(
    const FleetSwings& fleet, const FleetCurves& curves, const FleetOptions& options, std::size_t c, const Progress& progress)
{
    std::vector<VarianceRow> rows;
    for (std::size_t row = 0; row < fleet.swings.size(); ++row) {
        const auto& swing = fleet.swings[row];
        if (curves.curves[row].known(c) && (!options.stage || swing.stage == *options.stage))
            rows.push_back({curves.curves[row].value_deg[c], swing.compass, swing.crew, swing.site});
    }
    auto report = varianceComponents(std::move(rows), 0.95, progress);
    if (report)
        return {std::move(report.value()), {}};
    return {{}, report.error().message};
}

/// Jumps and drifts where the crews' training is not taken for one.
Result<FleetChanges> changesBesideTraining(const FleetSwings& fleet, const FleetCurves& curves, std::span<const CompassHistory> histories,
    const PlantReport& plants, const Progress& progress)
{
    const std::optional<int> crews_day = plants.training ? std::optional(plants.training->day) : std::nullopt;
    return changesOf(fleet, curves, histories, crews_day, kFalseDiscoveryRate, progress);
}

std::vector<HarmonicOrder> spectrumOf(const FleetSwings& fleet, const FleetCurves& curves, const FleetOptions& options, SwingStage stage)
{
    PatternOptions pattern{options.grid, options.vote, stage};
    return patternOf(fleet, curves, pattern).mean;
}

std::size_t different(const FleetSwings& fleet, std::string FleetCompass::*name)
{
    std::set<std::string_view> names;
    for (const auto& swing : fleet.swings)
        names.insert(fleet.compasses[static_cast<std::size_t>(swing.compass)].*name);
    return names.size();
}

void warnOfMixture(const FleetSwings& fleet, std::vector<Message>& warnings)
{
    if (const auto types = different(fleet, &FleetCompass::type); types > 1)
        warnings.push_back({MARKED("core", "%1 aircraft types are in one selection: their mean is that of no aircraft"), types});
    if (const auto names = different(fleet, &FleetCompass::compass); names > 1)
        warnings.push_back(
            {MARKED("core", "%1 compass systems are in one selection: choose one for a pattern that an aircraft has"), names});
    std::set<RadioState> radio;
    for (const auto& swing : fleet.swings)
        radio.insert(swing.radio);
    if (radio.contains(RadioState::On) && radio.contains(RadioState::Off))
        warnings.push_back(MARKED("core", "swings with the radio on and off are in one selection: choose one state"));
}

void warnOfWhatIsMissing(const FleetReport& report, std::vector<Message>& warnings)
{
    for (const auto& left : report.counts.leftOut)
        warnings.push_back({MARKED_N("core", "%n swing(s) left out: %1"), left.swings, left.reason});
    if (report.counts.aircraft < 2)
        warnings.push_back(MARKED("core", "one aircraft is no population: no spread between aircraft can be told"));
    if (report.exceedance.withoutLimit > 0)
        warnings.push_back(
            {MARKED_N("core", "%n pair(s) not held against a limit: their compass has none"), report.exceedance.withoutLimit});
    if (report.exceedance.pairs + report.exceedance.withoutLimit == 0)
        warnings.push_back(MARKED(
            "core", "no pair of a swing as left and the next as found: how often limits are exceeded between inspections cannot be told"));
    else if (report.exceedance.pairs > 0 && !report.exceedance.limit_deg)
        warnings.push_back(MARKED("core", "the compasses have different limits: an expected share is told for one limit only"));
    if (report.ranking.withoutLimit > 0)
        warnings.push_back({MARKED_N("core", "not ranked, as no limit is known: %n compass system(s)"), report.ranking.withoutLimit});
    std::uint32_t otherRadio = 0;
    for (const auto& history : report.histories)
        otherRadio += history.otherRadio;
    if (otherRadio > 0)
        warnings.push_back({MARKED_N("core", "%n swing(s) not compared through the years: the other radio state"), otherRadio});
    bool unknownScatter = false;
    for (const auto& kind : report.changes.scatter)
        for (const auto& scatter : kind)
            unknownScatter = unknownScatter || !scatter.known;
    if (unknownScatter)
        warnings.push_back(
            MARKED("core", "few swings of a kind: how much they scatter and wander is itself uncertain; intervals are wide for it"));
}

/// Jumps, drifts, and who next.
Result<void> tellChanges(const FleetSwings& fleet, const FleetCurves& curves, FleetReport& report, const Progress& progress)
{
    auto changes = changesBesideTraining(fleet, curves, report.histories, report.plants, part(progress, 0.3, 0.5));
    if (!changes)
        return changes.error();
    report.changes = std::move(changes.value());
    auto ranking = rankingOf(
        fleet, curves, report.histories, report.changes, {report.options.today_day, report.options.limit_deg, 0}, part(progress, 0.5, 0.6));
    if (!ranking)
        return ranking.error();
    report.ranking = std::move(ranking.value());
    return {};
}

} // namespace

Result<FleetReport> fleetReportOf(const FleetSwings& fleet, const FleetOptions& options, const Progress& progress)
{
    if (options.grid < 3 || options.grid > 360)
        return Error{ErrorCode::InvalidInput, {MARKED("core", "a grid of %1 headings; expected 3 to 360"), options.grid}};
    if (fleet.swings.empty())
        return Error{ErrorCode::InvalidInput, MARKED("core", "no swing is in the selection; expected at least one that is complete")};
    FleetReport report;
    report.options = options;
    auto curves = curvesOf(fleet, part(progress, 0.0, 0.2));
    if (!curves)
        return curves.error();
    report.counts = countsOf(fleet, *curves, options);
    report.pattern = patternOf(fleet, *curves, {options.grid, options.vote, options.stage});
    report.found = options.stage == SwingStage::AsFound ? report.pattern.mean : spectrumOf(fleet, *curves, options, SwingStage::AsFound);
    report.left = options.stage == SwingStage::AsLeft ? report.pattern.mean : spectrumOf(fleet, *curves, options, SwingStage::AsLeft);
    report.histories = historiesOf(fleet);
    report.exceedance = exceedanceOf(fleet, *curves, pairsOf(fleet, report.histories), options.limit_deg, options.grid);
    report.plants = plantsOf(fleet, *curves, options.stage, options.training_day);
    report.softIron = softIronOf(fleet, *curves);
    report.changes.driftOf.resize(report.histories.size());
    if (options.changes)
        if (const auto told = tellChanges(fleet, *curves, report, progress); !told)
            return told.error();
    for (std::size_t c = 0; c < 5 && options.variance; ++c) {
        report.variance[c] = varianceOf(
            fleet, *curves, options, c, part(progress, 0.6 + 0.08 * static_cast<double>(c), 0.68 + 0.08 * static_cast<double>(c)));
        if (progress && !progress(0.68 + 0.08 * static_cast<double>(c)))
            return cancelled();
    }
    warnOfMixture(fleet, report.warnings);
    constexpr std::size_t mostSuspicions = 10;
    const auto suspicions = suspectSigns(fleet, *curves);
    for (std::size_t i = 0; i < suspicions.size() && i < mostSuspicions; ++i)
        report.warnings.push_back(inWords(suspicions[i], fleet));
    if (suspicions.size() > mostSuspicions)
        report.warnings.push_back({MARKED_N("core", "suspect of the other sign as well: the records of %n more compass system(s)"),
            suspicions.size() - mostSuspicions});
    warnOfWhatIsMissing(report, report.warnings);
    report.curves = std::move(curves.value());
    return report;
}

Result<Ranking> swingNext(const FleetSwings& fleet, int today_day, const Progress& progress)
{
    if (fleet.swings.empty())
        return Ranking{};
    const auto curves = curvesOf(fleet, part(progress, 0.0, 0.3));
    if (!curves)
        return curves.error();
    const auto histories = historiesOf(fleet);
    const auto changes = changesBesideTraining(fleet, *curves, histories, plantsOf(fleet, *curves, {}, {}), part(progress, 0.3, 0.8));
    if (!changes)
        return changes.error();
    return rankingOf(fleet, *curves, histories, *changes, {today_day, {}, 0}, part(progress, 0.8, 1.0));
}

Message inWords(const FleetJump& jump, const FleetSwings& fleet)
{
    const auto& compass = fleet.compasses[static_cast<std::size_t>(jump.compass)];
    const std::string letter(1, letterOf(kCoefficients[jump.coefficient]));
    const std::string after = dateOfDay(fleet.swings[jump.afterRow].day), before = dateOfDay(fleet.swings[jump.beforeRow].day);
    const Message what{MARKED("core", "%1 · %2: %3 jumped by %4° (standard error %5°) between %6 and %7"), compass.aircraft,
        compass.compass, letter, signedFigureText(jump.change_deg, 2), figureText(jump.standardError_deg, 2), after, before};
    return jump.event.empty() ? what : Message{MARKED("core", "%1 (%2)"), what, jump.event};
}

Message inWords(const ChartAlarm& alarm)
{
    const Message who = alarm.crew ? Message{MARKED("core", "crew %1"), alarm.name} : Message{MARKED("core", "base %1"), alarm.name};
    const Message where = alarm.high ? MARKED("core", "east of") : MARKED("core", "west of");
    const std::string level = signedFigureText(alarm.level_deg, 2);
    if (alarm.day == alarm.last_day)
        return {MARKED("core", "%1: on %2 A lay %3 what is usual; its average stood at %4°"), who, dateOfDay(alarm.day), where, level};
    return {MARKED("core", "%1: from %2 to %3 A lay %4 what is usual; its average went as far as %5°"), who, dateOfDay(alarm.day),
        dateOfDay(alarm.last_day), where, level};
}

std::vector<Message> inWords(const DateComparison& comparison)
{
    const auto percent = [](double share) { return figureText(100 * std::abs(share), 0); };
    std::vector<Message> words;
    const Message amount = comparison.change < 0 ? Message{MARKED("core", "fell by %1 %"), percent(comparison.change)}
                                                 : Message{MARKED("core", "rose by %1 %"), percent(comparison.change)};
    words.push_back(
        {MARKED("core", "mean |A| %1, from %2° in %3 swings to %4° in %5"), amount, figureText(comparison.before.meanAbsA_deg, 2),
            comparison.before.swings, figureText(comparison.after.meanAbsA_deg, 2), comparison.after.swings});
    words.push_back(comparison.given ? Message{MARKED("core", "compared at %1, as was asked"), dateOfDay(comparison.day)}
                                     : Message{MARKED("core", "the change lies between the swings of %1 and %2"),
                                         dateOfDay(comparison.lastBefore_day), dateOfDay(comparison.day)});
    if (comparison.changeWithin)
        words.push_back({MARKED("core", "of the %1 compasses that were swung on both sides alone, the mean |A| changed by %2 %"),
            comparison.compassesOnBothSides, signedFigureText(100 * *comparison.changeWithin, 0)});
    else
        words.push_back(MARKED("core", "no compass was swung on both sides: the change cannot be told from one of the aircraft"));
    words.push_back(
        MARKED("core", "what else changed at that date (crews, datum instrument, base) cannot be told from training by these figures"));
    return words;
}

} // namespace lubberline
