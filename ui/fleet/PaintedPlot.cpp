#include "ui/fleet/PaintedPlot.h"

#include <QMouseEvent>
#include <QPainter>

namespace lubberline::ui {

PaintedPlot::PaintedPlot(const QString& name, Paint paint, QWidget* parent) : QWidget(parent), m_paint(std::move(paint))
{
    setObjectName(name);
    setMinimumSize(220, 160);
    setMouseTracking(true);
}

FleetLook PaintedPlot::look() const { return {font(), coloursFor(palette())}; }

void PaintedPlot::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const FleetLook how = look();
    painter.fillRect(rect(), how.colours.ground);
    m_paint(painter, plotRect(), how);
}

void PaintedPlot::mousePressEvent(QMouseEvent* event) { emit clicked(event->position()); }
void PaintedPlot::mouseMoveEvent(QMouseEvent* event) { emit hovered(event->position()); }

} // namespace lubberline::ui
