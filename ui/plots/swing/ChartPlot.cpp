#include "ui/plots/swing/ChartPlot.h"

#include <QPainter>

#include <algorithm>

#include "ui/plots/base/ChartMouse.h"
#include "ui/plots/swing/SwingChart.h"

namespace lubberline::ui {

ChartPlot::ChartPlot(const QString& name, MakeChart makeChart, QWidget* parent)
    : SwingPlot(name, parent)
    , m_makeChart(std::move(makeChart))
    , m_chart(m_makeChart().release())
{
    adopt(m_chart);
    connect(watchMouse(), &ChartMouse::picked, this, &ChartPlot::select);
}

void ChartPlot::setPicture(const SwingPicture& picture)
{
    m_picture = picture;
    m_stale = true;
    if (isVisible())
        refresh();
}

void ChartPlot::setSelectedRow(int row)
{
    m_selectedRow = row;
    if (isVisible())
        m_chart->setSelectedRow(row);
}

void ChartPlot::refresh()
{
    if (m_stale)
        m_chart->setPicture(m_picture);
    m_stale = false;
    m_chart->setSelectedRow(m_selectedRow);
}

void ChartPlot::render(QPainter& painter, const QRectF& target) const
{
    const std::unique_ptr<SwingChart> paper = m_makeChart();
    paper->takeView(*m_chart);
    renderChart(*paper, painter, target, m_picture);
}

void ChartPlot::select(int row)
{
    setSelectedRow(row);
    emit rowSelected(row);
}

/// The next reading round the compass, or the one before.
bool ChartPlot::step(int direction)
{
    std::vector<const PlottedReading*> round;
    for (const PlottedReading& reading : m_picture.readings)
        round.push_back(&reading);
    if (round.empty())
        return true;
    std::stable_sort(
        round.begin(), round.end(), [](const auto* a, const auto* b) { return a->magnetic.degrees() < b->magnetic.degrees(); });
    const auto now = std::find_if(round.begin(), round.end(), [this](const auto* r) { return r->row == m_selectedRow; });
    const int count = static_cast<int>(round.size());
    int next = direction > 0 ? 0 : count - 1;
    if (now != round.end())
        next = (static_cast<int>(now - round.begin()) + direction + count) % count;
    select(round[next]->row);
    emit readOut(m_chart->readOutOfRow(m_selectedRow));
    return true;
}

void renderChart(SwingChart& chart, QPainter& painter, const QRectF& target, const SwingPicture& picture)
{
    chart.setFont(paperFont());
    chart.setColours(paperColours());
    chart.setPicture(picture);
    chart.paint(painter, target);
}

} // namespace lubberline::ui
