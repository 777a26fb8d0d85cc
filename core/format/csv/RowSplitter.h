#pragma once
/// Cells of a CSV row (RFC 4180): a cell in double quotes may hold separators, "" for a quote, and line breaks.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/Result.h"

namespace lubberline {

/// "sep=;", with which a file tells Excel how its cells are parted; in quotes and with empty cells behind it where it was saved again.
/// @return the separator that such a line tells.
[[nodiscard]] std::optional<char> toldSeparator(std::string_view line);

/// More columns than this are no table of readings, and their names alone would take long to tell apart.
inline constexpr std::size_t kMostColumns = 1000;
/// Errors: Format (more than kMostColumns).
[[nodiscard]] Result<void> checkColumns(std::size_t columns);

class RowSplitter {
public:
    enum class State {
        Complete,
        Open,           ///< a quoted cell goes on in the next line
        TextAfterQuote, ///< `"a"b`: not a row
    };

    explicit RowSplitter(char separator) : m_separator(separator) {}

    State begin(std::string_view line);
    /// The next line, after Open. @param lineBreak that stood before it.
    State resume(std::string_view line, std::string_view lineBreak = "\n");

    /// Cells that were not quoted are without spaces at both ends. Valid until the next begin().
    [[nodiscard]] const std::vector<std::string>& cells() const { return m_cells; }
    [[nodiscard]] char separator() const { return m_separator; }
    [[nodiscard]] std::size_t bytes() const { return m_bytes; } ///< of the row so far

private:
    enum class Place { CellStart, Bare, Quoted, AfterQuote };

    State take(std::string_view line);
    State takeByte(char c);
    void endCell();

    char m_separator;
    Place m_place = Place::CellStart;
    std::string m_cell;
    std::vector<std::string> m_cells;
    std::size_t m_bytes = 0;
};

} // namespace lubberline
