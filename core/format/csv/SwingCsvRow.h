#pragma once
/// Private to the Swing CSV: one row of cells to a reading.

#include <optional>
#include <string>
#include <vector>

#include "core/format/csv/SwingCsvColumns.h"
#include "core/record/Swing.h"

namespace lubberline::csv {

/// How far what a row says twice (magnetic, compass and deviation) may differ: a unit of the last figure of 0.1°, halved.
inline constexpr double kAgreement_deg = 0.05;

class RowReader {
public:
    RowReader(const Columns& columns, bool decimalComma, std::optional<double> variation_deg)
        : m_columns(columns)
        , m_decimalComma(decimalComma)
        , m_variation_deg(variation_deg)
    {
    }

    /// Errors (without file and line): InvalidInput (number of cells; a cell, naming its column; a contradiction).
    Result<Reading> read(const std::vector<std::string>& cells) const;

private:
    struct Cells;
    Result<std::optional<double>> angle(const std::vector<std::string>& cells, Column column) const;
    Result<Cells> angles(const std::vector<std::string>& cells) const;
    Result<void> complete(Cells& given) const;
    Result<void> agree(const Cells& given) const;
    [[nodiscard]] std::string text(const std::vector<std::string>& cells, Column column) const;
    [[nodiscard]] bool required(Column column) const;

    const Columns& m_columns;
    bool m_decimalComma;
    std::optional<double> m_variation_deg;
};

} // namespace lubberline::csv
