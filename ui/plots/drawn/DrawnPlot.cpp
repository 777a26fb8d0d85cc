#include "ui/plots/drawn/DrawnPlot.h"

#include "ui/plots/base/ChartOnPaper.h"
#include "ui/plots/drawn/DrawnChart.h"

namespace lubberline::ui {

DrawnPlot::DrawnPlot(const QString& name, QSize least, QWidget* parent) : Plot(name, parent), m_chart(new DrawnChart(this)), m_least(least)
{
    adopt(m_chart);
    watchMouse();
}

void DrawnPlot::setPicture(DrawnPicture picture)
{
    m_picture = std::move(picture);
    m_chart->setPicture(m_picture);
}

void DrawnPlot::redraw() { canvas()->update(); }
QString DrawnPlot::textAt(const QPointF& at) const { return m_chart->readOutAt({canvas(), at}); }
QWidget* DrawnPlot::canvas() const { return m_chart->canvases().front(); }

void DrawnPlot::render(QPainter& painter, const QRectF& target) const
{
    DrawnChart paper;
    paper.setFont(paperFont());
    paper.setColours(paperColours());
    paper.setPicture(m_picture);
    paper.takeView(*m_chart);
    paper.paint(painter, target);
}

void renderDrawn(QPainter& painter, const QRectF& target, const DrawnPicture& picture)
{
    drawOnPaper(painter, target, [&picture](QPainter& sheet, const QRectF& room) {
        DrawnChart paper;
        paper.setFont(paperFont());
        paper.setColours(paperColours());
        paper.setPicture(picture);
        paper.paint(sheet, room);
    });
}

} // namespace lubberline::ui
