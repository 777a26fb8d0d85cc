#pragma once
/// Columns of tables: no heading and no figure is cut.

class QTableView;

namespace lubberline::ui {

/// Long headings stand in two or three lines. What a table has set of its header stays, but for the resize modes.
void wrapHeadings(QTableView& table);

/// Each column is as wide as its heading and what is seen of it, from now on, whatever comes into it. What is left of the table goes to the
/// last column where it stretches, else to all; where it is too narrow, the widest texts give way first, then the table scrolls.
void fitColumns(QTableView& table);

/// How high it is with so many rows, a heading in lines included.
[[nodiscard]] int heightOfRows(const QTableView& table, int rows);

/// For a table that sets its columns itself: fitColumns() does nothing then.
void keepOwnColumns(QTableView& table);

} // namespace lubberline::ui
