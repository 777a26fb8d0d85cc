#include "ui/bench/BenchTables.h"

#include <QHeaderView>
#include <QLineEdit>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QTableWidget>
#include <QVBoxLayout>

#include "ui/kit/fit/FlowLayout.h"

namespace lubberline::ui {

namespace {

QString textAt(const QTableWidget& table, int row, int column)
{
    const auto* item = table.item(row, column);
    return item ? item->text() : QString();
}

QStringList rowOf(const QTableWidget& table, int row)
{
    QStringList cells;
    for (int column = 0; column < table.columnCount(); ++column)
        cells << textAt(table, row, column);
    return cells;
}

std::vector<QStringList> rowsIn(const QTableWidget& table)
{
    std::vector<QStringList> rows;
    for (int row = 0; row < table.rowCount(); ++row)
        rows.push_back(rowOf(table, row));
    return rows;
}

void setRow(QTableWidget& table, int row, const QStringList& cells)
{
    for (int column = 0; column < table.columnCount(); ++column)
        table.setItem(row, column, new QTableWidgetItem(cells.value(column)));
}

void fill(QTableWidget& table, const std::vector<QStringList>& rows)
{
    table.setRowCount(static_cast<int>(rows.size()));
    for (int row = 0; row < table.rowCount(); ++row)
        setRow(table, row, rows[static_cast<std::size_t>(row)]);
    table.resizeColumnsToContents(); // once: following each cell, 10,000 parts would take minutes
}

} // namespace

BenchTables::BenchTables(QWidget* parent) : QWidget(parent), m_sensor(new QLineEdit)
{
    m_sensor->setObjectName(QStringLiteral("benchSensor"));
    connect(m_sensor, &QLineEdit::editingFinished, this, [this] {
        if (m_editable && m_sensor->isModified())
            emit changed();
    });
    m_parts = table("benchParts", partHeads());
    m_parts->setAccessibleName(tr("Ferrous parts"));
    m_conductors = table("benchConductors", conductorHeads());
    m_conductors->setAccessibleName(tr("Loops and wires"));
    m_active = m_parts;
    connect(m_parts, &QTableWidget::currentCellChanged, this, [this](int row) {
        if (!m_filling && row >= 0)
            emit partChosen(partAt(row));
    });
    auto* tools = new FlowLayout;
    tools->addWidget(labelled(tr("Sens&or x y z (m, forward, starboard, down):"), m_sensor));
    tools->addWidget(button(tr("Add part"), "benchAddPart", [this] { add(*m_parts, m_parts->rowCount(), {newPart()}); }));
    tools->addWidget(
        button(tr("Add conductor"), "benchAddConductor", [this] { add(*m_conductors, m_conductors->rowCount(), {newConductor()}); }));
    tools->addWidget(button(tr("Duplicate"), "benchDuplicate", [this] { duplicate(); }));
    tools->addWidget(button(tr("Remove row"), "benchRemove", [this] { remove(); }));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(tools);
    layout->addWidget(m_parts, 3);
    layout->addWidget(m_conductors, 2);
}

/// A cell or line in which somebody types is left when it goes: nobody is there any more to take it.
BenchTables::~BenchTables()
{
    for (QWidget* each : {static_cast<QWidget*>(m_sensor), static_cast<QWidget*>(m_parts), static_cast<QWidget*>(m_conductors)})
        each->disconnect(this);
}

QTableWidget* BenchTables::table(const char* name, const QStringList& heads)
{
    auto* made = new QTableWidget(0, static_cast<int>(heads.size()));
    made->setObjectName(QString::fromLatin1(name));
    made->setHorizontalHeaderLabels(heads);
    made->horizontalHeader()->setStretchLastSection(true);
    made->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    made->setTabKeyNavigation(false);
    connect(made, &QTableWidget::itemChanged, this, [this] {
        if (!m_filling && m_editable)
            emit changed();
    });
    connect(made, &QTableWidget::currentCellChanged, this, [this, made] { m_active = made; });
    connect(made, &QTableWidget::cellPressed, this, [this, made] { m_active = made; });
    return made;
}

QPushButton* BenchTables::button(const QString& text, const char* name, const std::function<void()>& act)
{
    auto* made = new QPushButton(text);
    made->setObjectName(QString::fromLatin1(name));
    connect(made, &QPushButton::clicked, this, act);
    m_buttons.push_back(made);
    return made;
}

void BenchTables::show(const BenchRows& rows, bool editable)
{
    const QScopedValueRollback quiet(m_filling, true);
    m_editable = editable;
    m_sensor->setText(rows.sensor);
    m_sensor->setReadOnly(!editable);
    fill(*m_parts, rows.parts);
    fill(*m_conductors, rows.conductors);
    for (auto* each : {m_parts, m_conductors})
        each->setEditTriggers(editable
                ? QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed | QAbstractItemView::AnyKeyPressed
                : QAbstractItemView::NoEditTriggers);
    for (auto* each : m_buttons)
        each->setEnabled(editable);
}

BenchRows BenchTables::rows() const { return {m_sensor->text(), rowsIn(*m_parts), rowsIn(*m_conductors)}; }

std::pair<int, int> BenchTables::blockAt(const QTableWidget& table, int row) const
{
    int first = row, end = row + 1;
    while (first > 0 && textAt(table, first, 0).isEmpty())
        --first;
    while (end < table.rowCount() && textAt(table, end, 0).isEmpty())
        ++end;
    return {first, end};
}

int BenchTables::partAt(int row) const
{
    int part = -1;
    for (int i = 0; i <= row; ++i)
        part += textAt(*m_parts, i, 0).isEmpty() ? 0 : 1;
    return part;
}

void BenchTables::selectPart(int part)
{
    int seen = -1;
    for (int row = 0; row < m_parts->rowCount(); ++row) {
        seen += textAt(*m_parts, row, 0).isEmpty() ? 0 : 1;
        if (seen == part)
            return m_parts->setCurrentCell(row, 0);
    }
}

void BenchTables::add(QTableWidget& table, int at, const std::vector<QStringList>& rows)
{
    {
        const QScopedValueRollback quiet(m_filling, true);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            table.insertRow(at + static_cast<int>(i));
            setRow(table, at + static_cast<int>(i), rows[i]);
        }
        table.resizeColumnsToContents();
    }
    table.setCurrentCell(at, 0);
    m_active = &table;
    emit changed();
}

/// A part with all its placements, a circuit with all its conductors.
void BenchTables::duplicate()
{
    if (m_active->currentRow() < 0)
        return;
    const auto [first, end] = blockAt(*m_active, m_active->currentRow());
    std::vector<QStringList> rows;
    for (int row = first; row < end; ++row)
        rows.push_back(rowOf(*m_active, row));
    rows.front().front() = tr("%1 (copy)").arg(rows.front().front());
    add(*m_active, end, rows);
}

/// The row; with its name goes the whole part or circuit.
void BenchTables::remove()
{
    const int row = m_active->currentRow();
    if (row < 0)
        return;
    const int end = textAt(*m_active, row, 0).isEmpty() ? row + 1 : blockAt(*m_active, row).second;
    {
        const QScopedValueRollback quiet(m_filling, true);
        m_active->model()->removeRows(row, end - row);
    }
    emit changed();
}

} // namespace lubberline::ui
