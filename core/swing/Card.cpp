#include "core/swing/Card.h"

#include <algorithm>
#include <cmath>

namespace lubberline {

namespace {

Error cannotTell(const Message& what)
{
    return {ErrorCode::Numeric, {MARKED("core", "%1 cannot be told from these headings; expected readings all around the compass"), what}};
}

/// The approximate coefficients that are taken out when the card is made of readings: the worksheet takes those of the point
/// rules.
Result<ApproximateSmith> removedFromReadings(const Analysis& analysis, CoefficientSet removed)
{
    ApproximateSmith smith;
    const std::array<double*, kCoefficientCount> field{&smith.A_rad, &smith.B_rad, &smith.C_rad, &smith.D_rad, &smith.E_rad};
    for (const Coefficient coefficient : kCoefficients) {
        if (!removed.test(indexOf(coefficient)))
            continue;
        std::optional<double> value = analysis.approximate.of(coefficient);
        if (analysis.pointRules) {
            const auto& rules = *analysis.pointRules;
            const std::array<std::optional<double>, kCoefficientCount> byRule{
                rules.A_rad, rules.B_rad, rules.C_rad, rules.D_rad, rules.E_rad};
            if (byRule[indexOf(coefficient)])
                value = byRule[indexOf(coefficient)];
        }
        if (!value)
            return cannotTell({MARKED("core", "coefficient %1"), letterOf(coefficient)});
        *field[indexOf(coefficient)] = *value;
    }
    return smith;
}

const AnalysedReading& nearestReading(const Analysis& analysis, MagneticHeading heading)
{
    const auto distance = [&](const AnalysedReading& reading) { return std::abs(wrap180(reading.magnetic.degrees() - heading.degrees())); };
    // Of two equally near the one of the smaller heading, whatever the order of the readings.
    return *std::min_element(analysis.readings.begin(), analysis.readings.end(), [&](const AnalysedReading& a, const AnalysedReading& b) {
        return std::pair(distance(a), a.magnetic.degrees()) < std::pair(distance(b), b.magnetic.degrees());
    });
}

/// Figures read are decimal: what rounding in radians left of 1.0000000000000002 is cut, so that a steer of 43 is 43.
double clean_deg(double angle_deg) { return std::round(angle_deg * 1e10) / 1e10; }

Result<Deviation> residualFromReadings(const Analysis& analysis, const ApproximateSmith& removed, MagneticHeading heading)
{
    const AnalysedReading& nearest = nearestReading(analysis, heading);
    const double taken_deg = deviationAt(removed, nearest.compass).degrees();
    return Deviation::fromDegrees(clean_deg(nearest.deviation.degrees() - taken_deg));
}

Result<Deviation> residualFromFit(const Analysis& analysis, CoefficientSet removed, MagneticHeading heading)
{
    if (!analysis.exact.fitted())
        return cannotTell(MARKED("core", "the deviation curve"));
    const bool removeA = removed.test(indexOf(Coefficient::A));
    if (removeA && !analysis.approximate.of(Coefficient::A))
        return cannotTell({MARKED("core", "coefficient %1"), 'A'});
    // A is a turn of the compass in its mount, an angle; the others are fields at the sensor.
    removed.reset(indexOf(Coefficient::A));
    const Deviation left = deviationAt(without(analysis.exact.smith(), removed), heading);
    const double turn_rad = removeA ? *analysis.approximate.of(Coefficient::A) : 0.0;
    return Deviation::fromRadians(left.radians() - turn_rad);
}

} // namespace

int CardRow::steerRounded_deg() const { return static_cast<int>(std::floor(steer.degrees() + 0.5)) % 360; }

Result<Card> makeCard(const Analysis& analysis, const CardOptions& options)
{
    if (options.step_deg != 30 && options.step_deg != 45)
        return Error{ErrorCode::InvalidInput, {MARKED("core", "a card has steps of 30° or 45°, not %1°"), options.step_deg}};
    const auto removed = removedFromReadings(analysis, options.source == CardSource::Readings ? options.removed : CoefficientSet{});
    if (!removed)
        return removed.error();
    Card card;
    for (int heading_deg = 0; heading_deg < 360; heading_deg += options.step_deg) {
        const auto magnetic = MagneticHeading::fromDegrees(heading_deg);
        const auto residual = options.source == CardSource::Readings ? residualFromReadings(analysis, *removed, magnetic)
                                                                     : residualFromFit(analysis, options.removed, magnetic);
        if (!residual)
            return residual.error();
        card.rows.push_back({magnetic, toCompass(magnetic, *residual), *residual});
        card.residualMaxAbs_rad = std::max(card.residualMaxAbs_rad, std::abs(residual->radians()));
    }
    return card;
}

} // namespace lubberline
