#pragma once
/// Cells of a separated line, and numbers in them.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lubberline {

/// Tab where the line has one, else semicolon, else comma.
[[nodiscard]] char separatorOf(const std::string& line);

/// Splits at the separator; a cell may stand in double quotes, with "" for a quote inside. Cells are trimmed of spaces.
/// None when a quote is not closed.
[[nodiscard]] std::optional<std::vector<std::string>> splitCells(const std::string& line, char separator);

/// The cell in quotes when it needs them.
[[nodiscard]] std::string quoteCell(const std::string& cell);

/// A finite number with decimal point, or decimal comma where `commaToo`; whatever the locale.
[[nodiscard]] std::optional<double> parseNumber(std::string_view cell, bool commaToo);

/// The shortest text that reads back as the same number.
[[nodiscard]] std::string shortestText(double number);

[[nodiscard]] std::string trimmed(std::string_view text);

} // namespace lubberline
