#pragma once
/// The calendar rules as a table that is edited in place; an empty row at its end makes a new one. Rules are data with a named
/// source.

#include <QWidget>

#include "db/stores/Stores.h"

class QPushButton;
class QTableWidget;

namespace lubberline::ui {

class DueRulesTable : public QWidget {
    Q_OBJECT

public:
    explicit DueRulesTable(db::Stores& stores, QWidget* parent = nullptr);
    void reload();

signals:
    void failed(const QString& message);

private:
    void fill();
    void takeCell(int row, int column);
    void remove();
    void addKnown(); ///< those whose source was read

    db::Stores& m_stores;
    std::vector<DueRule> m_rules;
    std::vector<std::pair<RecordId, std::string>> m_typeNames;
    QTableWidget* m_table;
    QPushButton* m_remove;
    QPushButton* m_known;
};

} // namespace lubberline::ui
