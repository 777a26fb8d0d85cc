#pragma once
/// Blocks of cells between the table of readings and a spreadsheet.

#include "core/record/NorthTwice.h"
#include "ui/kit/ClipboardRows.h"
#include "ui/swing/readings/ReadingText.h"

namespace lubberline::ui {

/// The figure of a cell as spreadsheets take it: degrees as a decimal number with the decimal sign of the desktop, a hyphen for minus. Text
/// has its mark where it would begin a formula.
[[nodiscard]] std::string figureCell(double value);
[[nodiscard]] std::string copiedCell(const Reading& reading, ReadingColumn column);

/// A block that was pasted, put into readings.
struct PastedBlock {
    std::vector<Reading> readings;          ///< all of the swing; new ones at the end have no id
    int rows = 0;                           ///< that the block has, without its headings
    bool passedOver = false;                ///< columns that are computed were in it
    NorthTwice north = NorthTwice::Settled; ///< whether it lists 000 and 360
};

/// @param rows  the block; a first row of headings (those of the table in either language, or of the Swing CSV) says which column is which,
///   otherwise they follow each other from `column` on.
/// @param row, column  where the block begins; what goes beyond the last reading becomes new readings.
/// Cells are taken as typed ones are (applyTyped), an empty one clears. A deviation beside a compass reading must agree with it to 0.05°.
/// Errors: InvalidInput, naming row and column: then nothing is put anywhere.
Result<PastedBlock> pasteBlock(
    std::vector<Reading> readings, int row, ReadingColumn column, CellRows rows, std::optional<double> variation_deg);

/// What the heading of a column is, in the reader's language.
[[nodiscard]] QString columnTitle(ReadingColumn column);

} // namespace lubberline::ui
