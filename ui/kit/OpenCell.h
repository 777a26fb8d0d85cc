#pragma once
/// The cell of a table that somebody types into. A table that is filled anew under it, because another window or program has stored
/// something, would give what is typed to another row.

#include <QAbstractItemDelegate>
#include <QAbstractItemView>

namespace lubberline::ui {

[[nodiscard]] inline bool cellIsOpen(const QAbstractItemView& view)
{
    struct Opened : QAbstractItemView {
        static bool in(const QAbstractItemView& view) { return (view.*(&Opened::state))() == EditingState; }
    };
    return Opened::in(view);
}

/// Where a cell is open, `fill` is called when it has been left, and what was typed stored.
/// @return whether it waits
template <class Object>
[[nodiscard]] bool waitsForCell(const QAbstractItemView& view, Object* object, void (Object::*fill)())
{
    if (!cellIsOpen(view))
        return false;
    QObject::connect(view.itemDelegate(), &QAbstractItemDelegate::closeEditor, object, fill,
        static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection));
    return true;
}

/// What is typed into it is given up.
inline void closeCell(const QAbstractItemView& view)
{
    if (QWidget* editor = cellIsOpen(view) ? view.indexWidget(view.currentIndex()) : nullptr)
        emit view.itemDelegate()->closeEditor(editor, QAbstractItemDelegate::RevertModelCache);
}

} // namespace lubberline::ui
