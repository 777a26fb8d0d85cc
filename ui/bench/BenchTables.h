#pragma once
/// The iron bench as tables that people type in: the sensor's place, parts, conductors; rows are added, duplicated and removed.

#include <QWidget>

#include <functional>

#include "ui/bench/BenchRows.h"

class QLineEdit;
class QPushButton;
class QTableWidget;

namespace lubberline::ui {

class BenchTables : public QWidget {
    Q_OBJECT

public:
    explicit BenchTables(QWidget* parent = nullptr);
    ~BenchTables() override;

    void show(const BenchRows& rows, bool editable);
    using QWidget::show;
    [[nodiscard]] BenchRows rows() const;
    void selectPart(int part); ///< its first row

signals:
    void changed(); ///< by the user
    void partChosen(int part);

private:
    QTableWidget* table(const char* name, const QStringList& heads);
    QPushButton* button(const QString& text, const char* name, const std::function<void()>& act);
    void add(QTableWidget& table, int at, const std::vector<QStringList>& rows);
    void duplicate();
    void remove();
    /// The named row and those without a name that go on with it: first and one past the last.
    [[nodiscard]] std::pair<int, int> blockAt(const QTableWidget& table, int row) const;
    [[nodiscard]] int partAt(int row) const;

    QLineEdit* m_sensor;
    QTableWidget *m_parts = nullptr, *m_conductors = nullptr;
    QTableWidget* m_active = nullptr; ///< the table that was used last: its row is removed or duplicated
    std::vector<QPushButton*> m_buttons;
    bool m_filling = false;
    bool m_editable = false;
};

} // namespace lubberline::ui
