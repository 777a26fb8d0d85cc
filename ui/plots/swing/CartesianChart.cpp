#include "ui/plots/swing/CartesianChart.h"

#include "ui/plots/base/CartesianPlot.h"
#include "ui/plots/swing/SwingChart.h"

namespace lubberline::ui {

CartesianChart::CartesianChart(QWidget* parent) : SwingChart(parent), m_plot(new CartesianPlot(this)) {}

std::vector<QWidget*> CartesianChart::canvases() const { return {m_plot->canvas()}; }
void CartesianChart::zoomInto(const QWidget*, const QRectF& rect) { m_plot->zoomInto(rect); }
void CartesianChart::zoomAt(const CanvasPlace& place, double factor) { m_plot->zoomAt(place.at, factor); }
void CartesianChart::panBy(const QWidget*, const QPointF& by) { m_plot->panBy(by); }
void CartesianChart::resetZoom() { m_plot->resetZoom(); }

void CartesianChart::takeView(const Chart& other)
{
    Chart::takeView(other);
    m_plot->takeView(*static_cast<const CartesianChart&>(other).m_plot);
}

void CartesianChart::styleItems() { m_plot->setLook(colours(), font()); }
void CartesianChart::layoutPlots(const QRect& rect) { m_plot->setGeometry(rect); }

void CartesianChart::paintPlots(QPainter& painter, const QRectF& device)
{
    m_plot->replot();
    m_plot->paintInto(painter, device);
}

void CartesianChart::replotAll() { m_plot->replot(); }

} // namespace lubberline::ui
