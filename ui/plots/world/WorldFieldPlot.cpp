#include "ui/plots/world/WorldFieldPlot.h"

#include <QPainter>

#include "ui/plots/base/ChartMouse.h"
#include "ui/plots/world/WorldFieldChart.h"

namespace lubberline::ui {

WorldFieldPlot::WorldFieldPlot(QWidget* parent) : Plot(tr("World map"), parent), m_chart(new WorldFieldChart)
{
    adopt(m_chart);
    connect(watchMouse(), &ChartMouse::clicked, this, [this](const QWidget*, const QPointF& at) {
        if (const auto place = m_chart->placeAt(at))
            emit placeClicked(place->y(), place->x());
    });
}

void WorldFieldPlot::setGrid(std::shared_ptr<const FieldGrid> grid)
{
    m_grid = std::move(grid);
    m_chart->setGrid(m_grid);
}

void WorldFieldPlot::setPlace(const std::optional<Place>& place, const QString& label)
{
    m_place = place;
    m_label = label;
    m_chart->setPlace(place, label);
}

void WorldFieldPlot::render(QPainter& painter, const QRectF& target) const
{
    WorldFieldChart paper;
    paper.setFont(paperFont());
    paper.setColours(paperColours());
    paper.takeView(*m_chart);
    paper.setGrid(m_grid);
    paper.setPlace(m_place, m_label);
    paper.paint(painter, target);
}

} // namespace lubberline::ui
