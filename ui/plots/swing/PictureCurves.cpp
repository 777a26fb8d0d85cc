#include "ui/plots/swing/PictureCurves.h"

#include <algorithm>
#include <cmath>

namespace lubberline::ui {

namespace {

constexpr int kTurn_deg = 360;

/// The sum of the components rather than deviationAt(): it is not wrapped, so the curve has no jump.
double sum_deg(const ApproximateSmith& smith, double compass_deg)
{
    const auto compass = CompassHeading::fromDegrees(compass_deg);
    double sum_rad = 0;
    for (const Coefficient which : kCoefficients)
        sum_rad += component_rad(smith, which, compass);
    return toDegrees(sum_rad);
}

double maxAbsY(const QPolygonF& curve)
{
    double largest = 0;
    for (const QPointF& point : curve)
        largest = std::max(largest, std::abs(point.y()));
    return largest;
}

double maxAbsOfFits(const Analysis* analysis)
{
    if (!analysis)
        return 0;
    return std::max(maxAbsY(approximateCurve(analysis->approximate)), maxAbsY(exactCurve(analysis->exact)));
}

double headingOf(const QPointF& point) { return point.x(); }
double headingOf(const BandPoint& point) { return point.magnetic_deg; }

QPointF between(const QPointF& a, const QPointF& b, double share) { return a + share * (b - a); }
BandPoint between(const BandPoint& a, const BandPoint& b, double share)
{
    const auto mix = [share](double from, double to) { return from + share * (to - from); };
    return {mix(a.magnetic_deg, b.magnetic_deg), mix(a.low_deg, b.low_deg), mix(a.high_deg, b.high_deg)};
}

QPointF turned(QPointF point, double by_deg) { return point + QPointF(by_deg, 0); }
BandPoint turned(BandPoint point, double by_deg)
{
    point.magnetic_deg += by_deg;
    return point;
}

template <class Points>
Points cutToOneTurn(const Points& turn)
{
    Points three;
    if (turn.empty())
        return three;
    for (const double by_deg : {-360.0, 0.0, 360.0}) {
        // A turn begins where the one before ends.
        for (auto it = turn.begin() + (three.empty() ? 0 : 1); it < turn.end(); ++it)
            three.push_back(turned(*it, by_deg));
    }
    Points inside;
    for (auto it = three.begin(); it != three.end(); ++it) {
        if (it != three.begin()) {
            const auto& before = *(it - 1);
            const double from = headingOf(before), to = headingOf(*it);
            for (const double end : {0.0, 360.0}) {
                if ((from < end) != (to < end) && from != end && to != end)
                    inside.push_back(between(before, *it, (end - from) / (to - from)));
            }
        }
        const double heading = headingOf(*it);
        if (heading >= 0.0 && heading <= 360.0)
            inside.push_back(*it);
    }
    return inside;
}

} // namespace

QPolygonF approximateCurve(const ApproximateFit& fit)
{
    QPolygonF curve;
    if (!fit.fitted())
        return curve;
    const ApproximateSmith smith = fit.smith();
    curve.reserve(kTurn_deg + 1);
    for (int compass_deg = 0; compass_deg <= kTurn_deg; ++compass_deg) {
        const double deviation_deg = sum_deg(smith, compass_deg);
        curve.append({compass_deg + deviation_deg, deviation_deg});
    }
    return curve;
}

QPolygonF exactCurve(const ExactFit& fit)
{
    QPolygonF curve;
    if (!fit.fitted())
        return curve;
    const ExactSmith smith = fit.smith();
    curve.reserve(kTurn_deg + 1);
    for (int magnetic_deg = 0; magnetic_deg <= kTurn_deg; ++magnetic_deg) {
        double deviation_deg = deviationAt(smith, MagneticHeading::fromDegrees(magnetic_deg)).degrees();
        if (!curve.isEmpty()) // deviations near ±180 go on past it instead of jumping across the plot
            deviation_deg = curve.last().y() + wrap180(deviation_deg - curve.last().y());
        curve.append({static_cast<double>(magnetic_deg), deviation_deg});
    }
    return curve;
}

std::vector<BandPoint> confidenceBand(const ApproximateFit& fit)
{
    std::vector<BandPoint> band;
    for (const QPointF& point : approximateCurve(fit)) {
        const auto compass = CompassHeading::fromDegrees(point.x() - point.y());
        const auto halfWidth_rad = bandHalfWidth_rad(fit, compass);
        if (!halfWidth_rad)
            return {};
        const double halfWidth_deg = toDegrees(*halfWidth_rad);
        band.push_back({point.x(), point.y() - halfWidth_deg, point.y() + halfWidth_deg});
    }
    return band;
}

QPolygonF withinOneTurn(const QPolygonF& turn) { return cutToOneTurn(turn); }
std::vector<BandPoint> withinOneTurn(const std::vector<BandPoint>& turn) { return cutToOneTurn(turn); }

QPolygonF componentCurve(const ApproximateFit& fit, Coefficient which)
{
    QPolygonF curve;
    if (!fit.of(which))
        return curve;
    const ApproximateSmith smith = fit.smith();
    for (int compass_deg = 0; compass_deg <= kTurn_deg; ++compass_deg) {
        const double value_rad = component_rad(smith, which, CompassHeading::fromDegrees(compass_deg));
        curve.append({static_cast<double>(compass_deg), toDegrees(value_rad)});
    }
    return curve;
}

QPolygonF sumOfComponents(const ApproximateFit& fit)
{
    QPolygonF curve = approximateCurve(fit);
    for (QPointF& point : curve)
        point.setX(point.x() - point.y());
    return curve;
}

double residual_deg(const PlottedReading& reading, const ApproximateFit& fit)
{
    const Deviation fitted = deviationAt(fit.smith(), reading.compass);
    return wrap180(reading.deviation.degrees() - fitted.degrees());
}

NiceScale deviationScale(const SwingPicture& picture)
{
    double largest = std::max(maxAbsOfFits(picture.analysis.get()), maxAbsOfFits(picture.previous.get()));
    for (const PlottedReading& reading : picture.readings)
        largest = std::max(largest, std::abs(reading.deviation.degrees()) + picture.resolution_deg / 2);
    if (picture.limit_deg && (largest == 0 || *picture.limit_deg <= kLimitReach * largest))
        largest = std::max(largest, *picture.limit_deg);
    return niceScale(largest);
}

} // namespace lubberline::ui
