#include "core/format/csv/YearsColumns.h"

#include <algorithm>
#include <array>

#include "core/base/FileText.h"
#include "core/base/Number.h"
#include "core/format/csv/SwingCsvKeys.h"

namespace lubberline {

namespace csv {

namespace {

constexpr std::string_view kSwingKey = "swing"; ///< only tells swings apart

std::string yearsColumnText(std::string_view name)
{
    std::string text = inSmallLetters(trimmed(name));
    std::replace(text.begin(), text.end(), ' ', '_');
    return text;
}

std::optional<Column> readingColumn(std::string_view name)
{
    const auto found = std::find(kColumnNames.begin(), kColumnNames.end(), name);
    if (found == kColumnNames.end())
        return {};
    return static_cast<Column>(found - kColumnNames.begin());
}

bool isYearsKey(std::string_view name) { return name == kSwingKey || isKey(name); }

/// What the column at each place of the table is meant to be: the key, or the name that it has.
Result<std::vector<std::string>> meanings(const FigureCsv& csv, const YearsTable& table)
{
    std::vector<std::string> meant = csv.columns();
    std::vector<bool> told(meant.size(), false);
    for (const auto& [key, name] : table.columns) {
        if (!isYearsKey(key) && !readingColumn(key))
            return Error{ErrorCode::InvalidInput, {MARKED("core", "%1 is not known; expected one of %2"), inQuotes(key), [] {
                                                       std::string all;
                                                       for (const auto& each : yearsKeys())
                                                           all += (all.empty() ? "" : ", ") + each;
                                                       return all;
                                                   }()}};
        const auto place = csv.column(yearsColumnText(name));
        if (!place)
            return Error{ErrorCode::InvalidInput, {MARKED("core", "there is no column %1, which should be %2"), inQuotes(name), key}};
        if (told[*place])
            return Error{
                ErrorCode::InvalidInput, {MARKED("core", "the column %1 is meant to be two things; expected one"), inQuotes(name)}};
        told[*place] = true;
        meant[*place] = key;
    }
    for (const auto& [key, name] : table.columns) // a column that has the key's name and is another one keeps its name as a text
        for (std::size_t place = 0; place < meant.size(); ++place)
            if (!told[place] && meant[place] == key)
                meant[place] += "_";
    return meant;
}

Result<void> checkHeadings(const std::vector<HeadingColumn>& headings)
{
    for (std::size_t i = 0; i < headings.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (headings[i].heading_deg == headings[j].heading_deg)
                return Error{ErrorCode::InvalidInput,
                    {MARKED("core", "two columns are of the heading %1; expected each heading once"), headings[i].text}};
    return {};
}

Result<void> describeCells(YearsColumns& columns, const YearsTable& table)
{
    if (!table.cells)
        return Error{ErrorCode::InvalidInput,
            {MARKED("core",
                 "headings are columns (%1 \u2026), and what stands in their cells is not said; expected it to be said: compass headings read, deviations (magnetic - compass), indication errors (compass - magnetic), or magnetic headings"),
                columns.headings.front().text}};
    const bool same
        = (*table.cells == YearsCells::Compass && table.byCompass) || (*table.cells == YearsCells::Magnetic && !table.byCompass);
    if (same)
        return Error{ErrorCode::InvalidInput,
            table.byCompass ? MARKED("core", "columns and cells are both compass headings; expected the others in one of the two")
                            : MARKED("core", "columns and cells are both magnetic headings; expected the others in one of the two")};
    static constexpr std::array kOfCells{Column::Compass, Column::Magnetic, Column::Deviation, Column::IndicationError};
    columns.reading.count = 2;
    columns.reading.place[static_cast<std::size_t>(table.byCompass ? Column::Compass : Column::Magnetic)] = 0;
    columns.reading.place[static_cast<std::size_t>(kOfCells[static_cast<std::size_t>(*table.cells)])] = 1;
    return checkHeadings(columns.headings);
}

Result<void> checkReading(const Columns& reading)
{
    const int given = (reading.has(Column::Magnetic) || reading.has(Column::True)) + reading.has(Column::Compass)
        + (reading.has(Column::Deviation) || reading.has(Column::IndicationError));
    if (given >= 2)
        return {};
    return Error{ErrorCode::InvalidInput,
        MARKED("core",
            "neither headings as columns nor two of magnetic_heading_deg, compass_heading_deg and deviation_deg are there; expected a row a swing or a row a reading")};
}

} // namespace

std::optional<std::size_t> YearsColumns::of(std::string_view key) const
{
    const auto found = std::ranges::find(keys, key, &KeyColumn::key);
    return found == keys.end() ? std::nullopt : std::optional(found->place);
}

std::vector<std::string> yearsNames(const YearsTable& table)
{
    std::vector<std::string> names = yearsKeys();
    for (const auto& [key, name] : table.columns)
        names.push_back(yearsColumnText(name));
    for (char digit = '0'; digit <= '9'; ++digit)
        names.emplace_back(1, digit);
    return names;
}

Result<YearsColumns> yearsColumnsOf(const FigureCsv& csv, const YearsTable& table)
{
    const auto meant = meanings(csv, table);
    if (!meant)
        return meant.error();
    YearsColumns columns;
    columns.reading.count = meant->size();
    std::vector<KeyColumn> unknown;
    for (std::size_t place = 0; place < meant->size(); ++place) {
        const std::string& name = (*meant)[place];
        if (name.empty())
            return Error{ErrorCode::Format, {MARKED("core", "column %1 has no name; expected a name for each column"), place + 1}};
        if (const auto heading = headingOfColumn(name))
            columns.headings.push_back({place, *heading, shortestNumber(*heading)});
        else if (const auto column = readingColumn(name); column && name != "note")
            columns.reading.place[static_cast<std::size_t>(*column)] = place;
        else if (isYearsKey(name))
            columns.keys.push_back({place, name});
        else
            unknown.push_back({place, name});
    }
    for (const auto& [place, name] : unknown)
        columns.unknown.push_back(name);
    if (columns.rowIsSwing()) {
        const bool both = std::ranges::any_of(columns.reading.place, [](const auto& place) { return place.has_value(); });
        if (both)
            return Error{ErrorCode::InvalidInput,
                MARKED("core",
                    "headings are columns, and columns of single readings are there too; expected a row a swing or a row a reading")};
        std::ranges::copy(unknown, std::back_inserter(columns.keys)); // the note keeps them
        if (const auto described = describeCells(columns, table); !described)
            return described.error();
        return columns;
    }
    if (table.cells)
        return Error{ErrorCode::InvalidInput, MARKED("core", "what the cells of heading columns are is said, but no column is a heading")};
    for (const auto& [place, name] : unknown)
        columns.reading.unknown.emplace_back(place, name);
    if (const auto note = columns.of("note")) { // of a reading, as in the Swing CSV
        columns.reading.place[static_cast<std::size_t>(Column::Note)] = note;
        std::erase_if(columns.keys, [](const KeyColumn& one) { return one.key == "note"; });
    }
    if (const auto enough = checkReading(columns.reading); !enough)
        return enough.error();
    return columns;
}

} // namespace csv

std::vector<std::string> yearsKeys()
{
    std::vector<std::string> keys{"aircraft", "type", "compass", "date", "site", "stage", "kind", "radio"};
    for (const auto& key : csv::keyNames())
        if (std::ranges::find(keys, key) == keys.end())
            keys.emplace_back(key);
    keys.emplace_back(csv::kSwingKey);
    for (const auto column : csv::kColumnNames)
        if (std::ranges::find(keys, column) == keys.end())
            keys.emplace_back(column);
    return keys;
}

std::optional<YearsCells> yearsCellsNamed(std::string_view word)
{
    constexpr std::array<std::string_view, 4> words{"compass", "magnetic", "deviation", "indication_error"};
    const auto found = std::ranges::find(words, word);
    return found == words.end() ? std::nullopt : std::optional(static_cast<YearsCells>(found - words.begin()));
}

std::optional<DateOrder> dateOrderNamed(std::string_view word)
{
    constexpr std::array<std::string_view, 3> words{"ymd", "dmy", "mdy"};
    const auto found = std::ranges::find(words, word);
    return found == words.end() ? std::nullopt : std::optional(static_cast<DateOrder>(found - words.begin()));
}

std::optional<double> headingOfColumn(std::string_view name)
{
    std::string text = inSmallLetters(trimmed(name));
    for (const std::string_view before : {"heading", "hdg", "h", "psi"})
        if (text.starts_with(before)) {
            text.erase(0, before.size());
            break;
        }
    while (text.starts_with('_'))
        text.erase(0, 1);
    for (const std::string_view behind : {"_deg", "deg", "\u00B0"})
        if (text.ends_with(behind)) {
            text.resize(text.size() - behind.size());
            break;
        }
    while (text.ends_with('_'))
        text.pop_back();
    if (text.find_first_not_of("0123456789.") != std::string_view::npos) // "1e2" is the name of something else
        return {};
    const FileNumber heading = readNumber(text);
    if (heading.fault != NumberFault::None || heading.value > 360)
        return {};
    return heading.value;
}

} // namespace lubberline
