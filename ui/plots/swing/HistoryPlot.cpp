#include "ui/plots/swing/HistoryPlot.h"

#include "ui/plots/base/ChartMouse.h"
#include "ui/plots/swing/HistoryChart.h"

namespace lubberline::ui {

HistoryPlot::HistoryPlot(QWidget* parent) : Plot(tr("Coefficients over time"), parent), m_chart(new HistoryChart(this))
{
    adopt(m_chart);
    connect(watchMouse(), &ChartMouse::picked, this, &HistoryPlot::swingSelected);
}

void HistoryPlot::setHistory(const std::vector<HistoryPoint>& points, std::optional<double> limit_deg)
{
    m_points = points;
    m_limit_deg = limit_deg;
    m_chart->setHistory(points, limit_deg);
}

void HistoryPlot::render(QPainter& painter, const QRectF& target) const
{
    HistoryChart paper;
    paper.setFont(paperFont());
    paper.setColours(paperColours());
    paper.takeView(*m_chart);
    paper.setHistory(m_points, m_limit_deg);
    paper.paint(painter, target);
}

} // namespace lubberline::ui
