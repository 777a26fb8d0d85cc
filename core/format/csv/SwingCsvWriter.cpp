#include <algorithm>

#include "core/base/Number.h"
#include "core/format/csv/SwingCsv.h"
#include "core/format/csv/SwingCsvColumns.h"
#include "core/format/csv/SwingCsvKeys.h"
#include "core/format/csv/TextCell.h"

namespace lubberline {

namespace {

using csv::Column;
using csv::nameOf;

/// The columns that this swing needs; unknown ones in the order in which they first come.
struct WrittenColumns {
    std::vector<Column> known;
    std::vector<std::string> extra;
};

std::string numberCell(std::optional<double> value) { return value ? shortestNumber(*value) : std::string(); }

/// A column that is not ours may be of numbers, which need no mark.
std::string valueCell(const std::string& text)
{
    const bool ascii = std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
    return ascii && readNumber(text).fault == NumberFault::None ? text : csvTextCell(text);
}

std::string cellOf(const Reading& reading, Column column)
{
    switch (column) {
    case Column::Magnetic: return shortestNumber(reading.magnetic->degrees());
    case Column::Compass: return shortestNumber(reading.compass->degrees());
    case Column::True: return reading.trueHeading ? shortestNumber(reading.trueHeading->degrees()) : std::string();
    case Column::Nominal: return numberCell(reading.nominal_deg);
    case Column::Pitch: return numberCell(reading.pitch_deg);
    case Column::Roll: return numberCell(reading.roll_deg);
    case Column::Note: return csvTextCell(reading.note);
    case Column::Excluded: return reading.exclusion ? csvTextCell(reading.exclusion->reason) : std::string();
    case Column::Deviation:
    case Column::IndicationError: break; // derived: never written
    }
    return {};
}

std::string cellOf(const Reading& reading, const std::string& extra)
{
    const auto found = std::find_if(reading.extra.begin(), reading.extra.end(), [&](const auto& cell) { return cell.first == extra; });
    return found == reading.extra.end() ? std::string() : valueCell(found->second);
}

WrittenColumns columnsFor(const Swing& swing)
{
    WrittenColumns columns{{Column::Magnetic, Column::Compass}, {}};
    for (const Column column : {Column::True, Column::Nominal, Column::Pitch, Column::Roll, Column::Note, Column::Excluded})
        if (std::any_of(swing.readings.begin(), swing.readings.end(),
                [&](const Reading& reading) { return reading.complete() && !cellOf(reading, column).empty(); }))
            columns.known.push_back(column);
    for (const auto& reading : swing.readings)
        for (const auto& [name, value] : reading.extra)
            if (reading.complete() && std::find(columns.extra.begin(), columns.extra.end(), name) == columns.extra.end())
                columns.extra.push_back(name);
    return columns;
}

std::string joined(const std::vector<std::string>& cells)
{
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i)
        line += (i ? "," : "") + cells[i];
    return line + "\n";
}

std::string headerOf(const WrittenColumns& columns)
{
    std::vector<std::string> cells;
    for (const Column column : columns.known)
        cells.emplace_back(nameOf(column));
    for (const auto& name : columns.extra)
        cells.push_back(csvTextCell(name));
    return joined(cells);
}

std::string rowOf(const Reading& reading, const WrittenColumns& columns)
{
    std::vector<std::string> cells;
    for (const Column column : columns.known)
        cells.push_back(cellOf(reading, column));
    for (const auto& name : columns.extra)
        cells.push_back(cellOf(reading, name));
    return joined(cells);
}

} // namespace

std::string writeSwingCsv(const SwingRecord& record)
{
    const WrittenColumns columns = columnsFor(record.swing);
    std::string text = csv::keyLinesOf(record) + headerOf(columns);
    for (const auto& reading : record.swing.readings)
        if (reading.complete())
            text += rowOf(reading, columns);
    return text;
}

} // namespace lubberline
