#pragma once
/// Contour lines with their labels in gaps of the lines, turned along them, upright, clear of each other and of what is taken.
/// All is cut by hand at the clip: SVG files know no clipping.

#include <QFont>
#include <QPen>
#include <QPolygonF>
#include <QRectF>
#include <QString>

#include <vector>

class QPainter;

namespace lubberline::ui {

struct ContourStroke {
    QPolygonF line; ///< units of the painter
    QPen pen;
    QString label; ///< empty: none
};

/// A label where it was put.
struct ContourLabel {
    QString text;
    QPointF at;            ///< middle
    double turned_deg = 0; ///< clockwise, within ±90
    QRectF box;            ///< that bounds it
};

/// Lines that come first get their labels first. `taken` grows by the labels. @return the labels drawn.
std::vector<ContourLabel> paintContours(
    QPainter& painter, const std::vector<ContourStroke>& strokes, const QRectF& clip, const QFont& font, std::vector<QRectF>& taken);

/// The parts of a line inside a rectangle.
[[nodiscard]] std::vector<QPolygonF> clippedLine(const QPolygonF& line, const QRectF& clip);

} // namespace lubberline::ui
