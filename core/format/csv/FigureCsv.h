#pragma once
/// Tables of figures with named columns, one row after the other with constant memory, whatever the length: wind reports, legs, logs.
/// What spreadsheets write is taken: comma, semicolon or tab between cells, decimal commas where no comma parts cells or in quotes, "sep=;",
/// quotes, UTF-8 with or without BOM, any line end, blank lines, names of columns in any case and with spaces for underscores. Lines that
/// begin with # are comments. An empty cell, "nan", "na" and "null" are a missing figure.

#include <cstdint>
#include <istream>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/LineReader.h"
#include "core/base/Result.h"
#include "core/format/csv/RowSplitter.h"

namespace lubberline {

/// A figure whose column says its unit: "ground_speed" with "_kt" and "_m_s".
struct UnitSuffix {
    std::string_view suffix;
    double factor = 1; ///< to the unit that is wanted
};

/// Where a figure stands and by what it is multiplied.
struct FigureColumn {
    std::size_t place = 0;
    double factor = 1;
};

/// Of an aircraft, a flight or a leg: each is kept, however many rows there are.
inline constexpr std::size_t kLongestName = 200;

class FigureCsv {
public:
    /// @param expected what the file should be, for messages
    FigureCsv(std::istream& input, std::string name, Message expected, const Progress& progress);

    /// Reads up to the header. @param known names of columns by which the separator is told. Errors: Format (empty, binary, no header, a
    /// column twice), Io, Cancelled.
    Result<void> readHeader(std::span<const std::string_view> known);
    [[nodiscard]] const std::vector<std::string>& comments() const { return m_comments; } ///< lines above the header that begin with #
    [[nodiscard]] const std::vector<std::string>& columns() const { return m_columns; }   ///< in small letters, underscores for spaces
    [[nodiscard]] std::optional<std::size_t> column(std::string_view name) const;
    /// The one column of this name with one of the units. Errors: InvalidInput (two of them).
    Result<std::optional<FigureColumn>> column(std::string_view name, std::span<const UnitSuffix> units) const;

    /// The next row that is not empty; false at the end. Errors: Format (a row that is too long, an open quote, binary), Io, Cancelled.
    Result<bool> next();
    [[nodiscard]] std::string_view cell(std::size_t place) const { return place < m_cells.size() ? m_cells[place] : std::string_view(); }
    /// Of a cell; NaN where it is missing. False where it is no figure: error() says so.
    bool figure(std::size_t place, double& value) const
    {
        const std::string_view text = cell(place);
        return takePlain(text, value) || takeOther(text, value);
    }
    [[nodiscard]] bool isName(std::size_t place) const { return cell(place).size() <= kLongestName; }
    [[nodiscard]] Error noName(std::size_t place) const;   ///< of a cell that is none
    [[nodiscard]] Error noFigure(std::size_t place) const; ///< of a cell that figure() refused
    [[nodiscard]] Error here(const Message& message) const { return {ErrorCode::InvalidInput, message, m_name, m_line}; }
    [[nodiscard]] Error wholeFile(const Message& message) const { return {ErrorCode::Format, message, m_name}; }
    [[nodiscard]] std::int64_t line() const { return m_line; }
    [[nodiscard]] char separator() const { return m_separator; } ///< of cells

private:
    static bool takePlain(std::string_view text, double& value);
    bool takeOther(std::string_view text, double& value) const;
    Result<bool> nextLine();
    Result<void> split();
    void splitBare();

    LineReader m_lines;
    std::string m_name;
    Message m_expected;
    std::string m_text;
    std::vector<std::string> m_columns, m_comments;
    std::vector<std::uint32_t> m_ends; ///< of cells, where there are no quotes
    bool m_quoted = false;
    std::vector<std::string_view> m_cells;
    RowSplitter m_splitter{','};
    char m_separator = ',';
    std::int64_t m_line = 0;
};

} // namespace lubberline
