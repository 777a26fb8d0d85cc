#include "core/swing/CardCurve.h"

#include <algorithm>
#include <cmath>

#include "core/angle/AngleText.h"

namespace lubberline {

namespace {

constexpr int kCurveSteps = 1440;
constexpr double kCurveStep_deg = 360.0 / kCurveSteps;

std::string curveHeading(double heading_deg, int decimals) { return formatHeading(heading_deg, AngleStyle::DecimalDegrees, decimals); }

} // namespace

CardCurve::CardCurve(DeviationAt deviation) : m_deviation(std::move(deviation))
{
    for (int i = 0; i <= kCurveSteps; ++i) {
        const double compass_deg = compassAt(MagneticHeading::fromDegrees(i * kCurveStep_deg)).degrees();
        m_compass_deg.push_back(i == 0 ? compass_deg : m_compass_deg.back() + wrap180(compass_deg - m_compass_deg.back()));
    }
}

Result<CardCurve> CardCurve::of(DeviationAt deviation)
{
    CardCurve curve(std::move(deviation));
    if (const auto oneWay = curve.checkOneWay(); !oneWay)
        return oneWay.error();
    return curve;
}

Result<void> CardCurve::checkOneWay() const
{
    // The longest stretch on which it goes back; it may begin before north and end after it.
    const auto goesBack = [this](int i) {
        const auto at = static_cast<std::size_t>(i % kCurveSteps);
        return m_compass_deg[at + 1] - m_compass_deg[at] <= 0.0;
    };
    int longest = 0, from = 0;
    for (int i = 0, run = 0; i < 2 * kCurveSteps; ++i) {
        run = goesBack(i) ? run + 1 : 0;
        if (run > longest && run <= kCurveSteps) {
            longest = run;
            from = i + 1 - run;
        }
    }
    const double turned_deg = m_compass_deg.back() - m_compass_deg.front();
    if (longest == 0 && std::abs(turned_deg - 360.0) < 1e-6)
        return {};
    const double first_deg = from * kCurveStep_deg, last_deg = (from + longest) * kCurveStep_deg;
    constexpr double kNarrow_deg = 2.0; // told to tenths, as its two ends would be one heading
    const int decimals = longest * kCurveStep_deg < kNarrow_deg ? 1 : 0;
    const auto reads = [this, decimals](double magnetic_deg) {
        return curveHeading(compassAt(MagneticHeading::fromDegrees(magnetic_deg)).degrees(), decimals);
    };
    if (longest >= kCurveSteps)
        return Error{ErrorCode::Numeric,
            {MARKED("core",
                 "no card: by the curve of these readings the compass runs backwards all the way around (it reads %1 on %2 and %3 on %4, "
                 "magnetic); expected a compass that rises all the way around"),
                reads(0.0), curveHeading(0.0, 0), reads(90.0), curveHeading(90.0, 0)}};
    return Error{ErrorCode::Numeric,
        {MARKED("core",
             "no card: while the aircraft turns from %1 to %2 (magnetic) the compass goes back from %3 to %4, so that one reading stands "
             "for more than one heading; expected a compass that rises all the way around"),
            curveHeading(first_deg, decimals), curveHeading(last_deg, decimals), reads(first_deg), reads(last_deg)}};
}

MagneticHeading CardCurve::magneticAt(CompassHeading compass) const
{
    // Whole turns into the range of the table, then the step that holds it, then halves of that.
    const double wanted_deg = m_compass_deg.front() + wrap360(compass.degrees() - m_compass_deg.front());
    const auto above = std::upper_bound(m_compass_deg.begin(), m_compass_deg.end(), wanted_deg);
    const auto step = static_cast<double>(std::min<std::ptrdiff_t>(above - m_compass_deg.begin(), kCurveSteps) - 1);
    double low_deg = step * kCurveStep_deg, high_deg = low_deg + kCurveStep_deg;
    for (int i = 0; i < 50; ++i) {
        const double middle_deg = (low_deg + high_deg) / 2;
        const double reads_deg = compassAt(MagneticHeading::fromDegrees(middle_deg)).degrees();
        (wrap180(reads_deg - compass.degrees()) < 0 ? low_deg : high_deg) = middle_deg;
    }
    return MagneticHeading::fromDegrees((low_deg + high_deg) / 2);
}

} // namespace lubberline
