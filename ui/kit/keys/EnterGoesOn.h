#pragma once
/// Enter goes on to the next field of a form from its choices, too, as from its lines.

#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>

namespace lubberline::ui {

class EnterGoesOn final : public QObject {
public:
    explicit EnterGoesOn(QComboBox& box) : QObject(&box) { box.installEventFilter(this); }

protected:
    bool eventFilter(QObject* box, QEvent* event) override
    {
        if (event->type() != QEvent::KeyPress)
            return false;
        const auto* key = static_cast<QKeyEvent*>(event);
        if ((key->key() != Qt::Key_Return && key->key() != Qt::Key_Enter) || (key->modifiers() & ~Qt::KeypadModifier) != Qt::NoModifier)
            return false;
        QKeyEvent tab(QEvent::KeyPress, Qt::Key_Tab, Qt::NoModifier);
        QApplication::sendEvent(box, &tab);
        return true;
    }
};

} // namespace lubberline::ui
