#pragma once
/// A widget that is painted by a function, as the same figure is on paper, and tells where it is clicked and hovered over.

#include <QWidget>

#include <functional>

#include "ui/plots/fleet/FleetDrawing.h"

namespace lubberline::ui {

class PaintedPlot : public QWidget {
    Q_OBJECT

public:
    using Paint = std::function<void(QPainter& painter, const QRectF& rect, const FleetLook& look)>;
    PaintedPlot(const QString& name, Paint paint, QWidget* parent = nullptr);
    [[nodiscard]] FleetLook look() const;
    [[nodiscard]] QRectF plotRect() const { return rect(); }
    [[nodiscard]] QSize sizeHint() const override { return {420, 320}; }

signals:
    void clicked(const QPointF& at);
    void hovered(const QPointF& at);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

private:
    Paint m_paint;
};

} // namespace lubberline::ui
