#pragma once
/// The calendar rules as a table that is edited in place; an empty row at its end makes a new one. Rules are data with a named
/// source.

#include <QWidget>

#include <optional>

#include "ui/kit/EditContext.h"

class QPushButton;
class QTableWidget;
class QUndoStack;

namespace lubberline::ui {

class DueRulesTable : public QWidget {
    Q_OBJECT

public:
    DueRulesTable(EditContext& context, QUndoStack& undo, QWidget* parent = nullptr);
    void reload();

signals:
    void failed(const QString& message);

private:
    void fill();
    void takeCell(int row, int column);
    void remove();
    void addKnown(); ///< those whose source was read

    /// Made, changed or removed, so that it can be undone.
    void edit(std::optional<DueRule> before, std::optional<DueRule> after, const QString& text);

    EditContext& m_context;
    db::Stores& m_stores;
    QUndoStack& m_undo;
    std::vector<DueRule> m_rules;
    std::vector<std::pair<RecordId, std::string>> m_typeNames;
    QTableWidget* m_table;
    QPushButton* m_remove;
    QPushButton* m_known;
};

} // namespace lubberline::ui
