#pragma once
/// Private to the Swing CSV: rows of a spreadsheet that are no readings: units below the header, and what sums the readings up.

#include <string>
#include <vector>

#include "core/format/csv/SwingCsvColumns.h"

namespace lubberline::csv {

/// ",deg,deg": a unit of degrees in columns of angles, in the others words without a figure. Another unit (rad) is none of these.
[[nodiscard]] bool isUnitsRow(const std::vector<std::string>& cells, const Columns& columns);

struct SummaryRow {
    std::string word;        ///< "Mean", "Średnia", "Max. dev."; empty: no such row
    bool onlyInNote = false; ///< it may as well be said of a reading
};
[[nodiscard]] SummaryRow summaryRowOf(const std::vector<std::string>& cells, const Columns& columns);

} // namespace lubberline::csv
