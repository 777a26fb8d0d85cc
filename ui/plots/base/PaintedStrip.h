#pragma once
/// A part of a chart that only paints.

#include <QPainter>
#include <QWidget>

#include <functional>
#include <utility>

namespace lubberline::ui {

class PaintedStrip : public QWidget {
public:
    using Paint = std::function<void(QPainter& painter, const QRectF& rect)>;
    PaintedStrip(Paint paint, QWidget* parent) : QWidget(parent), m_paint(std::move(paint)) {}

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        m_paint(painter, rect());
    }

private:
    Paint m_paint;
};

} // namespace lubberline::ui
