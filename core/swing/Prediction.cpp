#include "core/swing/Prediction.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/Number.h"
#include "core/earth/FieldModel.h"
#include "core/sensor/PoissonSmith.h"
#include "core/sensor/SensorReading.h"
#include "core/swing/CompassAtFault.h"

namespace lubberline {

namespace {

constexpr double kFarRatio = 2.0;    ///< of H there and here: the model of five coefficients is stretched
constexpr double kSmallTanDip = 0.1; ///< dip below 6°
constexpr double kNoWidth = 1e-12;
constexpr double kHalfTurn = 1e6; ///< tangent of half of half a turn, nearly

Result<void> check(const MeridianField& there, int count)
{
    LUBBERLINE_EXPECT(count >= 8 && count <= 720, "a predicted curve has 8 to 720 points");
    if (!(there.horizontal_nT >= kBlackoutHorizontal_nT))
        return Error{ErrorCode::Numeric,
            {MARKED("core", "H there is %1 nT, below 2000 nT (blackout zone): a compass tells nothing there"),
                std::lround(there.horizontal_nT)}};
    return {};
}

Result<void> check(const SwingAtPlace& swing)
{
    if (swing.field.horizontal_nT > 0 && std::isfinite(swing.field.down_nT))
        return {};
    return Error{ErrorCode::InvalidInput, {MARKED("core", "the field of %1 is not known; expected H above 0 and the dip"), swing.label}};
}

void warnOfField(Prediction& prediction)
{
    if (prediction.there.horizontal_nT < kCautionHorizontal_nT)
        prediction.warnings.push_back(MARKED("core", "caution zone: H there is below 6000 nT, compasses are unreliable"));
}

void warnOfSwing(Prediction& prediction, const SwingAtPlace& swing)
{
    if (!swing.taken.empty())
        prediction.warnings.push_back(swing.taken);
    if (std::abs(swing.field.down_nT) < kSmallTanDip * swing.field.horizontal_nT)
        prediction.warnings.push_back(
            {MARKED(
                 "core", "the dip is small at %1: vertical soft iron hardly showed, and what it does elsewhere is its assumed size only"),
                swing.label});
    if (!errorsKnown(swing))
        prediction.warnings.push_back(
            {MARKED("core", "the readings of %1 leave nothing over to tell their errors by: an error of %2\u00b0 a reading is assumed"),
                swing.label, figureText(prediction.assumed->readingError_deg, 1)});
    const double ratio = swing.field.horizontal_nT / prediction.there.horizontal_nT;
    if (ratio > kFarRatio || ratio < 1 / kFarRatio)
        prediction.warnings.push_back(MARKED("core", "H differs by more than a factor of two between the places"));
}

/// Numerator and denominator of [P 3]: the direction of the field that is left.
struct Left {
    double across = 0, along = 0;
    [[nodiscard]] double square() const { return across * across + along * along; }
    [[nodiscard]] bool vanishes() const { return !(square() > kVanishingPart * kVanishingPart); }
    [[nodiscard]] std::optional<double> deviation_rad() const
    {
        return vanishes() ? std::nullopt : std::optional(std::atan2(across, along));
    }
};

/// Evenly spaced headings from north, with what [P 3] needs of each.
class Headings {
public:
    explicit Headings(int count)
    {
        for (int i = 0; i < count; ++i) {
            const double z = 2 * kPi * i / count;
            m_rows.push_back({std::sin(z), std::cos(z), std::sin(2 * z), std::cos(2 * z)});
        }
    }
    [[nodiscard]] std::size_t count() const { return m_rows.size(); }
    [[nodiscard]] MagneticHeading at(std::size_t i) const
    {
        return MagneticHeading::fromDegrees(360.0 * static_cast<double>(i) / static_cast<double>(m_rows.size()));
    }
    [[nodiscard]] Left left(const ExactSmith& smith, std::size_t i) const
    {
        const auto& [s1, c1, s2, c2] = m_rows[i];
        return {smith.A + smith.B * s1 + smith.C * c1 + smith.D * s2 + smith.E * c2,
            1 + smith.B * c1 - smith.C * s1 + smith.D * c2 - smith.E * s2};
    }

private:
    std::vector<std::array<double, 4>> m_rows;
};

/// |tan| of half the angle between two directions: grows with the angle, and needs no arc tangent a draw. Half a turn where one
/// of them vanishes.
double halfTangent(const Left& a, const Left& b)
{
    const double lengths = std::sqrt(a.square() * b.square()) + a.along * b.along + a.across * b.across;
    const double tangent = std::abs(a.across * b.along - a.along * b.across) / lengths;
    return tangent < kHalfTurn && !a.vanishes() && !b.vanishes() ? tangent : kHalfTurn;
}

double angleOf_rad(double halfTangent) { return halfTangent < kHalfTurn ? 2 * std::atan(halfTangent) : kPi; }

/// What kBoundProbability of the values do not exceed.
double bound(std::vector<double>& values)
{
    const auto count = static_cast<double>(values.size());
    const auto rank = values.begin() + static_cast<std::ptrdiff_t>(std::min(count - 1, std::ceil(kBoundProbability * count) - 1));
    std::nth_element(values.begin(), rank, values.end());
    return *rank;
}

/// The largest |change| over heading, as the tangent of its half.
double largestChange(const Headings& headings, const ExactSmith& from, const ExactSmith& to)
{
    double largest = 0;
    for (std::size_t i = 0; i < headings.count(); ++i)
        largest = std::max(largest, halfTangent(headings.left(from, i), headings.left(to, i)));
    return largest;
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

/// Half widths of the band about the middle: in proportion to how far the draws lie off at each heading on average, and as wide
/// as the whole curve of kBoundProbability of the draws needs to be inside (by the tangents of half the angles).
std::vector<double> halfWidths_rad(const Headings& headings, const ExactSmith& middle, std::span<const ExactSmith> draws)
{
    std::vector<double> width(headings.count()), outermost(draws.size()), off(draws.size());
    for (std::size_t i = 0; i < headings.count(); ++i) {
        const Left here = headings.left(middle, i);
        for (std::size_t j = 0; j < draws.size(); ++j) {
            off[j] = halfTangent(here, headings.left(draws[j], i));
            width[i] += std::min(off[j], 1.0) / static_cast<double>(draws.size()); // a quarter turn is off by as much as any more
        }
        for (std::size_t j = 0; j < draws.size() && width[i] > kNoWidth; ++j)
            outermost[j] = std::max(outermost[j], off[j] / width[i]);
    }
    const double wider = bound(outermost);
    for (double& each : width)
        each = angleOf_rad(wider * each);
    return width;
}

/// @param index_rad of a compass that is far out as a whole: no place changes it, and all of the curve has it.
void fill(Prediction& prediction, const Headings& headings, std::span<const ExactSmith> draws, double index_rad)
{
    const auto width = halfWidths_rad(headings, *prediction.exact, draws);
    for (std::size_t i = 0; i < headings.count(); ++i) {
        PredictedPoint point{headings.at(i), {}, {}, {}};
        if (const auto deviation = headings.left(*prediction.exact, i).deviation_rad()) {
            point.deviation = Deviation::fromRadians(*deviation + index_rad);
            point.lowest_rad = point.deviation->radians() - width[i];
            point.highest_rad = point.deviation->radians() + width[i];
        }
        prediction.points.push_back(point);
    }
    summarisePrediction(prediction);
}

PredictedChange changeOf(const Headings& headings, const IronPosterior& iron, const MeridianField& here, const MeridianField& there)
{
    std::vector<double> changes;
    for (const auto& draw : iron.draws)
        changes.push_back(largestChange(headings, draw.at(here), draw.at(there)));
    return {angleOf_rad(largestChange(headings, iron.mean.at(here), iron.mean.at(there))), angleOf_rad(bound(changes))};
}

std::string degrees(double angle_rad) { return figureText(toDegrees(angle_rad), 1) + "°"; }

/// "…, with a probability of 95 % for iron of a plausible size: …"; of a model nothing is assumed.
Message howSure(const Prediction& prediction)
{
    if (!prediction.assumed)
        return MARKED("core", "by the model");
    return {
        MARKED("core", "with a probability of %1 %, assuming %2"), std::lround(100 * kBoundProbability), sayAssumed(*prediction.assumed)};
}

std::vector<PredictedPoint> pointsOf(const SensorResponse& sensor, const MeridianField& field, const Headings& headings)
{
    std::vector<PredictedPoint> points;
    for (std::size_t i = 0; i < headings.count(); ++i) {
        PredictedPoint point{headings.at(i), {}, {}, {}};
        point.deviation = readSensor(sensor, field, {point.magnetic, 0, 0}).deviation;
        if (point.deviation)
            point.lowest_rad = point.highest_rad = point.deviation->radians();
        points.push_back(point);
    }
    return points;
}

double largestChange_rad(std::span<const PredictedPoint> here, std::span<const PredictedPoint> there)
{
    double largest = 0;
    for (std::size_t i = 0; i < here.size(); ++i)
        largest = std::max(largest,
            here[i].deviation && there[i].deviation
                ? std::abs(std::remainder(there[i].deviation->radians() - here[i].deviation->radians(), 2 * kPi))
                : kPi);
    return largest;
}

} // namespace

Result<Prediction> predict(const SensorModel& model, const Move& move, int count)
{
    if (const auto checked = check(move.there, count); !checked)
        return checked.error();
    Prediction prediction;
    prediction.there = move.there;
    prediction.basis = MARKED("core", "a sensor model");
    if (const auto smith = smithOf(model, move.there))
        prediction.exact = smith->exact;
    else
        prediction.warnings.push_back(smith.error().message);
    const SensorResponse sensor = responseOf(model);
    const Headings headings(count);
    prediction.points = pointsOf(sensor, move.there, headings);
    if (move.here) {
        const double change = largestChange_rad(pointsOf(sensor, *move.here, headings), prediction.points);
        prediction.change = {change, change};
    }
    summarisePrediction(prediction);
    warnOfField(prediction);
    return prediction;
}

Result<Prediction> predict(std::span<const SwingAtPlace> swings, const Move& move, const AssumedIron& assumed, int count)
{
    LUBBERLINE_EXPECT(!swings.empty(), "a prediction needs a swing");
    if (const auto checked = check(move.there, count); !checked)
        return checked.error();
    for (const auto& swing : swings)
        if (const auto checked = check(swing); !checked)
            return checked.error();
    Prediction prediction;
    prediction.there = move.there;
    prediction.assumed = assumed;
    if (swings.size() == 1) {
        prediction.basis = {MARKED("core", "one swing (%1), which cannot tell hard iron from vertical soft iron"), swings.front().label};
        warnOfSwing(prediction, swings.front());
    } else {
        prediction.basis = MARKED("core", "swings at several places");
        auto separation = separateIron(swings); // says where they contradict each other, or are too alike
        if (!separation)
            return separation.error();
        prediction.warnings = std::move(separation->warnings);
    }
    const IronPosterior iron = ironOf(swings, assumed);
    const Headings headings(count);
    std::vector<ExactSmith> there;
    for (const auto& draw : iron.draws)
        there.push_back(draw.at(move.there));
    prediction.exact = iron.mean.at(move.there);
    const double index_rad = swings.back().index_rad; // as the compass stands since the last of them
    fill(prediction, headings, there, index_rad);
    for (const auto& words : {indexWords(toDegrees(index_rad)), indexMeaning(toDegrees(index_rad))})
        if (words)
            prediction.warnings.push_back(*words);
    if (move.here)
        prediction.change = changeOf(headings, iron, *move.here, move.there);
    warnOfField(prediction);
    return prediction;
}

Result<Prediction> predict(const SwingAtPlace& swing, const MeridianField& there, int count)
{
    return predict(std::span(&swing, 1), {swing.field, there}, {}, count);
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

std::optional<SwingAgain> swingAgainAfterMove(const Prediction& prediction, const std::optional<LimitsProfile>& limits, double change_deg)
{
    if (!prediction.change)
        return {};
    const Message sure = howSure(prediction);
    switch (judge(prediction, limits)) {
    case PredictedVerdict::OutOfLimits:
        return SwingAgain{true, {MARKED("core", "up to %1 is expected there, beyond the limit"), degrees(prediction.maxAbs_rad)}};
    case PredictedVerdict::MayLeaveLimits:
        return SwingAgain{
            true, {MARKED("core", "up to %1 is possible there, beyond the limit, %2"), degrees(prediction.maxAbsPossible_rad), sure}};
    case PredictedVerdict::InLimits:
    case PredictedVerdict::NoLimit: break;
    }
    const double change = prediction.change->bound_rad;
    if (toDegrees(change) > change_deg)
        return SwingAgain{true,
            {MARKED("core", "the card of here may not be right there: the deviation changes by up to %1, %2"), degrees(change), sure}};
    return SwingAgain{false, {MARKED("core", "the deviation changes by no more than %1, %2"), degrees(change), sure}};
}

} // namespace lubberline
