#pragma once
/// The axes of a drawn picture: a frame with a grid, its figures and titles, and where a value falls in it. Sized by the font.

#include <QFont>
#include <QPointF>
#include <QPolygonF>
#include <QRectF>
#include <QString>

#include "ui/plots/base/PlotColours.h"

class QPainter;

namespace lubberline::ui {

struct DrawnScale {
    double from = 0, to = 1; ///< of a logarithmic one both above 0
    QString title;           ///< with its unit
    bool logarithmic = false;
    bool withSign = false; ///< figures above 0 have a plus
    bool headings = false; ///< in steps of 45°
};

/// A scale of 1-2-5 steps around 0 that holds so much on either side.
[[nodiscard]] DrawnScale scaleAbout0(double most, double floor, QString title);
/// From 0 up, likewise.
[[nodiscard]] DrawnScale scaleFrom0(double most, double floor, QString title);
/// Whole decades that hold both (above 0).
[[nodiscard]] DrawnScale decades(double least, double most, QString title);

class DrawnAxes {
public:
    DrawnAxes(const QRectF& rect, const QFont& font, DrawnScale x, DrawnScale y);

    [[nodiscard]] const QRectF& inside() const { return m_inside; }
    [[nodiscard]] QPointF at(double x, double y) const;
    [[nodiscard]] QPointF valueAt(const QPointF& at) const;
    [[nodiscard]] bool contains(const QPointF& at) const { return m_inside.contains(at); }
    void paint(QPainter& painter, const PlotColours& colours) const;

private:
    void paintFigures(QPainter& painter, const PlotColours& colours, bool upright) const;

    QRectF m_rect;
    DrawnScale m_x, m_y;
    QRectF m_inside;
    double m_line;
    bool m_aboveAxis = false; ///< the upper title begins left of the axis
};

/// A pen for curves, as strong as the font's strokes.
[[nodiscard]] QPen curvePen(const QColor& colour, const QFont& font, double weight = 1.5, Qt::PenStyle style = Qt::SolidLine);

} // namespace lubberline::ui
