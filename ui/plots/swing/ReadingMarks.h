#pragma once
/// Readings as they are drawn in every plot: a point with its resolution bar; hollow and faint when excluded, ringed and
/// labelled when suspect, on a disc when selected.

#include <QFont>
#include <QPointF>
#include <QRectF>
#include <QString>

#include <functional>
#include <vector>

#include "ui/plots/base/PlotColours.h"
#include "ui/plots/swing/SwingPicture.h"

class QPainter;

namespace lubberline::ui {

/// A reading in the plot's own values.
struct ReadingPoint {
    int row = 0;
    double heading_deg = 0;
    double value_deg = 0; ///< deviation, or residual
    double bar_deg = 0;   ///< half the bar
    bool excluded = false;
    bool suspect = false;
    QString label; ///< of a suspect reading
};

/// The readings at their magnetic headings.
[[nodiscard]] std::vector<ReadingPoint> readingPoints(const SwingPicture& picture);

/// Where a heading [deg] and a value [deg] lie for the painter.
using Projection = std::function<QPointF(double heading_deg, double value_deg)>;

/// Where labels may stand.
struct LabelRoom {
    QRectF within;
    std::vector<QRectF> taken = {};
};

struct PlacedLabel {
    const ReadingPoint* point;
    QRectF place;
};

/// Labels of suspect readings keep clear of each other, of the points, and of what is taken; where nothing is free the ring stands alone.
[[nodiscard]] std::vector<PlacedLabel> placesOfLabels(
    const std::vector<const ReadingPoint*>& marks, const Projection& project, const LabelRoom& room, const QFont& font);

/// From so many on they are drawn as a density, beneath the curves, so that a fit is seen.
inline constexpr std::size_t kMostSeenApart = 150;
[[nodiscard]] inline double depthOf(std::size_t readings) { return readings > kMostSeenApart ? 8 : 30; }

/// With their labels; one that stands further off has a line to its point.
void paintReadings(QPainter& painter, const std::vector<ReadingPoint>& points, int selectedRow, const Projection& project,
    const LabelRoom& room, const PlotColours& colours, const QFont& font);

} // namespace lubberline::ui
