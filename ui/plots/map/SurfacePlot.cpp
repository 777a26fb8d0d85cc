#include "ui/plots/map/SurfacePlot.h"

#include <QPainter>

#include "ui/plots/map/OnPaper.h"
#include "ui/plots/map/SurfaceChart.h"

namespace lubberline::ui {

namespace {

constexpr double kKeyTurn_deg = 5;

} // namespace

SurfacePlot::SurfacePlot(QWidget* parent) : Plot(tr("Surface"), parent), m_chart(new SurfaceChart)
{
    adopt(m_chart);
    auto* mouse = new SurfaceMouse(m_chart);
    connect(mouse, &SurfaceMouse::pressed, this, [this] { setFocus(Qt::MouseFocusReason); });
    connect(mouse, &SurfaceMouse::readOut, this, &SurfacePlot::readOut);
}

void SurfacePlot::setPicture(const MapPicture& picture)
{
    m_picture = picture;
    m_stale = true;
    if (isVisible())
        refresh();
}

void SurfacePlot::refresh()
{
    if (m_stale)
        m_chart->setPicture(m_picture);
    m_stale = false;
}

void SurfacePlot::setView(const SurfaceView& view) { m_chart->setView(view); }
SurfaceView SurfacePlot::view() const { return m_chart->view(); }

bool SurfacePlot::step(int direction)
{
    const SurfaceView view = m_chart->view();
    m_chart->setView({view.azimuth_deg + direction * kKeyTurn_deg, view.elevation_deg});
    return true;
}

void SurfacePlot::render(QPainter& painter, const QRectF& target) const
{
    SurfaceChart paper;
    paper.takeView(*m_chart);
    paintOnPaper(paper, painter, target, m_picture);
}

void renderSurface(QPainter& painter, const QRectF& target, const MapPicture& picture, const SurfaceView& view)
{
    SurfaceChart paper;
    paper.setView(view);
    paintOnPaper(paper, painter, target, picture);
}

} // namespace lubberline::ui
