#pragma once
/// A drawn picture with the manners of every plot: read-out, copy, export, legend. It has no zoom.

#include "ui/plots/base/Plot.h"
#include "ui/plots/drawn/DrawnPicture.h"

namespace lubberline::ui {

class DrawnChart;

class DrawnPlot : public Plot {
    Q_OBJECT

public:
    explicit DrawnPlot(const QString& name, QSize least = {220, 160}, QWidget* parent = nullptr);
    void setPicture(DrawnPicture picture);
    void redraw();                                         ///< what the picture's functions look at has changed
    [[nodiscard]] QString textAt(const QPointF& at) const; ///< read-out at a place of the canvas
    [[nodiscard]] QWidget* canvas() const;
    [[nodiscard]] QSize minimumSizeHint() const override { return m_least; }
    void render(QPainter& painter, const QRectF& target) const override;

private:
    DrawnChart* m_chart;
    DrawnPicture m_picture;
    QSize m_least;
};

} // namespace lubberline::ui
