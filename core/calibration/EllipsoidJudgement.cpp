#include <Eigen/LU>
#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>

#include "core/base/Middle.h"
#include "core/base/Number.h"
#include "core/calibration/EllipsoidParts.h"

namespace lubberline {

namespace {

constexpr double kOtherUnit = 8;      ///< no two sizes of one log lie so far apart with nothing between them
constexpr double kOtherAxisUnit = 80; ///< one axis beside the two others: units lie 100, 1000 or more apart
constexpr double kOtherScale = 2;     ///< of one axis beside another: soft iron and makers' tolerances stay far below
constexpr double kUnturned = 0.02;    ///< spread of the cloud as a part of its distance from zero: below, the sensor stood still
constexpr double kFlat = 0.02;        ///< thickness of the cloud as a part of its length: below, it is a plane or a line
constexpr double kLeastEarth_nT = 22'000, kMostEarth_nT = 67'000; ///< at the ground
constexpr double kOffTheEarth = 0.3;                              ///< by the scale of a sensor
constexpr double kChanceOfShape = 1e-3;                           ///< that noise alone says soft iron was left out
constexpr double kLeftOutMatters = 0.004;                         ///< of the field: 0.3° where H is 0.4 F
constexpr double kLeftOutSpoils = 0.05;                           ///< of the field: some 7° there, and nothing is calibrated
constexpr double kUnseenTold = 0.01;                              ///< of the field: what a log may hide is told from here on
constexpr double kMereNoise = 3; ///< thickness in standard deviations of the noise: below, it is that of the noise

std::string figure(double value) { return figureText(value, std::abs(value) < 10 ? 2 : 0); }

/// Sizes of two kinds, far from each other: a log whose unit changes on its way. Spikes alone are few.
Message twoUnits(const SensorLog& log, const FieldSamples& samples)
{
    std::vector<double> sizes;
    sizes.reserve(samples.size());
    for (const auto& sample : samples)
        sizes.push_back(sample.norm());
    const std::size_t few = std::max<std::size_t>(10, sizes.size() / 20);
    if (2 * few >= sizes.size())
        return {};
    const auto low = sizes.begin() + static_cast<std::ptrdiff_t>(few - 1), high = sizes.end() - static_cast<std::ptrdiff_t>(few + 1);
    std::nth_element(sizes.begin(), low, sizes.end());
    std::nth_element(low + 1, high, sizes.end());
    if (!(*high > kOtherUnit * *low)) // nor then do any two between them lie so far apart
        return {};
    std::sort(sizes.begin(), sizes.end());
    for (std::size_t i = few; i + few < sizes.size(); ++i)
        if (sizes[i] > kOtherUnit * sizes[i - 1] && sizes[i - 1] > 0)
            return {MARKED("core", "%1 samples are of sizes up to %2 %5, and %3 of %4 %5 or more: two units in one log"), i,
                figureText(sizes[i - 1], 1), sizes.size() - i, figureText(sizes[i], 0), log.figureUnit()};
    return {};
}

/// One axis of another unit than the two others, which agree: such a cloud looks like a plane or a line.
Message otherUnitOfAnAxis(const SensorLog& log, const std::vector<std::size_t>& rows)
{
    std::array<std::pair<double, char>, 3> size{{{0, 'x'}, {0, 'y'}, {0, 'z'}}};
    for (const auto row : rows)
        for (std::size_t axis = 0; axis < 3; ++axis)
            size[axis].first += log.field[axis][row] * log.field[axis][row];
    for (auto& [square, name] : size)
        square = std::sqrt(square / static_cast<double>(rows.size()));
    std::sort(size.begin(), size.end());
    const auto [least, middle, most] = size;
    const bool small = least.first > 0 && middle.first > kOtherAxisUnit * least.first;
    if (!small && !(middle.first > 0 && most.first > kOtherAxisUnit * middle.first))
        return {};
    const auto& odd = small ? least : most;
    return {MARKED("core", "axis %1 has figures of size %2 where the others have %3: another unit, or a column that is no field"),
        odd.second, figure(odd.first), figure(middle.first)};
}

/// The noise along the thinnest direction of the cloud, by how far samples lie off the middle of their neighbours. 0 where the log's
/// samples do not follow each other: there neighbours tell nothing.
double noiseOffThePlane(const SensorLog& log, const std::vector<std::size_t>& rows, const Spread& spread)
{
    constexpr double kSmooth = 0.2;
    std::vector<double> along, whole;
    for (const auto row : rows) {
        if (row == 0 || row + 1 >= log.size() || !log.hasField(row - 1) || !log.hasField(row + 1))
            continue;
        const Eigen::Vector3d bend = log.at(row - 1) - 2.0 * log.at(row) + log.at(row + 1);
        along.push_back(std::abs(spread.thinnest.dot(bend)));
        whole.push_back(bend.norm());
    }
    const double toSigma = 1.4826 / std::sqrt(6.0);
    return along.empty() || middleOf(std::move(whole)) * toSigma > kSmooth * spread.axes[2] ? 0.0 : toSigma * middleOf(std::move(along));
}

Message turnMore(const Coverage& coverage)
{
    return {MARKED("core", "no samples within %1° of one direction: %2"), figureText(coverage.largestGap_deg, 0), coverage.turnTo};
}

/// Of a … R in the ten.
Eigen::Matrix<double, kUncertainParameters, 1> inTheOrderOfTheModel(const LeftOutIron& iron)
{
    Eigen::Matrix<double, kUncertainParameters, 1> all;
    for (Eigen::Index row = 0; row < 3; ++row)
        for (Eigen::Index column = 0; column < 3; ++column)
            all[3 * row + column] = iron.softIron(row, column);
    all.tail<3>() = iron.hardIron;
    return all;
}

/// Errors of the shape's parameters as those of the ten and what they differ by: the interval then holds the truth whichever is nearer.
void widenBy(EllipsoidFit& fit, const EllipsoidFit& whole)
{
    const auto off = inTheOrderOfTheModel(*fit.leftOut);
    fit.uncertainty.covariance = whole.uncertainty.covariance + off * off.transpose();
    for (auto& parameter : fit.parameters)
        for (const auto& other : whole.parameters)
            if (other.name == parameter.name)
                parameter.standard_error = std::hypot(*other.standard_error, *other.value - *parameter.value);
    fit.changed = whole.changed; // what goes round with the attitude is no change with time
}

/// What soft iron that this log cannot show would do to the hard iron at most (95 %).
double unseenHardIron(const EllipsoidFit& whole) { return 1.96 * std::sqrt(whole.uncertainty.covariance.diagonal().tail<3>().maxCoeff()); }

} // namespace

double LeftOutIron::partOf(double field) const { return std::max(hardIron.cwiseAbs().maxCoeff() / field, softIron.cwiseAbs().maxCoeff()); }

void holdAgainstGeneral(EllipsoidResult& result, const SensorLog& log, std::optional<double> field_nT)
{
    EllipsoidFit& fit = *result.fit;
    const auto rows = someRows(result.usedRows);
    const std::size_t free = freeOf(fit.shape), all = freeOf(EllipsoidShape::General);
    if (rows.size() <= 2 * all)
        return;
    const Spread spread = spreadOf(samplesOf(log, rows));
    const auto quadric = adjustedQuadric(
        momentsOf({log.field[0], log.field[1], log.field[2]}, result.usedRows, spread.centre, spread.scale), EllipsoidShape::General);
    if (!quadric)
        return;
    const EllipsoidFit whole = fitOf(log, *quadric, result.usedRows, EllipsoidShape::General, field_nT);
    const auto count = static_cast<double>(rows.size()), rest = count - static_cast<double>(all), asked = static_cast<double>(all - free);
    const double left = fit.sigma * fit.sigma * (count - static_cast<double>(free)), least = whole.sigma * whole.sigma * rest;
    LeftOutIron iron;
    iron.sigma = whole.sigma;
    iron.ratio = least > 0 ? (left - least) / asked / (least / rest * whole.slow) : 0;
    iron.limit = quantile(complement(boost::math::fisher_f(asked, rest), kChanceOfShape));
    if (iron.ratio > iron.limit) {
        iron.hardIron = whole.hardIron - fit.hardIron;
        iron.softIron = whole.softIron - fit.softIron;
        fit.leftOut = iron;
        widenBy(fit, whole);
    } else if (const double unseen = unseenHardIron(whole); unseen > kUnseenTold * fit.field) {
        result.warnings.push_back(
            {MARKED("core",
                 "that the sensor has no soft iron beyond this shape is taken for granted: what this log does not show of it may move the hard iron by up to %1 %2"),
                figure(unseen), std::string(log.figureUnit())});
    }
}

Message flatness(const SensorLog& log, const std::vector<std::size_t>& rows, EllipsoidShape shape)
{
    const std::size_t least = 2 * (freeOf(shape) + 1);
    if (rows.size() < least)
        return {MARKED_N("core", "%n usable sample(s); expected %1 or more, in many attitudes"), rows.size(), least};
    const FieldSamples samples = samplesOf(log, rows);
    const Spread spread = spreadOf(samples);
    const std::string unit(log.figureUnit());
    if (spread.axes[2] <= 1e-9 * std::max(1.0, spread.centre.norm()))
        return {MARKED("core", "all samples are equal: the sensor was not turned, or it is stuck")};
    if (Message mixed = twoUnits(log, samples); !mixed.empty())
        return mixed;
    if (spread.axes[2] < kUnturned * spread.centre.norm())
        return {MARKED("core", "the samples spread by %1 %3 about one field of %2 %3: the sensor was hardly turned"),
            figure(spread.axes[2]), figure(spread.centre.norm()), unit};
    if (Message other = spread.axes[0] < kFlat * spread.axes[2] ? otherUnitOfAnAxis(log, rows) : Message(); !other.empty())
        return other;
    if (spread.axes[1] < kFlat * spread.axes[2])
        return {MARKED("core", "the samples lie on a line: across it they spread by %1 %3 against %2 %3 along it; expected %4 %3 or more"),
            figure(spread.axes[1]), figure(spread.axes[2]), unit, figure(kFlat * spread.axes[2])};
    const double thick = std::max(kFlat * spread.axes[2], kMereNoise * noiseOffThePlane(log, rows, spread));
    if (spread.axes[0] < thick)
        return {MARKED("core", "the samples lie in a plane: off it they spread by %1 %3 against %2 %3 in it; expected %4 %3 or more"),
            figure(spread.axes[0]), figure(spread.axes[2]), unit, figure(thick)};
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
    if (fit.leftOut && fit.leftOut->partOf(fit.field) > kLeftOutMatters) {
        const LeftOutIron& iron = *fit.leftOut;
        doubt(
            {MARKED("core",
                 "soft iron is in the log that these %1 parameters leave out: they leave %2 %4 of noise where all 10 leave %3 %4 (F %5; expected %6 or less), and they move the hard iron by %7 %4"),
                fit.shape == EllipsoidShape::Sphere ? 4 : 7, figure(fit.sigma), figure(iron.sigma), std::string(log.figureUnit()),
                figureText(iron.ratio, 1), figureText(iron.limit, 1), figure(iron.hardIron.norm())});
        if (iron.hardIron.cwiseAbs().maxCoeff() > kLeftOutSpoils * fit.field)
            result.verdict = CalibrationVerdict::NotDetermined;
        result.nextSteps.push_back({MARKED("core", "fit all 10 parameters (ellipsoid)")});
    } else if (fit.structured.rms > kLeftOutMatters * fit.field) {
        doubt(
            {MARKED("core",
                 "what the fit leaves over goes with the direction of the field: %1 %4 (rms) of it, %2 times as much as the scatter in one direction explains; expected %3 %4 or less: a sensor that is not linear, or a field that was not the same everywhere"),
                figure(fit.structured.rms), figureText(fit.structured.ratio, 0), figure(kLeftOutMatters * fit.field),
                std::string(log.figureUnit())});
        result.nextSteps.push_back({MARKED("core", "log again away from iron, cars and cables")});
    } else if (fit.rms > kResidualLimit * fit.field) {
        doubt(
            {MARKED("core",
                 "the field's size is off by %1 % (rms) after calibration; expected %2 % or less: it was not the same everywhere, or the sensor's scale is not of this shape"),
                figureText(100 * fit.rms / fit.field, 1), figureText(100 * kResidualLimit, 0)});
        result.nextSteps.push_back({MARKED("core", "log again away from iron, cars and cables")});
    }
    if (!fit.changed.empty()) {
        doubt(fit.changed);
        result.nextSteps.push_back(
            {MARKED("core", "log again with nothing moved on the way, or take the part of the log that is as the aircraft flies")});
    }
    const Eigen::Vector3d gain = (Eigen::Matrix3d::Identity() + fit.softIron).diagonal();
    Eigen::Index most = 0, least = 0;
    if (const double ratio = gain.maxCoeff(&most) / std::max(gain.minCoeff(&least), 1e-9); ratio > kOtherScale)
        doubt({MARKED("core", "axis %1 measures %2 times as much as axis %3 of one field: another unit or scale; expected less than %4"),
            "xyz"[most], figure(ratio), "xyz"[least], figureText(kOtherScale, 0)});
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
                     "the log's field is %1 nT, %2 % off the %3 nT that were given; expected within %4 %: another unit, another place, or a sensor of another scale, which soft iron then carries"),
                    figureText(mean, 0), signedFigureText(100 * off, 0), figureText(*field_nT, 0),
                    figureText(100 * kFieldContradiction, 0)});
    } else if (log.unit != FieldUnit::Counts
        && (fit.field < kLeastEarth_nT * (1 - kOffTheEarth) || fit.field > kMostEarth_nT * (1 + kOffTheEarth))) {
        doubt({MARKED("core", "the log's field is %1 nT, and that of the Earth is %2 to %3 nT: another unit, or a sensor of another scale"),
            figureText(fit.field, fit.field < 1000 ? 1 : 0), figureText(kLeastEarth_nT, 0), figureText(kMostEarth_nT, 0)});
    }
}

} // namespace lubberline
