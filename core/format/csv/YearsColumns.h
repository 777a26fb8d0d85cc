#pragma once
/// Private to the table of years: what each of its columns is.

#include <optional>
#include <string>
#include <vector>

#include "core/format/csv/FigureCsv.h"
#include "core/format/csv/SwingCsvColumns.h"
#include "core/format/csv/YearsCsv.h"

namespace lubberline::csv {

struct HeadingColumn {
    std::size_t place = 0;
    double heading_deg = 0; ///< 0…360
    std::string text;       ///< the heading as a figure
};

struct KeyColumn {
    std::size_t place = 0;
    std::string key;
};

struct YearsColumns {
    std::vector<KeyColumn> keys;         ///< of the swing; of a row a swing also what means nothing here, which its note keeps
    std::vector<HeadingColumn> headings; ///< empty: a row a reading
    Columns reading;                     ///< of a row a reading by places of the table; of a row a swing by 0 (heading) and 1 (cell)
    std::vector<std::string> unknown;    ///< names of the columns that mean nothing here

    [[nodiscard]] bool rowIsSwing() const { return !headings.empty(); }
    [[nodiscard]] std::optional<std::size_t> of(std::string_view key) const;
};

/// Errors (without file and line): InvalidInput (a column that is not there, is meant twice, or is missing; what the cells are is not said).
Result<YearsColumns> yearsColumnsOf(const FigureCsv& csv, const YearsTable& table);

/// Names by which the separator of a table is found: those of the keys, of the table's own columns, and figures.
[[nodiscard]] std::vector<std::string> yearsNames(const YearsTable& table);

} // namespace lubberline::csv
