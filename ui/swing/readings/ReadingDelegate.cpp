#include "ui/swing/readings/ReadingDelegate.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPainter>

#include "ui/swing/readings/ReadingsModel.h"

namespace lubberline::ui {

namespace {

const QColor kRefused(0xC6, 0x28, 0x28);

}

QWidget* ReadingDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex& index) const
{
    auto* editor = new QLineEdit(parent);
    editor->setObjectName(QStringLiteral("readingEditor"));
    editor->setFrame(false);
    editor->setAlignment(Qt::Alignment(index.data(Qt::TextAlignmentRole).toInt()));
    return editor;
}

void ReadingDelegate::setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const
{
    const QString typed = static_cast<QLineEdit*>(editor)->text();
    // Enter on the grey nominal heading accepts it: what was visible becomes the reading.
    const bool accepts = typed.isEmpty() && index.data(ReadingsModel::PlaceholderRole).toBool() && editor->property("enter").toBool();
    model->setData(index, accepts ? QStringLiteral("=") : typed);
}

void ReadingDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    QStyleOptionViewItem look = option;
    look.font.setItalic(index.data(ReadingsModel::PlaceholderRole).toBool());
    if (index.data(ReadingsModel::RejectedRole).toBool()) {
        paintRefused(*painter, look, index);
        return;
    }
    QStyledItemDelegate::paint(painter, look, index);
}

/// The stored value keeps its place; what was typed stands before it in what room is left.
void ReadingDelegate::paintRefused(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    QStyleOptionViewItem background = option;
    initStyleOption(&background, index);
    background.text.clear();
    const QWidget* view = option.widget;
    (view ? view->style() : QApplication::style())->drawControl(QStyle::CE_ItemViewItem, &background, &painter, view);
    constexpr int kMargin_px = 4;
    QRect room = option.rect.adjusted(kMargin_px, 0, -kMargin_px, 0);
    const QString stored = index.data(ReadingsModel::StoredRole).toString();
    painter.save();
    painter.setClipRect(option.rect);
    painter.setFont(option.font);
    painter.setPen(option.palette.color(option.state & QStyle::State_Selected ? QPalette::HighlightedText : QPalette::Text));
    painter.drawText(room, Qt::AlignRight | Qt::AlignVCenter, stored);
    if (!stored.isEmpty())
        room.setRight(room.right() - option.fontMetrics.horizontalAdvance(stored) - kMargin_px);
    QFont struck = option.font;
    struck.setStrikeOut(!stored.isEmpty());
    painter.setFont(struck);
    painter.setPen(option.state & QStyle::State_Selected ? painter.pen().color() : kRefused);
    const QString typed = index.data().toString();
    painter.drawText(room, (stored.isEmpty() ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter,
        option.fontMetrics.elidedText(typed, Qt::ElideRight, room.width()));
    painter.setPen(QPen(kRefused, 2));
    painter.drawRect(QRectF(option.rect).adjusted(1, 1, -2, -2));
    painter.restore();
}

bool ReadingDelegate::eventFilter(QObject* object, QEvent* event)
{
    auto* editor = qobject_cast<QLineEdit*>(object);
    if (!editor || event->type() != QEvent::KeyPress)
        return QStyledItemDelegate::eventFilter(object, event);
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Escape) {
        emit closeEditor(editor, RevertModelCache);
        emit escaped();
        return true;
    }
    if (key != Qt::Key_Return && key != Qt::Key_Enter)
        return QStyledItemDelegate::eventFilter(object, event);
    // At once, not queued as Qt does: a fast typist's next key must find the next cell.
    editor->setProperty("enter", true);
    emit commitData(editor);
    emit closeEditor(editor, NoHint);
    emit entered();
    return true;
}

} // namespace lubberline::ui
