#pragma once
/// Axes of the fleet's drawings: a frame with a grid and its labels, and where a value falls in it.

#include <QPointF>
#include <QRectF>
#include <QString>

#include "ui/plots/fleet/FleetDrawing.h"

namespace lubberline::ui {

struct FleetAxes {
    QRectF room; ///< of the values
    double xFrom = 0, xTo = 360, yFrom = -1, yTo = 1, yStep = 1;

    [[nodiscard]] QPointF at(double x, double y) const
    {
        return {room.left() + room.width() * (x - xFrom) / (xTo - xFrom), room.bottom() - room.height() * (y - yFrom) / (yTo - yFrom)};
    }
};

[[nodiscard]] double lineHeight(const FleetLook& look);
/// A pen that is as thick as the font's strokes.
[[nodiscard]] QPen penOf(const QColor& colour, const FleetLook& look, double weight = 1, Qt::PenStyle style = Qt::SolidLine);

/// Headings below, degrees at the left. @param largest  of what is drawn [deg]
[[nodiscard]] FleetAxes headingAxes(const QRectF& rect, double largest_deg, const FleetLook& look);
void paintHeadingAxes(QPainter& painter, const FleetAxes& axes, const FleetLook& look);
/// Horizontal lines with their figures at the left.
void paintYGrid(QPainter& painter, const FleetAxes& axes, const FleetLook& look);

} // namespace lubberline::ui
