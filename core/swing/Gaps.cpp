#include "core/swing/Gaps.h"

#include <algorithm>
#include <cmath>

#include "core/angle/AngleText.h"
#include "core/base/Number.h"

namespace lubberline {

namespace {

constexpr double kRoundingOfGaps_deg = 1e-6; // headings are decimal: 60.000000000000014 is 60
constexpr double kReadThere_deg = 3;
constexpr double kTenth_deg = 0.1; ///< no band is told as none

/// Clockwise from `from` to `heading` [deg], [0, 360).
double clockwise_deg(double from_deg, double heading_deg) { return wrap360(heading_deg - from_deg); }

std::optional<double> widestBand_rad(const ApproximateFit& fit, CompassHeading from, double width_deg)
{
    std::optional<double> widest;
    if (fit.parameters < static_cast<int>(kCoefficientCount)) // D and E may be anything, and are largest between the readings
        return widest;
    const int steps = static_cast<int>(std::ceil(width_deg));
    for (int i = 0; i <= steps; ++i) {
        const auto band = bandHalfWidth_rad(fit, CompassHeading::fromDegrees(from.degrees() + width_deg * i / steps));
        if (!band)
            return std::nullopt;
        widest = std::max(widest.value_or(0.0), *band);
    }
    return widest;
}

} // namespace

bool ReadingGap::holds(MagneticHeading heading) const
{
    const double all = clockwise_deg(magneticFrom.degrees(), magneticTo.degrees());
    const double in = clockwise_deg(magneticFrom.degrees(), heading.degrees());
    return in > kReadThere_deg + kRoundingOfGaps_deg && in < (all > 0 ? all : 360.0) - kReadThere_deg - kRoundingOfGaps_deg;
}

std::vector<ReadingGap> gapsOf(const Analysis& analysis)
{
    std::vector<const AnalysedReading*> readings;
    for (const auto& reading : analysis.readings)
        readings.push_back(&reading);
    std::stable_sort(readings.begin(), readings.end(),
        [](const AnalysedReading* a, const AnalysedReading* b) { return a->compass.degrees() < b->compass.degrees(); });
    std::vector<ReadingGap> gaps;
    for (std::size_t i = 0; i < readings.size(); ++i) {
        const auto &here = *readings[i], &next = *readings[(i + 1) % readings.size()];
        const bool last = i + 1 == readings.size();
        const double width_deg = next.compass.degrees() - here.compass.degrees() + (last ? 360.0 : 0.0);
        if (width_deg > kWideGap_deg + kRoundingOfGaps_deg)
            gaps.push_back({here.compass, next.compass, here.magnetic, next.magnetic, width_deg,
                widestBand_rad(analysis.approximate, here.compass, width_deg)});
    }
    return gaps;
}

Message wordsOf(const ReadingGap& gap)
{
    const std::string from = formatHeading(gap.from.degrees(), AngleStyle::DecimalDegrees, 0);
    const std::string to = formatHeading(gap.to.degrees(), AngleStyle::DecimalDegrees, 0), width = figureText(gap.width_deg, 0) + "°";
    if (!gap.widestBand_rad)
        return {MARKED("core", "no reading between %1 and %2 (compass), an arc of %3: how far the curve is off there is not known"), from,
            to, width};
    return {MARKED("core", "no reading between %1 and %2 (compass), an arc of %3: the curve there is known to ±%4 only (95 %)"), from, to,
        width, figureText(std::max(kTenth_deg, toDegrees(*gap.widestBand_rad)), 1) + "°"};
}

} // namespace lubberline
