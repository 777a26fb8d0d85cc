#include "ui/plots/base/CanvasMouse.h"

#include <QApplication>
#include <QMouseEvent>
#include <QRubberBand>
#include <QWheelEvent>

namespace lubberline::ui {

namespace {

constexpr double kWheelStep = 120; ///< of a common wheel's notch, in eighths of a degree (QWheelEvent)

bool isFrame(const QRectF& rect)
{
    // Smaller ones are a shaking hand.
    return rect.width() >= 12 && rect.height() >= 12;
}

} // namespace

CanvasMouse::CanvasMouse(QWidget* canvas) : QObject(canvas), m_canvas(canvas), m_frame(new QRubberBand(QRubberBand::Rectangle, canvas))
{
    canvas->setMouseTracking(true);
    canvas->installEventFilter(this);
}

bool CanvasMouse::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::MouseButtonPress: press(static_cast<QMouseEvent&>(*event)); return false;
    case QEvent::MouseMove: move(static_cast<QMouseEvent&>(*event)); return false;
    case QEvent::MouseButtonRelease: release(static_cast<QMouseEvent&>(*event)); return false;
    case QEvent::MouseButtonDblClick:
        m_wasDoubleClick = true;
        if (static_cast<QMouseEvent&>(*event).button() == Qt::LeftButton)
            emit doubleClicked();
        return true;
    case QEvent::Wheel: {
        auto& wheel = static_cast<QWheelEvent&>(*event);
        emit wheeled(wheel.position(), wheel.angleDelta().y() / kWheelStep);
        wheel.accept(); // or the page would scroll as well
        return true;
    }
    case QEvent::Leave: emit left(); return false;
    default: return QObject::eventFilter(watched, event);
    }
}

void CanvasMouse::press(const QMouseEvent& event)
{
    m_wasDoubleClick = false;
    m_pressedAt = m_pannedFrom = event.position();
    m_framing = event.button() == Qt::LeftButton;
    m_panning = event.button() == Qt::MiddleButton;
}

void CanvasMouse::move(const QMouseEvent& event)
{
    if (m_framing) {
        const QRectF rect = QRectF(m_pressedAt, event.position()).normalized();
        m_frame->setGeometry(rect.toRect());
        m_frame->setVisible(isFrame(rect));
    }
    if (m_panning) {
        emit panned(event.position() - m_pannedFrom);
        m_pannedFrom = event.position();
    }
    emit hovered(event.position());
}

void CanvasMouse::release(const QMouseEvent& event)
{
    const bool framing = m_framing && event.button() == Qt::LeftButton && !m_wasDoubleClick;
    m_frame->hide();
    m_framing = m_panning = false;
    if (!framing)
        return;
    const QRectF rect = QRectF(m_pressedAt, event.position()).normalized().intersected(m_canvas->rect());
    if (isFrame(rect))
        emit framed(rect);
    else if ((event.position() - m_pressedAt).manhattanLength() < QApplication::startDragDistance())
        emit clicked(event.position());
}

} // namespace lubberline::ui
