#pragma once
/// What pages about a sensor share: tables of a document in the window, and several numbers typed in one line.

#include <QString>

#include <optional>
#include <vector>

#include "ui/report/page/Table.h"

class QTableWidget;

namespace lubberline::ui {

/// To be read only.
[[nodiscard]] QTableWidget* testTable(const char* name, const QString& title);
/// A table of a document as one of the window.
void fillFrom(QTableWidget& widget, const Table& table);

/// "1, 2, 3", or with semicolons where the comma is in the numbers; none where there are not `count` numbers.
[[nodiscard]] std::optional<std::vector<double>> typedNumbers(const QString& text, std::size_t count);

} // namespace lubberline::ui
