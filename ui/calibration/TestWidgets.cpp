#include "ui/calibration/TestWidgets.h"

#include <QHeaderView>
#include <QTableWidget>

#include "ui/text/NumberText.h"

namespace lubberline::ui {

QTableWidget* testTable(const char* name, const QString& title)
{
    auto* table = new QTableWidget;
    table->setObjectName(QString::fromLatin1(name));
    table->setAccessibleName(title);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->verticalHeader()->hide();
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    return table;
}

void fillFrom(QTableWidget& widget, const Table& given)
{
    const Table table = inAngleStyle(given);
    widget.setColumnCount(static_cast<int>(table.columns.size()));
    QStringList heads;
    for (const TableColumn& column : table.columns) {
        QString head = column.head + (column.argument.isEmpty() ? QString() : QLatin1Char(' ') + column.argument);
        heads += column.unit.isEmpty() ? head : QStringLiteral("%1 (%2)").arg(head, column.unit);
    }
    widget.setHorizontalHeaderLabels(heads);
    widget.setRowCount(static_cast<int>(table.rows.size()));
    for (int row = 0; row < widget.rowCount(); ++row)
        for (int column = 0; column < widget.columnCount(); ++column) {
            const auto place = static_cast<std::size_t>(column);
            auto* item = new QTableWidgetItem(table.rows[static_cast<std::size_t>(row)].cells.value(column));
            item->setTextAlignment(
                Qt::AlignVCenter | (table.columns[place].align == TableColumn::Align::Left ? Qt::AlignLeft : Qt::AlignRight));
            widget.setItem(row, column, item);
        }
}

std::optional<std::vector<double>> typedNumbers(const QString& text, std::size_t count)
{
    std::vector<double> numbers;
    for (const QString& part : text.split(text.contains(u';') ? u';' : u',')) {
        const auto number = typedNumber(part);
        if (!number)
            return {};
        numbers.push_back(*number);
    }
    return numbers.size() == count ? std::optional(std::move(numbers)) : std::nullopt;
}

} // namespace lubberline::ui
