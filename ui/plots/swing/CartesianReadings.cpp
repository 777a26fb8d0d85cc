#include "ui/plots/swing/CartesianReadings.h"

#include <QPainter>

#include <qwt_scale_map.h>

namespace lubberline::ui {

CartesianReadings::CartesianReadings()
{
    setZ(30);
    setRenderHint(RenderAntialiased);
}

void CartesianReadings::setLook(const PlotColours& colours, const QFont& font)
{
    m_colours = colours;
    m_font = pixelFont(font);
}

void CartesianReadings::draw(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap, const QRectF& canvasRect) const
{
    const auto project
        = [&](double heading_deg, double value_deg) { return QPointF(xMap.transform(heading_deg), yMap.transform(value_deg)); };
    paintReadings(*painter, m_points, m_selectedRow, project, {canvasRect}, m_colours, m_font);
}

std::vector<Chart::RowPlace> rowPlaces(const CartesianPlot& plot, const CartesianReadings& readings)
{
    std::vector<Chart::RowPlace> places;
    for (const ReadingPoint& point : readings.points())
        places.push_back({point.row, plot.pixelOf({point.heading_deg, point.value_deg})});
    return places;
}

} // namespace lubberline::ui
