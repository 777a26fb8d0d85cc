#include "ui/sites/PasteTable.h"

#include <QKeyEvent>

namespace lubberline::ui {

bool PasteTable::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->matches(QKeySequence::Paste)) {
        event->accept();
        return true;
    }
    return QTableWidget::event(event);
}

void PasteTable::keyPressEvent(QKeyEvent* event)
{
    if (event->matches(QKeySequence::Paste))
        paste();
    else
        QTableWidget::keyPressEvent(event);
}

} // namespace lubberline::ui
