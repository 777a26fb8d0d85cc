#include "ui/plots/base/ChartMouse.h"

#include <QLabel>

#include <algorithm>
#include <cmath>

#include "ui/plots/base/CanvasMouse.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

constexpr int kBeside_px = 16, kMost_px = 280;

}

ChartMouse::ChartMouse(Chart* chart) : QObject(chart), m_chart(chart), m_beside(new QLabel(chart))
{
    m_beside->setObjectName(QStringLiteral("readOutBeside"));
    m_beside->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_beside->setFrameShape(QFrame::StyledPanel);
    m_beside->setAutoFillBackground(true);
    m_beside->setMargin(2);
    m_beside->setWordWrap(true);
    m_beside->setTextFormat(Qt::PlainText);
    m_beside->hide();
    for (QWidget* canvas : chart->canvases())
        watch(canvas);
}

void ChartMouse::watch(QWidget* canvas)
{
    auto* mouse = new CanvasMouse(canvas);
    connect(mouse, &CanvasMouse::hovered, this, [this, canvas](const QPointF& at) {
        const auto row = m_chart->rowNear({canvas, at});
        tell(row ? m_chart->readOutOfRow(*row) : m_chart->readOutAt({canvas, at}), canvas->mapTo(m_chart, at.toPoint()));
    });
    connect(mouse, &CanvasMouse::left, this, [this] { tell({}, {}); });
    connect(mouse, &CanvasMouse::clicked, this, [this, canvas](const QPointF& at) {
        emit pressed();
        emit clicked(canvas, at);
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

/// Right and below the pointer; on the other side where the plot ends.
void ChartMouse::tell(const QString& said, QPoint at)
{
    const QString text = inAngleStyle(said);
    emit readOut(text);
    m_beside->setText(text);
    m_beside->setVisible(!text.isEmpty());
    if (text.isEmpty())
        return;
    const int width = std::min({kMost_px, std::max(40, m_chart->width() - 4), m_beside->fontMetrics().horizontalAdvance(text) + 12});
    m_beside->resize(width, m_beside->heightForWidth(width));
    QPoint corner = at + QPoint(kBeside_px, kBeside_px);
    if (corner.x() + m_beside->width() > m_chart->width())
        corner.setX(std::max(0, at.x() - kBeside_px - m_beside->width()));
    if (corner.y() + m_beside->height() > m_chart->height())
        corner.setY(std::max(0, at.y() - kBeside_px - m_beside->height()));
    m_beside->move(corner);
    m_beside->raise();
}

void zoomMiddle(Chart& chart, double factor)
{
    const QWidget* canvas = chart.canvases().front();
    chart.zoomAt({canvas, QRectF(canvas->rect()).center()}, factor);
}

} // namespace lubberline::ui
