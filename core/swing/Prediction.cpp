#include "core/swing/Prediction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core/earth/FieldModel.h"
#include "core/sensor/PoissonSmith.h"
#include "core/sensor/SensorReading.h"

namespace lubberline {

namespace {

constexpr double kBandErrors = 2.0;  ///< standard errors either way
constexpr double kFarRatio = 2.0;    ///< of H there and here: the model of five coefficients is stretched
constexpr double kSmallTanDip = 0.1; ///< dip below 6°: an error of 0.3° in B may become one of 3° where the dip is 45°

Result<void> check(const MeridianField& there, int count)
{
    LUBBERLINE_EXPECT(count >= 8 && count <= 3600, "a predicted curve has 8 to 3600 points");
    if (!(there.horizontal_nT >= kBlackoutHorizontal_nT))
        return Error{ErrorCode::Numeric,
            {MARKED("core", "H there is %1 nT, below 2000 nT (blackout zone): a compass tells nothing there"),
                std::lround(there.horizontal_nT)}};
    return {};
}

void warnOfField(Prediction& prediction)
{
    if (prediction.there.horizontal_nT < kCautionHorizontal_nT)
        prediction.warnings.push_back(MARKED("core", "caution zone: H there is below 6000 nT, compasses are unreliable"));
}

/// The horizontal field that is left, as a part of λH: the length of [P 3]'s numerator and denominator.
double lengthAt(const ExactSmith& smith, MagneticHeading magnetic)
{
    const double z = magnetic.radians();
    return std::hypot(smith.A + smith.B * std::sin(z) + smith.C * std::cos(z) + smith.D * std::sin(2 * z) + smith.E * std::cos(2 * z),
        1 + smith.B * std::cos(z) - smith.C * std::sin(z) + smith.D * std::cos(2 * z) - smith.E * std::sin(2 * z));
}

/// δ of exact coefficients [P 3]; none where both sides of the arc tangent vanish.
std::optional<Deviation> deviationOrNone(const ExactSmith& smith, MagneticHeading magnetic)
{
    if (!(lengthAt(smith, magnetic) > kVanishingPart))
        return {};
    return deviationAt(smith, magnetic);
}

/// How far the curve may lie off for independent errors of the coefficients: the derivatives of [P 3], which grow as the field
/// that is left shrinks; half a turn at most.
double errorAt_rad(const ExactSmith& smith, const ExactSmith& error, MagneticHeading magnetic, double deviation_rad)
{
    const double z = magnetic.radians(), z1 = z - deviation_rad, z2 = 2 * z - deviation_rad;
    const double across = std::sqrt(std::pow(error.A * std::cos(deviation_rad), 2) + std::pow(error.B * std::sin(z1), 2)
        + std::pow(error.C * std::cos(z1), 2) + std::pow(error.D * std::sin(z2), 2) + std::pow(error.E * std::cos(z2), 2));
    return std::min(kPi, across / lengthAt(smith, magnetic));
}

void summarisePrediction(Prediction& prediction)
{
    for (const auto& point : prediction.points) {
        if (!point.deviation)
            continue;
        prediction.maxAbs_rad = std::max(prediction.maxAbs_rad, std::abs(point.deviation->radians()));
        prediction.maxAbsPossible_rad
            = std::max({prediction.maxAbsPossible_rad, std::abs(*point.lowest_rad), std::abs(*point.highest_rad)});
    }
}

/// The middle curve and the hull of the corners, widened by two standard errors.
void fill(Prediction& prediction, const ExactSmith& middle, std::span<const ExactSmith> corners, const ExactSmith& error, int count)
{
    prediction.exact = middle;
    for (int i = 0; i < count; ++i) {
        PredictedPoint point{MagneticHeading::fromDegrees(360.0 * i / count), {}, {}, {}};
        point.deviation = deviationOrNone(middle, point.magnetic);
        if (point.deviation) {
            const double here = point.deviation->radians();
            double lowest = here, highest = here;
            for (const auto& corner : corners)
                if (const auto deviation = deviationOrNone(corner, point.magnetic)) {
                    const double off = std::remainder(deviation->radians() - here, 2 * kPi);
                    lowest = std::min(lowest, here + off);
                    highest = std::max(highest, here + off);
                }
            const double widened = kBandErrors * errorAt_rad(middle, error, point.magnetic, here);
            point.lowest_rad = lowest - widened;
            point.highest_rad = highest + widened;
        }
        prediction.points.push_back(point);
    }
    summarisePrediction(prediction);
}

std::string degrees(double angle_rad)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.1f\u00b0", toDegrees(angle_rad));
    return text.data();
}

double largestChange_rad(const Prediction& here, const Prediction& there)
{
    double largest = 0;
    const std::size_t count = std::min(here.points.size(), there.points.size());
    for (std::size_t i = 0; i < count; ++i)
        if (here.points[i].deviation && there.points[i].deviation)
            largest = std::max(largest, std::abs(wrap180(there.points[i].deviation->degrees() - here.points[i].deviation->degrees())));
    return toRadians(largest);
}

} // namespace

Result<Prediction> predict(const SensorModel& model, const MeridianField& there, int count)
{
    if (const auto checked = check(there, count); !checked)
        return checked.error();
    Prediction prediction;
    prediction.there = there;
    prediction.basis = MARKED("core", "a sensor model");
    if (const auto smith = smithOf(model, there))
        prediction.exact = smith->exact;
    else
        prediction.warnings.push_back(smith.error().message);
    const SensorResponse sensor = responseOf(model);
    for (int i = 0; i < count; ++i) {
        PredictedPoint point{MagneticHeading::fromDegrees(360.0 * i / count), {}, {}, {}};
        point.deviation = readSensor(sensor, there, {point.magnetic, 0, 0}).deviation;
        if (point.deviation)
            point.lowest_rad = point.highest_rad = point.deviation->radians();
        prediction.points.push_back(point);
    }
    summarisePrediction(prediction);
    warnOfField(prediction);
    return prediction;
}

Result<Prediction> predict(const SwingAtPlace& swing, const MeridianField& there, int count)
{
    if (const auto checked = check(there, count); !checked)
        return checked.error();
    if (!(swing.field.horizontal_nT > 0))
        return Error{
            ErrorCode::InvalidInput, {MARKED("core", "the field of %1 is not known; expected H above 0 and the dip"), swing.label}};
    Prediction prediction;
    prediction.there = there;
    const double hard = swing.field.horizontal_nT / there.horizontal_nT; // B of hard iron goes by 1/H
    const double tanHere = swing.field.down_nT / swing.field.horizontal_nT, tanThere = there.down_nT / there.horizontal_nT;
    double soft = hard;
    if (tanHere != 0.0)
        soft = tanThere / tanHere; // B of vertical soft iron goes by tan I
    else
        prediction.warnings.push_back(
            MARKED("core", "the dip is 0 where it was swung: vertical soft iron did not show, and what it does elsewhere is not known"));
    if (tanHere != 0.0 && std::abs(tanHere) < kSmallTanDip)
        prediction.warnings.push_back(
            MARKED("core", "the dip is small where it was swung: vertical soft iron hardly showed, and the band is wide for that"));
    prediction.basis = {
        MARKED("core",
            "one swing (%1), between the two extremes: all hard iron, and all vertical soft iron; where the two oppose each other the curve may lie beyond"),
        swing.label};
    const auto scaled = [&swing](double byB, double byC) {
        ExactSmith smith = swing.exact;
        smith.B *= byB;
        smith.C *= byC;
        return smith;
    };
    const std::array corners{scaled(hard, hard), scaled(hard, soft), scaled(soft, hard), scaled(soft, soft)};
    ExactSmith error = swing.standardError;
    const double widest = std::max(std::abs(hard), std::abs(soft));
    error.B *= widest;
    error.C *= widest;
    for (auto* const each : {&error.A, &error.B, &error.C, &error.D, &error.E})
        *each *= widening(swing.degreesOfFreedom);
    fill(prediction, scaled((hard + soft) / 2, (hard + soft) / 2), corners, error, count);
    if (hard > kFarRatio || hard < 1 / kFarRatio)
        prediction.warnings.push_back(MARKED("core", "H differs by more than a factor of two between the places"));
    warnOfField(prediction);
    return prediction;
}

Result<Prediction> predict(const IronSeparation& separation, const MeridianField& there, int count)
{
    if (const auto checked = check(there, count); !checked)
        return checked.error();
    Prediction prediction;
    prediction.there = there;
    prediction.basis = MARKED("core", "swings at several places");
    const double tanI = there.down_nT / there.horizontal_nT, perH = 1.0 / there.horizontal_nT;
    const auto sum = [&](const Estimate& soft, const Estimate& hard) { return soft.value * tanI + hard.value * perH; };
    const auto error = [&](const Estimate& soft, const Estimate& hard) {
        const double s = soft.standardError * tanI, h = hard.standardError * perH;
        return std::sqrt(std::max(0.0, s * s + h * h + 2 * separation.correlation * s * h));
    };
    const ExactSmith middle{
        separation.A.value, sum(separation.c, separation.P_nT), sum(separation.f, separation.Q_nT), separation.D.value, separation.E.value};
    const ExactSmith errors{separation.A.standardError, error(separation.c, separation.P_nT), error(separation.f, separation.Q_nT),
        separation.D.standardError, separation.E.standardError};
    fill(prediction, middle, {}, errors, count);
    prediction.warnings = separation.warnings;
    warnOfField(prediction);
    return prediction;
}

PredictedVerdict judge(const Prediction& prediction, const std::optional<LimitsProfile>& limits)
{
    if (!limits || !limits->maxDeviation_deg)
        return PredictedVerdict::NoLimit;
    const double limit = toRadians(*limits->maxDeviation_deg);
    const bool undefined
        = std::any_of(prediction.points.begin(), prediction.points.end(), [](const auto& point) { return !point.deviation; });
    if (undefined || prediction.maxAbs_rad > limit)
        return PredictedVerdict::OutOfLimits;
    return prediction.maxAbsPossible_rad > limit ? PredictedVerdict::MayLeaveLimits : PredictedVerdict::InLimits;
}

SwingAgain swingAgainAfterMove(
    const Prediction& here, const Prediction& there, const std::optional<LimitsProfile>& limits, double change_deg)
{
    switch (judge(there, limits)) {
    case PredictedVerdict::OutOfLimits:
        return {true, {MARKED("core", "up to %1 is expected there, beyond the limit"), degrees(there.maxAbs_rad)}};
    case PredictedVerdict::MayLeaveLimits:
        return {true, {MARKED("core", "up to %1 is possible there, beyond the limit"), degrees(there.maxAbsPossible_rad)}};
    case PredictedVerdict::InLimits:
    case PredictedVerdict::NoLimit: break;
    }
    const double change = largestChange_rad(here, there);
    if (toDegrees(change) > change_deg)
        return {true, {MARKED("core", "the deviation changes by up to %1: the card of here is not right there"), degrees(change)}};
    return {false, {MARKED("core", "the deviation changes by %1 at most"), degrees(change)}};
}

} // namespace lubberline
