#include "ui/plots/map/SurfaceChart.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

#include "ui/plots/base/ChartMouse.h"
#include "ui/plots/base/PaintedStrip.h"
#include "ui/plots/map/MapText.h"

namespace lubberline::ui {

namespace {

constexpr int kScreenColumns = 181, kScreenRows = 91;
constexpr int kPaperColumns = 121, kPaperRows = 61; ///< finer ones make large files, no better pictures
constexpr double kLargestZoom = 8;
constexpr double kTurn_deg = 0.4; ///< a pixel of drag
constexpr double kNotch = 120;    ///< of a wheel, in eighths of a degree (QWheelEvent)

} // namespace

SurfaceChart::SurfaceChart(QWidget* parent)
    : MapViewChart(parent)
    , m_canvas(new PaintedStrip(
          [this](QPainter& painter, const QRectF& rect) { paintIn(painter, rect, font(), m_mesh.get(), m_turning || picture().coarse); },
          this))
{
    m_canvas->setObjectName("surfaceCanvas");
    m_canvas->setCursor(Qt::OpenHandCursor);
    m_canvas->setAttribute(Qt::WA_OpaquePaintEvent);
}

void SurfaceChart::setView(const SurfaceView& view)
{
    m_view = heldView(view);
    m_canvas->update();
}

void SurfaceChart::setTurning(bool turning)
{
    m_turning = turning;
    m_canvas->update();
}

void SurfaceChart::takePicture()
{
    m_mesh = cells() ? std::make_unique<const SurfaceMesh>(*cells(), scale().end, kScreenColumns, kScreenRows) : nullptr;
}

SurfaceProjection SurfaceChart::projectionIn(const QRectF& rect, const QFont& font) const
{
    const double units = rect.width() / std::max(1, m_canvas->width()); // a pan is kept on paper
    return {m_view, boxRoom(rect, font), m_zoom, m_moved * units};
}

void SurfaceChart::paintIn(QPainter& painter, const QRectF& rect, const QFont& font, const SurfaceMesh* mesh, bool turning) const
{
    painter.fillRect(rect, colours().ground);
    if (!mesh)
        return paintNotice(painter, rect, tr("There is no map yet."), colours(), font);
    paintSurface(painter, rect, picture(), *mesh, projectionIn(rect, font), {scale(), colours(), font, turning, rect});
}

QPointF SurfaceChart::pixelOf(const BoxPoint& point) const { return projectionIn(m_canvas->rect(), font())(point); }

QString SurfaceChart::readOutAt(const CanvasPlace& place) const
{
    if (!m_mesh)
        return {};
    const auto node = nodeAt(*m_mesh, projectionIn(m_canvas->rect(), font()), place.at);
    if (!node)
        return {};
    const BoxPoint at = m_mesh->node(node->x(), node->y()).at;
    const QRectF range = cells()->range_deg();
    const MapRequest& request = cells()->request();
    const double x_deg = std::lerp(request.x.range.from_deg, request.x.range.to_deg, (at.x + 1) / 2);
    const double y_deg = std::lerp(request.y.range.from_deg, request.y.range.to_deg, (at.y + 1) / 2);
    return range.isEmpty() ? QString() : mapReadOut(picture(), x_deg, y_deg, m_mesh->node(node->x(), node->y()).value_deg);
}

void SurfaceChart::zoomInto(const QWidget*, const QRectF& rect)
{
    const QPointF middle = QRectF(m_canvas->rect()).center();
    const double factor = std::max(rect.width() / m_canvas->width(), rect.height() / m_canvas->height());
    panBy(m_canvas, middle - rect.center());
    zoomAt({m_canvas, middle}, factor);
}

void SurfaceChart::zoomAt(const CanvasPlace& place, double factor)
{
    const double zoom = std::clamp(m_zoom / factor, 1.0, kLargestZoom);
    const QPointF origin = boxRoom(m_canvas->rect(), font()).center();
    m_moved = zoom == 1 ? QPointF() : place.at - origin - (place.at - origin - m_moved) * zoom / m_zoom;
    m_zoom = zoom;
    m_canvas->update();
}

void SurfaceChart::panBy(const QWidget*, const QPointF& by)
{
    m_moved += by;
    m_canvas->update();
}

void SurfaceChart::resetZoom()
{
    m_zoom = 1;
    m_moved = {};
    setView({});
}

void SurfaceChart::takeView(const Chart& other)
{
    Chart::takeView(other);
    const auto& surface = static_cast<const SurfaceChart&>(other);
    m_view = surface.m_view;
    m_zoom = surface.m_zoom;
    m_moved = surface.m_moved;
    m_canvas->resize(surface.m_canvas->size());
}

void SurfaceChart::styleItems()
{
    MapViewChart::styleItems();
    m_canvas->update();
}

void SurfaceChart::layoutBody(const QRect& rect) { m_canvas->setGeometry(rect); }

void SurfaceChart::paintBody(QPainter& painter, const QRectF& device, double scale)
{
    std::unique_ptr<const SurfaceMesh> mesh;
    if (cells())
        mesh = std::make_unique<const SurfaceMesh>(*cells(), this->scale().end, kPaperColumns, kPaperRows);
    painter.save();
    painter.translate(device.topLeft());
    painter.scale(scale, scale);
    paintIn(painter, QRectF(QPointF(), device.size() / scale), pixelFont(font()), mesh.get(), false);
    painter.restore();
}

void SurfaceChart::replotAll() { m_canvas->update(); }

SurfaceMouse::SurfaceMouse(SurfaceChart* chart) : QObject(chart), m_chart(chart)
{
    QWidget* canvas = chart->canvases().front();
    canvas->setMouseTracking(true);
    canvas->installEventFilter(this);
}

void SurfaceMouse::drag(QPointF to)
{
    const QPointF by = to - m_from;
    m_from = to;
    if (m_button == Qt::MiddleButton)
        return m_chart->panBy(nullptr, by);
    const SurfaceView view = m_chart->view();
    m_chart->setView({view.azimuth_deg - kTurn_deg * by.x(), view.elevation_deg + kTurn_deg * by.y()});
}

bool SurfaceMouse::eventFilter(QObject* watched, QEvent* event)
{
    const CanvasPlace under{static_cast<const QWidget*>(watched), m_from};
    switch (event->type()) {
    case QEvent::MouseButtonPress:
        m_button = static_cast<QMouseEvent*>(event)->button();
        m_from = static_cast<QMouseEvent*>(event)->position();
        m_chart->setTurning(m_button == Qt::LeftButton || m_button == Qt::MiddleButton);
        emit pressed();
        return false;
    case QEvent::MouseMove: {
        const QPointF at = static_cast<QMouseEvent*>(event)->position();
        if (m_button == Qt::LeftButton || m_button == Qt::MiddleButton)
            drag(at);
        else
            emit readOut(m_chart->readOutAt({under.canvas, at}));
        return false;
    }
    case QEvent::MouseButtonRelease:
        m_button = Qt::NoButton;
        m_chart->setTurning(false);
        return false;
    case QEvent::MouseButtonDblClick: m_chart->resetZoom(); return true;
    case QEvent::Wheel: {
        auto& wheel = static_cast<QWheelEvent&>(*event);
        m_chart->zoomAt({under.canvas, wheel.position()}, std::pow(kZoomStep, wheel.angleDelta().y() / kNotch));
        wheel.accept(); // or the page would scroll as well
        return true;
    }
    case QEvent::Leave: emit readOut({}); return false;
    default: return QObject::eventFilter(watched, event);
    }
}

} // namespace lubberline::ui
