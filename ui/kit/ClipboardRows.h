#pragma once
/// Rows of cells as spreadsheets put them on the clipboard, and take them: tabs between cells (semicolons, where every line has as many and
/// begins with a figure, as in a CSV with decimal commas), a line for each row; a cell with a tab, a line break or a quote in it stands in
/// quotes. Beside that the rows are there as a table of HTML, for letters and mails.

#include <QString>

#include <string>
#include <vector>

#include "core/base/Result.h"

namespace lubberline::ui {

using CellRows = std::vector<std::vector<std::string>>;

/// Without the empty rows at the end; all rows have the cells of the longest. Errors: InvalidInput (a quote that is not closed, text behind
/// one, more rows than a table of ours can need).
Result<CellRows> rowsOfClipboard(const QString& text);

/// What is on the clipboard: its text, or the first table of its HTML where the text tells no columns. For rowsOfClipboard().
[[nodiscard]] QString clipboardRows();
/// @param text of clipboardText().
void putRowsOnClipboard(const QString& text);

/// Cells are as they are to be read, with their text marks (core/format/csv/TextCell.h).
[[nodiscard]] QString clipboardText(const CellRows& rows);

} // namespace lubberline::ui
