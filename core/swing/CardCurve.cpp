#include "core/swing/CardCurve.h"

#include <algorithm>
#include <cmath>

#include "core/angle/AngleText.h"

namespace lubberline {

namespace {

constexpr int kCurveSteps = 1440;
constexpr double kCurveStep_deg = 360.0 / kCurveSteps;

std::string curveHeading(double heading_deg) { return formatHeading(heading_deg, AngleStyle::DecimalDegrees, 0); }

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
    const auto reads
        = [this](double magnetic_deg) { return curveHeading(compassAt(MagneticHeading::fromDegrees(magnetic_deg)).degrees()); };
    return Error{ErrorCode::Numeric,
        {MARKED("core",
             "no card: while the aircraft turns from %1 to %2 (magnetic) the compass goes back from %3 to %4, so that one reading stands "
             "for more than one heading; expected a compass that rises all the way around"),
            curveHeading(first_deg), curveHeading(last_deg), reads(first_deg), reads(last_deg)}};
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
