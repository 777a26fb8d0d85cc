#include "core/swing/Analysis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/angle/AngleText.h"
#include "core/angle/Circle.h"
#include "core/base/Number.h"
#include "core/swing/CompassAtFault.h"
#include "core/swing/LackOfFit.h"
#include "core/swing/RepeatedReadings.h"

namespace lubberline {

namespace {

/// A slip that could pass unseen up to this size is nothing to warn of.
constexpr double kUnseen_deg = 8.0;
/// From here on the coefficients lean visibly on where the readings stand.
constexpr double kLeaningCondition = 10.0;

std::vector<double> compassHeadings_deg(std::span<const Observation> readings)
{
    std::vector<double> headings_deg;
    for (const auto& reading : readings)
        headings_deg.push_back(reading.compass.degrees());
    return headings_deg;
}

Message gapText(std::span<const Observation> readings)
{
    const EmptyArc gap = widestEmptyArc(compassHeadings_deg(readings));
    return {MARKED("core", "no reading between %1 and %2 (compass)"), formatHeading(gap.from_deg, AngleStyle::DecimalDegrees, 0),
        formatHeading(gap.to_deg, AngleStyle::DecimalDegrees, 0)};
}

/// How many headings the readings are on: those within a few degrees of each other are one. None: an arc without steps.
std::optional<std::size_t> headingsReadOn(std::span<const Observation> readings)
{
    constexpr double kApart_deg = 5.0, kWidest_deg = 12.0;
    std::vector<double> headings_deg = compassHeadings_deg(readings);
    const double start_deg = widestEmptyArc(headings_deg).to_deg;
    for (double& heading_deg : headings_deg)
        heading_deg = wrap360(heading_deg - start_deg);
    std::sort(headings_deg.begin(), headings_deg.end());
    std::size_t count = 1;
    for (std::size_t i = 1, first = 0; i < headings_deg.size(); ++i) {
        if (headings_deg[i] - headings_deg[i - 1] >= kApart_deg) {
            ++count;
            first = i;
        } else if (headings_deg[i] - headings_deg[first] > kWidest_deg) {
            return std::nullopt;
        }
    }
    return count;
}

/// Why D and E, or more, cannot be told: too few headings, or headings on one side.
Message whyUntold(std::span<const Observation> readings)
{
    if (const auto count = headingsReadOn(readings); count && *count < 5)
        return {MARKED_N("core", "there are readings on %n heading(s), and five coefficients need five"), *count};
    return {MARKED("core", "the headings stand on one side: %1"), gapText(readings)};
}

void warnOfFit(std::vector<Message>& warnings, const SmithFitReport& fit, Pattern name, std::span<const Observation> readings)
{
    if (!fit.fitted())
        warnings.push_back({MARKED("core", "%1 A, B, C, D and E cannot be told: %2"), name, whyUntold(readings)});
    else if (fit.parameters == 3)
        warnings.push_back({MARKED("core", "%1 D and E cannot be told: %2; whatever there is of them is hidden in A, B and C"), name,
            whyUntold(readings)});
    else if (fit.parameters == 4 && !fit.of(Coefficient::D))
        warnings.push_back({MARKED("core", "%1 D cannot be told: on the cardinal headings it does nothing"), name});
    else if (fit.parameters == 4)
        warnings.push_back({MARKED("core", "%1 E cannot be told: on the intercardinal headings it does nothing"), name});
    if (fit.fitted() && fit.conditionNumber > kLeaningCondition)
        warnings.push_back({MARKED("core", "%1 coefficients lean on few headings: %2"), name, gapText(readings)});
    if (fit.fitted() && fit.degreesOfFreedom == 0)
        warnings.push_back(
            {MARKED("core",
                 "%1 coefficients go through every reading: their standard errors are those of the reading alone, and no scatter can be seen"),
                name});
    if (fit.lagOneCorrelation)
        warnings.push_back(
            {MARKED("core",
                 "%1 residuals of neighbouring readings are alike (correlation %2): the standard errors count that many readings tell little "
                 "more than a few; something drifted slowly, or five coefficients do not describe the curve"),
                name, figureText(*fit.lagOneCorrelation, 2)});
}

void warnOfSlips(std::vector<Message>& warnings, const SlipSearch& slips, std::size_t readings)
{
    if (slips.seenFrom_deg && *slips.seenFrom_deg <= kUnseen_deg)
        return;
    if (!slips.seenFrom_deg || *slips.seenFrom_deg > 90.0)
        warnings.push_back(
            {MARKED_N("core", "%n reading(s) cannot be checked against each other: a misread figure would not be seen"), readings});
    else if (readings <= kCoefficients.size())
        warnings.push_back(
            {MARKED_N("core",
                 "%n reading(s) cannot tell a slip from a large coefficient: a figure misread by less than about %1° could pass unseen"),
                readings, static_cast<int>(std::ceil(*slips.seenFrom_deg))});
    else
        warnings.push_back(
            {MARKED_N("core", "%n reading(s) hold little against each other: a figure misread by less than about %1° could pass unseen"),
                readings, static_cast<int>(std::ceil(*slips.seenFrom_deg))});
}

/// The widest arc without a reading, to half a degree: a log is not sorted for it.
double unreadArc_deg(const std::vector<AnalysedReading>& readings)
{
    constexpr double kBin_deg = 0.5;
    std::array<bool, 720> read{};
    for (const AnalysedReading& reading : readings)
        read[static_cast<std::size_t>(reading.magnetic.degrees() / kBin_deg) % read.size()] = true;
    std::size_t widest = 0, empty = 0;
    for (std::size_t bin = 0; bin < 2 * read.size(); ++bin) {
        empty = read[bin % read.size()] ? 0 : empty + 1;
        widest = std::max(widest, std::min(empty, read.size()));
    }
    return kBin_deg * static_cast<double>(widest);
}

/// @param index_rad  of a compass that is far out as a whole: the least and the most lie about it, also beyond ±180°
Summary summarise(const std::vector<AnalysedReading>& readings, double index_rad)
{
    Summary summary;
    double sumOfSquares = 0;
    double& largest = summary.largestDeviation_rad;
    for (std::size_t i = 0; i < readings.size(); ++i) {
        const double deviation = readings[i].deviation.radians();
        sumOfSquares += deviation * deviation;
        // Of two equal ones the easterly is named, then the smaller heading, whatever the order of the readings.
        const bool larger = std::abs(deviation) > summary.maxAbsDeviation_rad || (deviation == -largest && deviation > 0);
        const bool same = deviation == largest && readings[i].magnetic.degrees() < summary.maxAbsDeviationAt.degrees();
        if (i == 0 || larger || same) {
            largest = deviation;
            summary.maxAbsDeviation_rad = std::abs(deviation);
            summary.maxAbsDeviationAt = readings[i].magnetic;
        }
        const double there = nearTo_rad(deviation, index_rad);
        summary.minDeviation_rad = i == 0 ? there : std::min(summary.minDeviation_rad, there);
        summary.maxDeviation_rad = i == 0 ? there : std::max(summary.maxDeviation_rad, there);
    }
    summary.unread_deg = unreadArc_deg(readings);
    summary.rmsDeviation_rad = std::sqrt(sumOfSquares / static_cast<double>(readings.size()));
    return summary;
}

std::vector<AnalysedReading> analysedReadings(std::span<const Observation> readings)
{
    std::vector<AnalysedReading> analysed;
    analysed.reserve(readings.size());
    for (const auto& reading : readings)
        analysed.push_back({reading.magnetic, reading.compass, deviationOf(reading.magnetic, reading.compass), {}, {}, {}, false});
    return analysed;
}

void addResiduals(Analysis& analysis)
{
    const auto studentised = studentisedResiduals(analysis.approximate);
    for (std::size_t i = 0; i < analysis.readings.size(); ++i) {
        auto& reading = analysis.readings[i];
        if (analysis.exact.fitted())
            reading.residualExact_rad = analysis.exact.residual_rad[i];
        if (!analysis.approximate.fitted())
            continue;
        reading.residualApproximate_rad = analysis.approximate.residual_rad[i];
        reading.studentised = studentised[i];
    }
}

bool looksLikeRadians(std::span<const Observation> readings)
{
    constexpr std::size_t kFewest = 4;
    const auto within = [](double figure) { return figure <= 2.0 * kPi; };
    return readings.size() >= kFewest && std::all_of(readings.begin(), readings.end(), [&](const auto& reading) {
        return within(reading.magnetic.degrees()) && within(reading.compass.degrees());
    });
}

/// A compass that deviates by more than any that is expected, whose readings go with its own exact curve all the same: a search that
/// holds such deviations for slips would blame what is right.
bool largeButPlain(const Analysis& analysis)
{
    constexpr double kLarge_deg = 45.0, kPlain_deg = 1.0;
    const auto& exact = analysis.exact;
    const double half_deg = toDegrees(analysis.summary.spread_rad()) / 2.0;
    return half_deg > kLarge_deg && exact.fitted() && exact.degreesOfFreedom >= 3 && toDegrees(*exact.sigma_rad) < kPlain_deg;
}

/// One of many readings may have slipped, rather not than so: a bump of the curve looks like that, and readings that are poor throughout.
bool isVague(const SlipSearch& search, std::size_t readings, const LackOfFit& unfit)
{
    const std::size_t named = search.slips.size();
    return named > 2 && search.slips.front().probability < 0.5 && (unfit.anotherShape() || 2 * named > readings);
}

std::vector<std::size_t> namedIn(const SlipSearch& search)
{
    std::vector<std::size_t> named;
    for (const auto& slip : search.slips)
        named.push_back(slip.reading);
    std::sort(named.begin(), named.end());
    return named;
}

/// The peak of a shape may stand out of what its neighbours tell of it: one in ten does, and no slip is surer than that.
void limitBesideShape(SlipSearch& search)
{
    constexpr double kSurest = 0.9;
    for (auto& slip : search.slips) {
        const double limit = std::min(1.0, kSurest / slip.probability);
        slip.probability *= limit;
        for (auto& candidate : slip.candidates)
            candidate.probability *= limit;
    }
}

/// Slips, and what is left beside them that five coefficients do not describe. Readings that go astray together are no slip of one of
/// them: they are held against the curve with the shape that the others have.
std::optional<LackOfFit> findSlipsAndShape(
    Analysis& analysis, std::span<const Observation> readings, const AnalysisOptions& options, const Progress& progress)
{
    constexpr int kRounds = 4;
    const auto unfitBesides = [&](const std::vector<std::size_t>& slipped) {
        return lackOfFit(readings, analysis.approximate, analysis.exact, options.readingError_rad, slipped);
    };
    auto unfit = unfitBesides({});
    if (!options.findSlips || !analysis.approximate.fitted() || largeButPlain(analysis) || foldOf(readings))
        return unfit;
    const auto ofAll = unfit;
    std::vector<std::size_t> named;
    for (int round = 0; round < kRounds; ++round) {
        const auto beyond = unfit ? std::span<const double>(unfit->beyond_rad) : std::span<const double>();
        analysis.slips = findSlips(readings, options.resolution_deg, options.history, beyond, progress);
        const auto before = std::exchange(named, namedIn(analysis.slips));
        const bool shaped = unfit && unfit->anotherShape();
        unfit = unfitBesides(named);
        if ((round > 0 && before == named) || (!shaped && !(unfit && unfit->anotherShape())))
            break;
    }
    if (ofAll && isVague(analysis.slips, readings.size(), *ofAll)) {
        analysis.slips.slips.clear();
        return ofAll;
    }
    if (unfit && unfit->anotherShape())
        limitBesideShape(analysis.slips);
    return unfit;
}

void takeShared(Analysis& analysis, const SharedErrors& shared)
{
    analysis.shared = shared;
    if (!shared.any())
        return;
    std::array<double, kCoefficientCount> errors_rad{};
    std::transform(shared.of_deg.begin(), shared.of_deg.end(), errors_rad.begin(), toRadians);
    addShared(analysis.approximate, errors_rad);
    addShared(analysis.exact, errors_rad);
    std::string named;
    for (const Coefficient coefficient : kCoefficients)
        if (const double error_deg = shared.of_deg[indexOf(coefficient)]; error_deg >= 0.005) // less is printed as none
            named += (named.empty() ? "" : ", ") + std::string(1, letterOf(coefficient)) + " " + figureText(error_deg, 2) + "°";
    analysis.warnings.push_back(
        {MARKED("core", "what all readings share (datum, variation, delay, wind) is in the standard errors: %1"), named});
}

} // namespace

bool isOf(const AnalysedReading& analysed, const Observation& reading)
{
    return analysed.magnetic == reading.magnetic && analysed.compass == reading.compass;
}

Result<Analysis> analyse(std::span<const Observation> readings, const AnalysisOptions& options, const Progress& progress)
{
    // Shares of the time that a log takes.
    constexpr double kApproximate = 0.45, kExact = 0.65, kSpectrum = 0.75;
    const auto goesOn = [&progress](double fraction) { return !progress || progress(fraction); };
    const auto within = [&goesOn](double from, double to) {
        return [&goesOn, from, to](double fraction) { return goesOn(from + (to - from) * fraction); };
    };
    const Error cancelled{ErrorCode::Cancelled, MARKED("core", "the analysis was cancelled")};
    if (auto fault = faultOf(readings))
        return *std::move(fault);
    auto approximate = fitApproximate(readings, {.progress = within(0.0, kApproximate)});
    if (!approximate)
        return approximate.error();
    if (!goesOn(kApproximate))
        return cancelled;
    // Its own search: what five sines leave of a large deviation is slow, and looks for another memory than what the exact curve leaves.
    auto exact = fitExact(readings, {.progress = within(kApproximate, kExact)});
    if (!exact)
        return exact.error();
    if (!goesOn(kExact))
        return cancelled;
    Analysis analysis;
    bool astray = false;
    if (auto fault = faultOf(*approximate, *exact)) {
        const auto found
            = options.findSlips ? astrayReadings(readings, options.resolution_deg, options.history) : std::vector<std::size_t>();
        if (found.empty())
            return *std::move(fault);
        astray = true;
        for (const auto reading : found)
            analysis.warnings.push_back(
                {MARKED("core",
                     "the reading on %1 magnetic goes with none of the others: the coefficients mean nothing and there is no card "
                     "until it is read again or excluded"),
                    formatHeading(readings[reading].magnetic.degrees(), AngleStyle::DecimalDegrees, 0)});
    }

    std::vector<HarmonicSample> samples;
    analysis.readings = analysedReadings(readings);
    for (const auto& reading : analysis.readings)
        samples.push_back({reading.magnetic.radians(), nearTo_rad(reading.deviation.radians(), approximate->index_rad)});
    auto spectrum = harmonics(samples, options.maxOrder);
    if (!spectrum)
        return spectrum.error();
    if (!goesOn(kSpectrum))
        return cancelled;
    analysis.approximate = std::move(approximate.value());
    analysis.exact = std::move(exact.value());
    analysis.harmonics = std::move(spectrum.value());
    analysis.pointRules = pointRules(readings);
    analysis.summary = summarise(analysis.readings, analysis.approximate.index_rad);
    addResiduals(analysis);
    if (looksLikeRadians(readings))
        analysis.warnings.push_back(MARKED("core", "all headings lie between 0 and 6.3, as if they were in radians; expected degrees"));
    if (const auto words = countOnce(readings, analysis.approximate, analysis.exact))
        analysis.warnings.push_back(*words);
    widenTo(analysis.approximate, options.readingError_rad);
    widenTo(analysis.exact, options.readingError_rad);
    takeShared(analysis, options.shared);
    const double index_deg = toDegrees(analysis.approximate.index_rad);
    for (const auto& words : {indexWords(index_deg), indexMeaning(index_deg)})
        if (words)
            analysis.warnings.push_back(*words);
    const auto unfit = findSlipsAndShape(analysis, readings, options, within(kSpectrum, 1.0));
    if (!goesOn(1.0))
        return cancelled;
    for (const auto& slip : analysis.slips.slips)
        analysis.readings[slip.reading].suspect = true;
    const auto fold = foldOf(readings);
    if (fold)
        analysis.warnings.push_back(foldWords(*fold));
    if (options.findSlips && analysis.approximate.fitted() && !largeButPlain(analysis) && !fold)
        warnOfSlips(analysis.warnings, analysis.slips, readings.size());
    // A reading that is wrong makes an A of its own: the mount is no matter before it was read again.
    if (analysis.slips.slips.empty() && !astray)
        if (const auto words = mountWords(readings, analysis.approximate))
            analysis.warnings.push_back(*words);
    if (unfit && (analysis.slips.slips.empty() || unfit->anotherShape()))
        analysis.warnings.push_back(unfit->words);
    warnOfFit(analysis.warnings, analysis.approximate, MARKED("core", "approximate"), readings);
    warnOfFit(analysis.warnings, analysis.exact, MARKED("core", "exact"), readings);
    return analysis;
}

Result<SwingOutline> outlineOf(std::span<const Observation> readings)
{
    if (auto fault = faultOf(readings))
        return *std::move(fault);
    const auto fit = fitApproximate(readings, {.uncertainty = false});
    if (!fit)
        return fit.error();
    return SwingOutline{fit->value, summarise(analysedReadings(readings), fit->index_rad)};
}

Judgement judge(const Summary& summary, const std::optional<LimitsProfile>& limits)
{
    // Readings are decimal figures: 10° read must not fail a limit of 10° by the rounding of a conversion.
    constexpr double kRounding_deg = 1e-9;
    Judgement judgement;
    judgement.maxAbsDeviation_deg = toDegrees(summary.maxAbsDeviation_rad);
    judgement.spread_deg = toDegrees(summary.spread_rad());
    if (!limits || (!limits->maxDeviation_deg && !limits->maxSpread_deg))
        return judgement;
    const bool within = (!limits->maxDeviation_deg || judgement.maxAbsDeviation_deg <= *limits->maxDeviation_deg + kRounding_deg)
        && (!limits->maxSpread_deg || judgement.spread_deg <= *limits->maxSpread_deg + kRounding_deg);
    judgement.partlyRead = within && summary.unread_deg > kMostUnread_deg + kRounding_deg;
    judgement.verdict = judgement.partlyRead ? Verdict::NotKnown : within ? Verdict::InLimits : Verdict::OutOfLimits;
    return judgement;
}

} // namespace lubberline
