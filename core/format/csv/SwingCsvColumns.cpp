#include "core/format/csv/SwingCsvColumns.h"

#include <algorithm>
#include <iterator>

#include "core/angle/AngleText.h"
#include "core/base/FileText.h"
#include "core/format/csv/ColumnName.h"
#include "core/format/csv/RowSplitter.h"
#include "core/format/csv/TextCell.h"

namespace lubberline::csv {

namespace {

constexpr Pattern kExpectedColumns = MARKED("core",
    "two of magnetic_heading_deg, compass_heading_deg, deviation_deg "
    "(or true_heading_deg with a line \"# variation_deg: \u2026\" in place of the magnetic heading)");

std::optional<std::size_t> knownColumn(std::string_view name)
{
    // What spreadsheets call the two headings. A bare "deviation" is not among them: nobody said which side it is positive to.
    static constexpr std::array<std::pair<std::string_view, Column>, 9> kOtherNames{
        {{"magnetic_heading", Column::Magnetic}, {"magnetic_deg", Column::Magnetic}, {"compass_heading", Column::Compass},
            {"compass_deg", Column::Compass}, {"compass_reading", Column::Compass}, {"compass_reading_deg", Column::Compass},
            {"true_heading", Column::True}, {"pitch", Column::Pitch}, {"roll", Column::Roll}}};
    const std::string plain = columnKey(name);
    for (const auto& [other, column] : kOtherNames)
        if (plain == other)
            return static_cast<std::size_t>(column);
    const auto found = std::find(kColumnNames.begin(), kColumnNames.end(), plain);
    return found == kColumnNames.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - kColumnNames.begin()));
}

/// Each in quotes of its own: a mark without width in the last one is seen, too.
std::string listed(const std::vector<std::string>& names)
{
    constexpr std::size_t kMost = 12;
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i)
        text += (i == 0 ? "" : ", ") + inQuotes(names[i]);
    return text + (names.size() > kMost ? ", \u2026" : "");
}

bool looksLikeReadings(const std::vector<std::string>& cells)
{
    return std::all_of(cells.begin(), cells.end(),
        [](const std::string& cell) { return parseWrittenHeading(cell).ok() || parseSignedAngle_deg(cell).ok(); });
}

/// Magnetic, compass and deviation: two of them give the third.
Result<void> requireTwoOfThree(const Columns& columns, const std::vector<std::string>& header)
{
    const int given = (columns.has(Column::Magnetic) || columns.has(Column::True)) + columns.has(Column::Compass)
        + (columns.has(Column::Deviation) || columns.has(Column::IndicationError));
    if (given >= 2)
        return {};
    return Error{ErrorCode::InvalidInput, {MARKED("core", "a column is missing; expected %1, found %2"), kExpectedColumns, listed(header)}};
}

Result<void> addColumn(Columns& columns, std::size_t place, const std::string& name)
{
    const auto known = knownColumn(name);
    const bool doubled = known
        ? columns.place[*known].has_value()
        : std::any_of(columns.unknown.begin(), columns.unknown.end(), [&](const auto& other) { return other.second == name; });
    if (doubled)
        return Error{ErrorCode::InvalidInput, {MARKED("core", "the column %1 is there twice; expected each column once"), inQuotes(name)}};
    if (trimmed(name).empty())
        return Error{ErrorCode::Format, {MARKED("core", "column %1 has no name; expected a name for each column"), place + 1}};
    if (known)
        columns.place[*known] = place;
    else
        columns.unknown.emplace_back(place, name);
    return {};
}

} // namespace

char separatorOf(std::string_view header, char told)
{
    char best = told ? told : ',';
    std::ptrdiff_t most = -1;
    std::size_t mostCells = 0;
    for (const char separator : {told, ',', ';', '\t'}) {
        if (separator == 0)
            continue;
        RowSplitter splitter(separator);
        splitter.begin(header);
        const auto& cells = splitter.cells();
        const auto known = std::count_if(cells.begin(), cells.end(), [](const std::string& cell) { return knownColumn(cell).has_value(); });
        // Where none is known, the separator that separates is meant.
        if (known > most || (known == most && known == 0 && cells.size() > mostCells)) {
            best = separator;
            most = known;
            mostCells = cells.size();
        }
    }
    return best;
}

bool isTitle(const std::vector<std::string>& cells)
{
    const auto filled = [](const std::string& cell) { return !trimmed(cell).empty(); };
    std::vector<std::string> said;
    std::copy_if(cells.begin(), cells.end(), std::back_inserter(said), filled);
    return !looksLikeReadings(said)
        && std::none_of(said.begin(), said.end(), [](const auto& cell) { return knownColumn(textOfCell(cell)); });
}

Result<Columns> columnsOf(const std::vector<std::string>& cells)
{
    const auto end = std::find_if(cells.rbegin(), cells.rend(), [](const std::string& cell) { return !trimmed(cell).empty(); });
    const std::vector<std::string> header(cells.begin(), end.base());
    if (const auto few = checkColumns(header.size()); !few)
        return few.error();
    if (looksLikeReadings(header))
        return Error{ErrorCode::Format,
            {MARKED("core", "there is no header: the first row is numbers; expected a row of column names, %1"), kExpectedColumns}};
    Columns columns;
    columns.count = header.size();
    for (std::size_t place = 0; place < header.size(); ++place)
        if (const auto added = addColumn(columns, place, textOfCell(header[place])); !added)
            return added.error();
    if (const auto enough = requireTwoOfThree(columns, header); !enough)
        return enough.error();
    // By name, so that a file that is written and read again gives equal readings whatever their order of columns was.
    std::sort(columns.unknown.begin(), columns.unknown.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    return columns;
}

} // namespace lubberline::csv
