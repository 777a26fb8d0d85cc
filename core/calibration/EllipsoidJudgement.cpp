#include <Eigen/LU>
#include <algorithm>

#include "core/base/Number.h"
#include "core/calibration/EllipsoidParts.h"

namespace lubberline {

namespace {

constexpr double kOtherUnit = 8;   ///< no two sizes of one log lie so far apart with nothing between them
constexpr double kUnturned = 0.02; ///< spread of the cloud as a part of its distance from zero: below, the sensor stood still
constexpr double kFlat = 0.02;     ///< thickness of the cloud as a part of its length: below, it is a plane or a line

std::string figure(double value) { return figureText(value, std::abs(value) < 10 ? 2 : 0); }

/// Sizes of two kinds, far from each other: a log whose unit changes on its way. Spikes alone are few.
Message twoUnits(const SensorLog& log, const std::vector<std::size_t>& rows)
{
    std::vector<double> sizes;
    for (const auto row : rows)
        sizes.push_back(log.at(row).norm());
    std::sort(sizes.begin(), sizes.end());
    const std::size_t few = std::max<std::size_t>(10, sizes.size() / 20);
    for (std::size_t i = few; i + few < sizes.size(); ++i)
        if (sizes[i] > kOtherUnit * sizes[i - 1] && sizes[i - 1] > 0)
            return {MARKED("core", "%1 samples are of sizes up to %2 %5, and %3 of %4 %5 or more: two units in one log"), i,
                figureText(sizes[i - 1], 1), sizes.size() - i, figureText(sizes[i], 0), log.figureUnit()};
    return {};
}

Message turnMore(const Coverage& coverage)
{
    return {MARKED("core", "no samples within %1° of one direction: %2"), figureText(coverage.largestGap_deg, 0), coverage.turnTo};
}

} // namespace

Message flatness(const SensorLog& log, const std::vector<std::size_t>& rows, EllipsoidShape shape)
{
    const std::size_t least = 2 * (freeOf(shape) + 1);
    if (rows.size() < least)
        return {MARKED("core", "%1 usable samples; expected %2 or more, in many attitudes"), rows.size(), least};
    const Spread spread = spreadOf(log, rows);
    const std::string unit(log.figureUnit());
    if (spread.axes[2] <= 1e-9 * std::max(1.0, spread.centre.norm()))
        return {MARKED("core", "all samples are equal: the sensor was not turned, or it is stuck")};
    if (Message mixed = twoUnits(log, rows); !mixed.empty())
        return mixed;
    if (spread.axes[2] < kUnturned * spread.centre.norm())
        return {MARKED("core", "the samples spread by %1 %3 about one field of %2 %3: the sensor was hardly turned"),
            figure(spread.axes[2]), figure(spread.centre.norm()), unit};
    if (spread.axes[1] < kFlat * spread.axes[2])
        return {MARKED("core", "the samples lie on a line: across it they spread by %1 %3 against %2 %3 along it; expected %4 %3 or more"),
            figure(spread.axes[1]), figure(spread.axes[2]), unit, figure(kFlat * spread.axes[2])};
    if (spread.axes[0] < kFlat * spread.axes[2])
        return {MARKED("core", "the samples lie in a plane: off it they spread by %1 %3 against %2 %3 in it; expected %4 %3 or more"),
            figure(spread.axes[0]), figure(spread.axes[2]), unit, figure(kFlat * spread.axes[2])};
    return {};
}

void judge(EllipsoidResult& result, const SensorLog& log, std::optional<double> field_nT)
{
    const EllipsoidFit& fit = *result.fit;
    result.verdict = fit.gate <= kGateGood ? CalibrationVerdict::Good
        : fit.gate <= kGateDetermined      ? CalibrationVerdict::Doubtful
                                           : CalibrationVerdict::NotDetermined;
    if (result.verdict != CalibrationVerdict::Good) {
        result.reasons.push_back(
            {MARKED("core", "the gate (condition × noise/field) is %1; expected %2 or less, and nothing is determined above %3"),
                figureText(fit.gate, 2), figureText(kGateGood, 1), figureText(kGateDetermined, 1)});
        result.nextSteps.push_back(turnMore(fit.coverage));
    } else if (fit.coverage.largestGap_deg > 60) {
        result.nextSteps.push_back(turnMore(fit.coverage));
    }
    const auto doubt = [&](Message why) {
        result.reasons.push_back(std::move(why));
        if (result.verdict == CalibrationVerdict::Good)
            result.verdict = CalibrationVerdict::Doubtful;
    };
    if (fit.rms > kResidualLimit * fit.field) {
        doubt(
            {MARKED("core",
                 "the field's size is off by %1 % (rms) after calibration; expected %2 % or less: it was not the same everywhere, or the sensor's scale is not of this shape"),
                figureText(100 * fit.rms / fit.field, 1), figureText(100 * kResidualLimit, 0)});
        result.nextSteps.push_back({MARKED("core", "log again away from iron, cars and cables")});
    }
    const std::size_t trimmed = result.samples - result.used;
    if (trimmed * 5 > result.samples)
        doubt(
            {MARKED("core", "%1 of %2 samples were left out as spikes or faults; expected one in five or fewer"), trimmed, result.samples});
    if (field_nT && log.unit != FieldUnit::Counts) {
        const double mean = fit.field * std::cbrt((Eigen::Matrix3d::Identity() + fit.softIron).determinant());
        const double off = mean / *field_nT - 1.0;
        if (std::abs(off) > kFieldContradiction)
            doubt(
                {MARKED("core",
                     "the log's field is %1 nT, %2 % off the %3 nT that were given; expected within %4 %: another unit, another place, or a sensor of another scale"),
                    figureText(mean, 0), signedFigureText(100 * off, 0), figureText(*field_nT, 0),
                    figureText(100 * kFieldContradiction, 0)});
        else if (std::abs(off) > 0.1)
            result.warnings.push_back({MARKED("core", "the log's field is %1 nT, %2 % off the %3 nT that were given"), figureText(mean, 0),
                signedFigureText(100 * off, 0), figureText(*field_nT, 0)});
    }
}

} // namespace lubberline
