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

struct Row {
    Reading reading;
    std::optional<double> north_deg; ///< where the heading of the row is north: as it was written, 0 or 360
};

class RowReader {
public:
    RowReader(const Columns& columns, std::optional<double> variation_deg) : m_columns(columns), m_variation_deg(variation_deg) {}

    /// Headings and angles in every form of core/angle/AngleText.h. Cells that may be empty may be missing at the end, and empty ones may
    /// follow. Errors (without file and line): InvalidInput (number of cells; a cell, naming its column; a contradiction).
    Result<Row> read(const std::vector<std::string>& cells) const;
    /// The column by which the rows are listed: of magnetic, true and compass headings the first that there is.
    [[nodiscard]] Column listed() const;

private:
    struct Cells;
    Result<void> takeHeading(const std::vector<std::string>& cells, Column column, Cells& given) const;
    Result<void> takeAngle(const std::vector<std::string>& cells, Column column, Cells& given) const;
    Result<Cells> angles(const std::vector<std::string>& cells) const;
    Result<void> checkCount(const std::vector<std::string>& cells) const;
    Result<void> complete(Cells& given) const;
    Result<void> agree(const Cells& given) const;
    [[nodiscard]] std::string text(const std::vector<std::string>& cells, Column column) const;
    [[nodiscard]] bool required(Column column) const;

    const Columns& m_columns;
    std::optional<double> m_variation_deg;
};

} // namespace lubberline::csv
