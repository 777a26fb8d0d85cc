#include <algorithm>

#include "core/angle/Angle.h"
#include "core/base/Number.h"
#include "core/calibration/AttitudeParts.h"
#include "core/calibration/EllipsoidParts.h"

namespace lubberline {

namespace {

constexpr double kExact_nT = 1.0; ///< scatter below which a log is exact

double largestIn(const std::vector<double>& values)
{
    double largest = 0;
    for (const double value : values)
        if (std::isfinite(value))
            largest = std::max(largest, std::abs(value));
    return largest;
}

constexpr std::size_t kRowsForNorth = 5000;
constexpr double kMostVariation_deg = 40; ///< beyond it there is no compass to calibrate

/// Where the place is not known: the one angle between the headings and magnetic north that explains the samples best.
void checkUnknownNorth(AttitudeResult& result, const SensorLog& log, const std::vector<std::uint8_t>& used, const AttitudeOptions& options)
{
    std::vector<std::uint8_t> some(used.size(), 0);
    for (const auto row : someRows(used, kRowsForNorth))
        some[row] = 1;
    const auto varianceAt = [&](double turned_deg) {
        return regress(momentsOfRows(log, some, options.field, {1.0, 1.0, -turned_deg}), 0).variance;
    };
    const double stated = varianceAt(0);
    if (std::sqrt(stated) * options.field.total_nT() < kExact_nT)
        return;
    double best_deg = 0, step_deg = 4, least = stated;
    for (double at = -kMostVariation_deg; at <= kMostVariation_deg; at += step_deg)
        if (const double one = varianceAt(at); one < least) {
            least = one;
            best_deg = at;
        }
    while (step_deg > 0.1) {
        step_deg /= 2;
        for (const double at : {best_deg - step_deg, best_deg + step_deg})
            if (const double one = varianceAt(at); one < least) {
                least = one;
                best_deg = at;
            }
    }
    if (std::abs(best_deg) < 1 || least > 0.25 * stated)
        return;
    result.reasons.push_back(
        {MARKED("core",
             "the headings look turned by %1° against magnetic north: with that taken out they explain the samples far better; true headings where the variation is so? Expected magnetic headings"),
            signedFigureText(best_deg, 1)});
    result.verdict = std::max(result.verdict, CalibrationVerdict::Doubtful);
}

/// The other ways to take heading, pitch and roll, with the words for each.
struct Misnamed {
    AngleReading reading;
    std::vector<Message> what;
};

std::vector<Misnamed> otherReadings()
{
    std::vector<Misnamed> all;
    for (int way = 1; way < 64; ++way) {
        Misnamed one;
        if ((way & 3) > 0) {
            one.reading.headingOffset_deg = 90.0 * (way & 3);
            one.what.push_back((way & 3) == 2 ? Message(MARKED("core", "headings are reciprocal, 180° off"))
                                              : Message{MARKED("core", "headings are %1° off"), (way & 3) == 1 ? -90 : 90});
        }
        if ((way & 4) != 0) {
            one.reading.headingFactor = -1;
            one.what.push_back(MARKED("core", "headings run anticlockwise"));
        }
        if ((way & 8) != 0) {
            one.reading.pitchSign = -1;
            one.what.push_back(MARKED("core", "pitch has the other sign (nose up is positive)"));
        }
        if ((way & 16) != 0) {
            one.reading.rollSign = -1;
            one.what.push_back(MARKED("core", "roll has the other sign (starboard wing down is positive)"));
        }
        if ((way & 32) != 0) {
            one.reading.swapped = true;
            one.what.push_back(MARKED("core", "pitch stands for roll and roll for pitch"));
        }
        all.push_back(std::move(one));
    }
    return all;
}

constexpr std::size_t kFewestForSigns = 24;
constexpr double kPoorFit = 0.02; ///< of the field: below, there is nothing to look for

} // namespace

double explainedPart(const RegressionMoments& moments, double variance)
{
    const Eigen::Vector3d mean = moments.across.row(3).transpose() / moments.rows;
    const double all = (moments.own.diagonal() / moments.rows - mean.cwiseAbs2()).sum() / 3;
    return all > 0 ? std::clamp(1 - variance / all, 0.0, 1.0) : 1.0;
}

Message misnamedAngles(const SensorLog& log, const std::vector<std::uint8_t>& used, const AttitudeOptions& options)
{
    const auto rows = someRows(used, kRowsForNorth);
    std::vector<std::uint8_t> some(used.size(), 0);
    for (const auto row : rows)
        some[row] = 1;
    const auto fitBy = [&](const AngleReading& reading) { return regress(momentsOfRows(log, some, options.field, reading), 0); };
    const double stated = fitBy({}).variance;
    if (rows.size() < kFewestForSigns || std::sqrt(stated) < kPoorFit)
        return {};
    // Headings 180° off are the same as both signs with a sensor that looks aft: of ways that fit alike, the one that asks least of the sensor.
    const Misnamed* best = nullptr;
    const auto ways = otherReadings();
    double least = 0.25 * stated, iron = 0;
    for (const Misnamed& way : ways) {
        const Regression fit = fitBy(way.reading);
        const double asked = fit.solution.topRows<3>().norm();
        if (fit.variance < 0.8 * least || (best && fit.variance < 1.25 * least && asked < 0.9 * iron)) {
            best = &way;
            least = fit.variance;
            iron = asked;
        }
    }
    if (!best)
        return {};
    return {MARKED("core", "%1: so taken the samples are explained to %2 nT, as stated to %3 nT"), together(best->what),
        figureText(std::sqrt(least) * options.field.total_nT(), 0), figureText(std::sqrt(stated) * options.field.total_nT(), 0)};
}

RegressionMoments momentsOfRows(
    const SensorLog& log, const std::vector<std::uint8_t>& used, const MeridianField& field, const AngleReading& reading)
{
    RegressionMoments moments;
    const auto scales = currentScales(log);
    for (std::size_t row = 0; row < log.size(); ++row)
        if (used[row] != 0)
            addRow(moments, log, row, field, scales, reading);
    return moments;
}

Message misreadAngles(const SensorLog& log, const std::vector<std::uint8_t>& used, const AttitudeOptions& options, double variance)
{
    const bool smallHeadings = largestIn(log.heading_deg) <= 6.3,
               smallTilts = largestIn(log.pitch_deg) <= 1.6 && largestIn(log.roll_deg) <= 3.2; // a roll goes to π
    const auto better = [&](const AngleReading& reading) {
        return regress(momentsOfRows(log, used, options.field, reading), 0).variance < 0.25 * variance;
    };
    if (smallHeadings && largestIn(log.heading_deg) > 0.5 && better({kDegreesPerRadian, smallTilts ? kDegreesPerRadian : 1.0, 0}))
        return {
            MARKED("core",
                "heading, pitch and roll look like radians: the largest heading is %1, and as radians they explain the samples far better; expected degrees"),
            figureText(largestIn(log.heading_deg), 3)};
    if (smallTilts && largestIn(log.pitch_deg) + largestIn(log.roll_deg) > 0.05 && better({1.0, kDegreesPerRadian, 0}))
        return {
            MARKED("core",
                "pitch and roll look like radians: they stay within %1, and as radians they explain the samples far better; expected degrees"),
            figureText(std::max(largestIn(log.pitch_deg), largestIn(log.roll_deg)), 3)};
    return {};
}

void checkAxes(AttitudeResult& result, const RegressionMoments& moments)
{
    const Eigen::Vector3d meanField = moments.design.block<3, 1>(0, 3) / moments.rows,
                          meanRead = moments.across.row(3).transpose() / moments.rows;
    const Eigen::Matrix3d across = moments.across.topRows<3>() / moments.rows - meanField * meanRead.transpose(); // B by m
    const double size = (moments.design.topLeftCorner<3, 3>() / moments.rows - meanField * meanField.transpose()).trace()
        + (moments.own / moments.rows - meanRead * meanRead.transpose()).trace();
    std::array<int, 3> order{0, 1, 2}, best{0, 1, 2};
    int bestSigns = 0;
    double least = std::numeric_limits<double>::max(), stated = 0;
    do {
        for (int signs = 0; signs < 8; ++signs) {
            double explained = 0;
            for (int axis = 0; axis < 3; ++axis)
                explained += ((signs >> axis) & 1 ? -1.0 : 1.0) * across(axis, order[static_cast<std::size_t>(axis)]);
            const double rest = size - 2.0 * explained;
            if (signs == 0 && order == std::array{0, 1, 2})
                stated = rest;
            if (rest < least - 1e-12 * size) {
                least = rest;
                best = order;
                bestSigns = signs;
            }
        }
    } while (std::next_permutation(order.begin(), order.end()));
    if (stated <= 2.0 * least || stated < 0.05 * size)
        return;
    std::string named;
    for (int axis = 0; axis < 3; ++axis)
        named += std::string(axis > 0 ? ", " : "") + "xyz"[axis] + " = " + ((bestSigns >> axis) & 1 ? "\u2212" : "+")
            + "xyz"[best[static_cast<std::size_t>(axis)]] + " of the log";
    result.reasons.push_back(
        {MARKED(
             "core", "the axes of the log are not those of the aircraft: %1 fits %2 times better; expected x forward, y starboard, z down"),
            named, figureText(stated / std::max(least, 1e-9 * size), 1)});
    result.verdict = CalibrationVerdict::Doubtful;
}

void checkNorth(
    AttitudeResult& result, const SensorLog& log, const std::vector<std::uint8_t>& used, const AttitudeOptions& options, double variance)
{
    if (!options.variation) {
        checkUnknownNorth(result, log, used, options);
        return;
    }
    if (std::abs(options.variation->degrees()) < 1)
        return;
    if (std::sqrt(variance) * options.field.total_nT() < kExact_nT)
        return; // nothing is left to explain
    const AngleReading fromTrue{1.0, 1.0, -options.variation->degrees()};
    if (regress(momentsOfRows(log, used, options.field, fromTrue), 0).variance > 0.25 * variance)
        return;
    result.reasons.push_back(
        {MARKED("core",
             "the headings look true instead of magnetic: with the place's variation (%1°) taken out they explain the samples far better; expected magnetic headings"),
            signedFigureText(options.variation->degrees(), 1)});
    result.verdict = std::max(result.verdict, CalibrationVerdict::Doubtful);
}

} // namespace lubberline
