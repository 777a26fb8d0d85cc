#include "ui/kit/PlaySlider.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <utility>

namespace lubberline::ui {

void PlaySlider::mousePressEvent(QMouseEvent* event)
{
    m_fineFrom_px = event->position().toPoint().x();
    QSlider::mousePressEvent(event);
}

void PlaySlider::mouseMoveEvent(QMouseEvent* event)
{
    const int at_px = event->position().toPoint().x();
    const int moved = at_px - std::exchange(m_fineFrom_px, at_px);
    if (!(event->modifiers() & Qt::ShiftModifier))
        QSlider::mouseMoveEvent(event);
    else if (moved != 0)
        emit stepped(moved, false);
}

void PlaySlider::mouseDoubleClickEvent(QMouseEvent*) { emit resetWanted(); }

void PlaySlider::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Down: emit stepped(-1, false); break;
    case Qt::Key_Right:
    case Qt::Key_Up: emit stepped(1, false); break;
    case Qt::Key_PageDown: emit stepped(-1, true); break;
    case Qt::Key_PageUp: emit stepped(1, true); break;
    default: QSlider::keyPressEvent(event);
    }
}

void PlaySlider::mouseReleaseEvent(QMouseEvent* event)
{
    QSlider::mouseReleaseEvent(event);
    emit letGo();
}

void PlaySlider::keyReleaseEvent(QKeyEvent* event)
{
    QSlider::keyReleaseEvent(event);
    if (!event->isAutoRepeat())
        emit letGo();
}

void PlaySlider::focusOutEvent(QFocusEvent* event)
{
    QSlider::focusOutEvent(event);
    emit letGo();
}

void PlaySlider::wheelEvent(QWheelEvent* event) { event->ignore(); }

} // namespace lubberline::ui
