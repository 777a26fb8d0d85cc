#include "ui/plots/map/MapPlot.h"

#include <QPainter>

#include "ui/plots/base/ChartMouse.h"
#include "ui/plots/base/ChartOnPaper.h"
#include "ui/plots/map/MapChart.h"
#include "ui/plots/map/MapPlotRendering.h"
#include "ui/plots/map/OnPaper.h"

namespace lubberline::ui {

MapPlot::MapPlot(QWidget* parent) : Plot(tr("Map"), parent), m_chart(new MapChart)
{
    adopt(m_chart);
    watchMouse();
}

void MapPlot::setPicture(const MapPicture& picture)
{
    m_picture = picture;
    m_stale = true;
    if (isVisible())
        refresh();
}

void MapPlot::refresh()
{
    if (m_stale)
        m_chart->setPicture(m_picture);
    m_stale = false;
}

void MapPlot::render(QPainter& painter, const QRectF& target) const
{
    MapChart paper;
    paper.takeView(*m_chart);
    paintOnPaper(paper, painter, target, m_picture);
}

void renderMap(QPainter& painter, const QRectF& target, const MapPicture& picture)
{
    drawOnPaper(painter, target, [&picture](QPainter& sheet, const QRectF& room) {
        MapChart paper;
        paintOnPaper(paper, sheet, room, picture);
    });
}

} // namespace lubberline::ui
