#include "ui/kit/TableEntry.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QTableWidget>

namespace lubberline::ui {

QTableWidgetItem* fixedCell(const QString& text)
{
    auto* item = new QTableWidgetItem(text);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    return item;
}

void KeepsTyped::setEditorData(QWidget* editor, const QModelIndex& index) const
{
    if (const auto* line = qobject_cast<const QLineEdit*>(editor); !line || !line->isModified())
        QStyledItemDelegate::setEditorData(editor, index);
}

EnterAdvances::EnterAdvances(QTableWidget& table, Order order) : KeepsTyped(&table), m_table(table), m_order(order)
{
    table.setItemDelegate(this);
    table.installEventFilter(this);
}

void EnterAdvances::advance()
{
    const int rows = m_table.rowCount(), columns = m_table.columnCount();
    int row = m_table.currentRow(), column = m_table.currentColumn();
    for (int step = 0; row >= 0 && step < rows * columns; ++step) {
        if (m_order == Order::AlongRows && ++column == columns) {
            column = 0;
            row = (row + 1) % rows;
        } else if (m_order == Order::DownColumns && ++row == rows) {
            row = 0;
            column = (column + 1) % columns;
        }
        const auto* model = m_table.model(); // an empty cell has no item, and can be typed into
        if (!m_table.isColumnHidden(column) && (model->flags(model->index(row, column)) & Qt::ItemIsEditable)) {
            m_table.setCurrentCell(row, column);
            return;
        }
    }
}

bool EnterAdvances::eventFilter(QObject* object, QEvent* event)
{
    const auto* key = event->type() == QEvent::KeyPress ? static_cast<QKeyEvent*>(event) : nullptr;
    const bool enter = key && (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter)
        && (key->modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
    if (object == &m_table) {
        if (enter)
            advance();
        return enter;
    }
    auto* editor = qobject_cast<QWidget*>(object);
    if (!enter || !editor)
        return QStyledItemDelegate::eventFilter(object, event);
    emit commitData(editor); // at once: a fast typist's next key must find the next cell
    emit closeEditor(editor, NoHint);
    advance();
    return true;
}

} // namespace lubberline::ui
