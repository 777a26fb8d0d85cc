#pragma once

#include <QPainter>
#include <QWidget>

#include <functional>

#include "ui/plots/base/PlotColours.h"

namespace lubberline::ui {

/// A picture that is drawn by a function, in the colours of the window.
class Painted : public QWidget {
public:
    using Paint = std::function<void(QPainter& painter, const QRectF& rect, const PlotColours& colours)>;
    explicit Painted(QSize least, QWidget* parent = nullptr) : QWidget(parent) { setMinimumSize(least); }
    void setPaint(Paint paint)
    {
        m_paint = std::move(paint);
        update();
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        const PlotColours colours = coloursFor(palette());
        painter.fillRect(rect(), colours.ground);
        if (m_paint)
            m_paint(painter, rect(), colours);
    }

private:
    Paint m_paint;
};

} // namespace lubberline::ui
