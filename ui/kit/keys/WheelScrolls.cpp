#include "ui/kit/keys/WheelScrolls.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>

namespace lubberline::ui {

WheelScrolls::WheelScrolls(QObject* parent) : QObject(parent) { qApp->installEventFilter(this); }

bool WheelScrolls::eventFilter(QObject* object, QEvent* event)
{
    if (event->type() != QEvent::Wheel && event->type() != QEvent::Polish)
        return false;
    auto* widget = qobject_cast<QWidget*>(object);
    if (!qobject_cast<QComboBox*>(widget) && !qobject_cast<QAbstractSpinBox*>(widget))
        return false;
    if (event->type() == QEvent::Polish) {
        if (widget->focusPolicy() == Qt::WheelFocus)
            widget->setFocusPolicy(Qt::StrongFocus);
        return false;
    }
    event->ignore(); // it goes on to what stands around
    return true;
}

} // namespace lubberline::ui
