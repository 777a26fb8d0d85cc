#pragma once
/// Private to the Swing CSV: what each column of a file means.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/Result.h"

namespace lubberline::csv {

enum class Column { Magnetic, Compass, Deviation, IndicationError, True, Nominal, Pitch, Roll, Note, Excluded };
inline constexpr std::array<std::string_view, 10> kColumnNames{"magnetic_heading_deg", "compass_heading_deg", "deviation_deg",
    "indication_error_deg", "true_heading_deg", "nominal_deg", "pitch_deg", "roll_deg", "note", "excluded"};
[[nodiscard]] constexpr std::string_view nameOf(Column column) { return kColumnNames[static_cast<std::size_t>(column)]; }

struct Columns {
    std::size_t count = 0; ///< of the header, without the nameless columns at its end
    std::array<std::optional<std::size_t>, kColumnNames.size()> place;
    std::vector<std::pair<std::size_t, std::string>> unknown; ///< place and name

    [[nodiscard]] std::optional<std::size_t> of(Column column) const { return place[static_cast<std::size_t>(column)]; }
    [[nodiscard]] bool has(Column column) const { return of(column).has_value(); }
    /// True headings take the place of magnetic ones: the variation is needed.
    [[nodiscard]] bool trueIsDatum() const
    {
        const bool othersSuffice = has(Column::Compass) && (has(Column::Deviation) || has(Column::IndicationError));
        return has(Column::True) && !has(Column::Magnetic) && !othersSuffice;
    }
};

/// The separator under which most columns of the header are known. @param told by a line "sep=;", or 0.
[[nodiscard]] char separatorOf(std::string_view header, char told = 0);

/// A row above the header that says what the file is of: no cell names a column, and not all are figures.
[[nodiscard]] bool isTitle(const std::vector<std::string>& cells);

/// Names are known in any case, with spaces for underscores, and with the unit in brackets ("Compass heading [°]"). Columns without a name at the end are none: their cells are empty.
/// Errors (without file and line): Format (no header, a column without name), InvalidInput (missing or doubled columns).
Result<Columns> columnsOf(const std::vector<std::string>& header);

} // namespace lubberline::csv
