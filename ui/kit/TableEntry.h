#pragma once

#include <QStyledItemDelegate>

class QTableWidget;
class QTableWidgetItem;

namespace lubberline::ui {

/// A cell that can be chosen and copied, and not typed into.
[[nodiscard]] QTableWidgetItem* fixedCell(const QString& text);

/// What is being typed into a cell stays what was typed, whatever comes into the table under it: of another row, of another window.
class KeepsTyped : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;
    void setEditorData(QWidget* editor, const QModelIndex& index) const override;
};

/// Typing figures into a table, key by key: Enter stores what was typed and goes on to the next cell of the column that can be typed into,
/// and after the last to the first of the next such column; or likewise along rows, where a row is read at once.
class EnterAdvances final : public KeepsTyped {
    Q_OBJECT

public:
    enum class Order { DownColumns, AlongRows };
    explicit EnterAdvances(QTableWidget& table, Order order = Order::DownColumns);

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void advance();
    QTableWidget& m_table;
    Order m_order;
};

} // namespace lubberline::ui
