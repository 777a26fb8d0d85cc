#pragma once
/// The curves of a swing as points, x: magnetic heading [deg], y: deviation [deg, east positive]. All values are finite.

#include <QPolygonF>

#include <vector>

#include "ui/plots/base/NiceScale.h"
#include "ui/plots/swing/SwingPicture.h"

namespace lubberline::ui {

struct BandPoint {
    double magnetic_deg = 0;
    double low_deg = 0;
    double high_deg = 0;
};

/// The approximate fit on every whole degree of compass heading ψ', at x = ψ' + δ(ψ'): one turn, x not wrapped, closed
/// (the last point is the first one, 360° on). Empty without a fit.
[[nodiscard]] QPolygonF approximateCurve(const ApproximateFit& fit);

/// The exact fit on every whole degree of magnetic heading 0…360. Empty without a fit.
[[nodiscard]] QPolygonF exactCurve(const ExactFit& fit);

/// The 95 % band of the approximate fit, placed as approximateCurve(). Empty without degrees of freedom.
[[nodiscard]] std::vector<BandPoint> confidenceBand(const ApproximateFit& fit);

/// What of a turn of approximateCurve() and its neighbours lies within 0…360, cut exactly at both ends.
[[nodiscard]] QPolygonF withinOneTurn(const QPolygonF& turn);
[[nodiscard]] std::vector<BandPoint> withinOneTurn(const std::vector<BandPoint>& turn);

/// One component of the approximate fit, or the sum of all, on every whole degree; x: compass heading 0…360 [deg].
[[nodiscard]] QPolygonF componentCurve(const ApproximateFit& fit, Coefficient which);
[[nodiscard]] QPolygonF sumOfComponents(const ApproximateFit& fit);

/// Deviation read − approximate fit at the compass heading read [deg], wrapped; for excluded readings too.
[[nodiscard]] double residual_deg(const PlottedReading& reading, const ApproximateFit& fit);

/// Symmetrical scale of deviation that holds readings with their bars, both fits and the previous swing. The limit is held
/// too unless it is so far out (beyond kLimitReach times the rest) that it would flatten everything else.
[[nodiscard]] NiceScale deviationScale(const SwingPicture& picture);
inline constexpr double kLimitReach = 3.0;

} // namespace lubberline::ui
