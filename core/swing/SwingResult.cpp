#include "core/swing/SwingResult.h"

#include <algorithm>
#include <cmath>

#include "core/base/Number.h"
#include "core/swing/Gaps.h"
#include "core/swing/Observations.h"
#include "core/swing/ReadingError.h"
#include "core/swing/SwingField.h"

namespace lubberline {

namespace {

/// The coarsest of the instruments that were used.
double datumDivision_deg(const SwingJob& job)
{
    double division_deg = job.datum.resolution_deg;
    for (const JobEvent& event : job.events)
        if (const auto* changed = std::get_if<job::DatumChanged>(&event.what))
            division_deg = std::max(division_deg, changed->datum.resolution_deg);
    return division_deg;
}

bool readTo(const Swing& swing, double division_deg)
{
    return std::all_of(swing.readings.begin(), swing.readings.end(), [division_deg](const Reading& reading) {
        const double divisions = reading.compass ? reading.compass->degrees() / division_deg : 0.0;
        return std::abs(divisions - std::round(divisions)) < 1e-6;
    });
}

/// A compass whose marks are read without looking between them: the coarsest of 5° and 2° of which every heading is a multiple. By chance eight
/// headings to 1° are all even in one swing of 256. None of fewer, and none where the aircraft was turned until the compass stood on the headings
/// that were asked: then they are multiples of 15°, but for slips, however finely it is read.
std::optional<double> coarseSteps_deg(const Swing& swing)
{
    constexpr std::size_t kEnoughForSteps = 8;
    constexpr double kAsked_deg = 15.0;
    const auto readings = observationsOf(swing);
    const auto onAsked = std::count_if(readings.begin(), readings.end(),
        [](const Observation& one) { return std::abs(std::remainder(one.compass.degrees(), kAsked_deg)) < 1e-6; });
    if (readings.size() < kEnoughForSteps || 2 * static_cast<std::size_t>(onAsked) > readings.size())
        return std::nullopt;
    for (const double steps_deg : {5.0, 2.0})
        if (readTo(swing, steps_deg))
            return steps_deg;
    return std::nullopt;
}

} // namespace

std::optional<ApproximateSmith> smithOfKept(std::span<const std::optional<double>, kCoefficientCount> coefficient_deg)
{
    const auto& c = coefficient_deg;
    if (!std::all_of(c.begin(), c.end(), [](const auto& one) { return one.has_value(); }))
        return std::nullopt;
    const double index_deg = std::abs(*c[0]) > kLargeIndex_deg ? std::round(*c[0]) : 0.0;
    return ApproximateSmith{toRadians(*c[0]), toRadians(*c[1]), toRadians(*c[2]), toRadians(*c[3]), toRadians(*c[4]), toRadians(index_deg)};
}

ExpectedCurve expectedAfter(const ApproximateSmith& last, SwingKind kindOfLast, SwingStage stageOfLast, const Swing& swing)
{
    ExpectedCurve expected = curveAfter(last);
    const bool compensated
        = kindOfLast == SwingKind::Correction || (stageOfLast == SwingStage::AsFound && swing.stage == SwingStage::AsLeft);
    if (!compensated)
        return expected;
    const ExpectedCurve any = anyCurve();
    expected.mean.A_rad = expected.mean.B_rad = expected.mean.C_rad = expected.mean.index_rad = 0.0;
    expected.standardDeviation.A_rad = any.standardDeviation.A_rad;
    expected.standardDeviation.B_rad = any.standardDeviation.B_rad;
    expected.standardDeviation.C_rad = any.standardDeviation.C_rad;
    return expected;
}

SwingQuestion questionOf(
    const SwingRecord& record, const SwingJob* job, const AnalysisOptions& options, const std::optional<SensorBench>& bench)
{
    SwingQuestion question{observationsOf(record.swing), options};
    double& division_deg = question.options.resolution_deg;
    division_deg = record.compass.resolution_deg;
    if (const auto steps_deg = coarseSteps_deg(record.swing); steps_deg && *steps_deg > division_deg) {
        division_deg = *steps_deg;
        question.words.push_back(
            {MARKED("core", "every compass heading is a multiple of %1°: taken as read to no better, whatever the compass can"),
                shortestNumber(*steps_deg)});
    }
    question.options.readingError_rad = readingError_rad(division_deg, job ? datumDivision_deg(*job) : 0.0);
    question.options.shared = record.swing.sharedErrors;
    double& ofA_deg = question.options.shared.of_deg[indexOf(Coefficient::A)];
    ofA_deg = std::hypot(ofA_deg, variationDoubt_deg(record.swing, record.site));
    if (bench) {
        const auto stamp = record.swing.field ? record.swing.field : stampFor(record.swing, record.site);
        const auto error_rad = stamp ? errorIn(*bench, stamp->field.horizontal_nT()) : std::nullopt;
        if (error_rad)
            question.options.readingError_rad = std::hypot(question.options.readingError_rad, *error_rad);
        question.words.push_back(wordsOf(*bench, error_rad, stamp ? stamp->field.horizontal_nT() : 0.0));
    }
    return question;
}

Result<Analysis> answerTo(const SwingQuestion& question, const Progress& progress)
{
    auto analysis = analyse(question.readings, question.options, progress);
    if (!analysis)
        return analysis;
    for (const auto& gap : gapsOf(*analysis)) // with the band that the reading error leaves
        analysis->warnings.push_back(wordsOf(gap));
    analysis->warnings.insert(analysis->warnings.end(), question.words.begin(), question.words.end());
    return analysis;
}

Result<Analysis> resultOf(
    const SwingRecord& record, const SwingJob* job, const AnalysisOptions& options, const std::optional<SensorBench>& bench)
{
    return answerTo(questionOf(record, job, options, bench));
}

double divisionOf_deg(const Swing& swing)
{
    for (const double division_deg : {1.0, 0.5})
        if (readTo(swing, division_deg))
            return division_deg;
    return 0.1;
}

} // namespace lubberline
