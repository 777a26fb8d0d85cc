#pragma once
/// Text in cells that spreadsheets open: no cell that we write begins a formula, and reading gives the text back as it was.
/// In front of a text that a spreadsheet would compute (its first sign, behind spaces, is = + - @ or one of their full-width forms, or it
/// begins with a tab or a line break) stands an apostrophe, the spreadsheets' own mark of a text; one more where the text has some.

#include <string>
#include <string_view>

namespace lubberline {

/// The text with its mark where it needs one.
[[nodiscard]] std::string withTextMark(std::string_view text);
/// The text of a cell that was read: without the mark.
[[nodiscard]] std::string textOfCell(std::string_view cell);

/// A cell of a CSV: with its mark, in quotes where it must be (separators, quotes, line breaks, spaces at the ends).
[[nodiscard]] std::string csvTextCell(std::string_view text);
/// In quotes, as RowSplitter reads it back.
[[nodiscard]] std::string csvQuoted(std::string_view text);

} // namespace lubberline
