#pragma once

#include <QStyledItemDelegate>

class QTableWidget;
class QTableWidgetItem;

namespace lubberline::ui {

/// A cell that can be chosen and copied, and not typed into.
[[nodiscard]] QTableWidgetItem* fixedCell(const QString& text);

/// Typing figures into a table, key by key: Enter stores what was typed and goes on to the next cell of the column that can be typed into,
/// and after the last to the first of the next such column.
class EnterAdvances final : public QStyledItemDelegate {
    Q_OBJECT

public:
    explicit EnterAdvances(QTableWidget& table);

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void advance();
    QTableWidget& m_table;
};

} // namespace lubberline::ui
