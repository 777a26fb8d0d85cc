#include "ui/plots/base/ChartMouse.h"

#include <cmath>

#include "ui/plots/base/CanvasMouse.h"

namespace lubberline::ui {

ChartMouse::ChartMouse(Chart* chart) : QObject(chart), m_chart(chart)
{
    for (QWidget* canvas : chart->canvases())
        watch(canvas);
}

void ChartMouse::watch(QWidget* canvas)
{
    auto* mouse = new CanvasMouse(canvas);
    connect(mouse, &CanvasMouse::hovered, this, [this, canvas](const QPointF& at) {
        const auto row = m_chart->rowNear({canvas, at});
        emit readOut(row ? m_chart->readOutOfRow(*row) : m_chart->readOutAt({canvas, at}));
    });
    connect(mouse, &CanvasMouse::left, this, [this] { emit readOut({}); });
    connect(mouse, &CanvasMouse::clicked, this, [this, canvas](const QPointF& at) {
        emit pressed();
        if (const auto row = m_chart->rowNear({canvas, at}))
            emit picked(*row);
    });
    connect(mouse, &CanvasMouse::framed, this, [this, canvas](const QRectF& rect) { m_chart->zoomInto(canvas, rect); });
    connect(mouse, &CanvasMouse::panned, this, [this, canvas](const QPointF& by) { m_chart->panBy(canvas, by); });
    connect(mouse, &CanvasMouse::wheeled, this, [this, canvas](const QPointF& at, double steps) {
        m_chart->zoomAt({canvas, at}, std::pow(kZoomStep, steps));
    });
    connect(mouse, &CanvasMouse::doubleClicked, m_chart, [this] { m_chart->resetZoom(); });
}

void zoomMiddle(Chart& chart, double factor)
{
    const QWidget* canvas = chart.canvases().front();
    chart.zoomAt({canvas, QRectF(canvas->rect()).center()}, factor);
}

} // namespace lubberline::ui
