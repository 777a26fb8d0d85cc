#include "ui/sensor/SensorMaps.h"

#include "ui/plots/map/MapPlot.h"
#include "ui/plots/map/SurfacePlot.h"
#include "ui/plots/swing/SwingPlot.h"

namespace lubberline::ui {

SensorMaps::SensorMaps(QWidget* parent) : QTabWidget(parent), m_map(new MapPlot), m_surface(new SurfacePlot), m_level(makeCurvePlot())
{
    setObjectName(QStringLiteral("sensorMaps"));
    setDocumentMode(true);
    add(m_map, tr("Ma&p"));
    add(m_surface, tr("S&urface"));
    add(m_level, tr("Level swin&g"));
    connect(this, &QTabWidget::currentChanged, this, &SensorMaps::catchUp);
}

void SensorMaps::add(Plot* plot, const QString& title)
{
    addTab(plot, title);
    connect(plot, &Plot::readOut, this, &SensorMaps::readOut);
    connect(plot, &Plot::failed, this, &SensorMaps::failed);
}

void SensorMaps::show(const std::optional<ModelView>& view, const QString& whyNothing)
{
    m_view = view;
    m_whyNothing = whyNothing;
    catchUp();
}

MapPicture SensorMaps::mapPicture() const
{
    if (m_view)
        return mapPictureOf(*m_view);
    MapPicture nothing;
    nothing.title = m_whyNothing;
    return nothing;
}

void SensorMaps::catchUp()
{
    if (currentWidget() == m_map)
        return m_map->setPicture(mapPicture());
    if (currentWidget() == m_surface)
        return m_surface->setPicture(mapPicture());
    SwingPicture nothing;
    nothing.whyNoAnalysis = m_whyNothing;
    m_level->setPicture(m_view ? levelSwingOf(*m_view) : nothing);
}

Plot& SensorMaps::front() const { return *static_cast<Plot*>(currentWidget()); }

} // namespace lubberline::ui
