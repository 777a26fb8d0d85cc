#include "ui/plots/series/SeriesPlot.h"

#include "ui/plots/series/SeriesChart.h"

namespace lubberline::ui {

SeriesPlot::SeriesPlot(const QString& name, QWidget* parent) : Plot(name, parent), m_chart(new SeriesChart(this))
{
    adopt(m_chart);
    watchMouse();
}

void SeriesPlot::setPicture(SeriesPicture picture)
{
    m_picture = std::move(picture);
    m_chart->setPicture(m_picture);
}

SeriesPlot::Seen SeriesPlot::seen() const
{
    const QRectF view = m_chart->view();
    return {view.left(), view.right(), m_chart->zoomed()};
}

void SeriesPlot::render(QPainter& painter, const QRectF& target) const
{
    SeriesChart paper;
    paper.setFont(paperFont());
    paper.setColours(paperColours());
    paper.setPicture(m_picture);
    paper.takeView(*m_chart);
    paper.paint(painter, target);
}

} // namespace lubberline::ui
