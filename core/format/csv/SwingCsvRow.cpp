#include "core/format/csv/SwingCsvRow.h"

#include <cmath>

#include "core/angle/AngleText.h"
#include "core/base/FileText.h"
#include "core/base/Number.h"
#include "core/format/csv/TextCell.h"
#include "core/record/Ranges.h"

namespace lubberline::csv {

namespace {

bool isHeading(Column column)
{
    return column == Column::Magnetic || column == Column::Compass || column == Column::True || column == Column::Nominal;
}

/// What the cells of the window say of the same text, with the column before it.
Error inColumn(Column column, const Error& error)
{
    return {error.code, {MARKED("core", "%1: %2"), std::string(nameOf(column)), error.message}};
}

/// East and west are of a deviation; the others have a sign of their own.
Result<double> angleIn(Column column, const std::string& cell)
{
    switch (column) {
    case Column::Deviation: return parseSignedAngle_deg(cell);
    case Column::Pitch: return parsePlainAngle_deg(cell, 90);
    default: return parsePlainAngle_deg(cell, 180);
    }
}

const std::string& cellAt(const std::vector<std::string>& cells, std::size_t place)
{
    static const std::string none;
    return place < cells.size() ? cells[place] : none;
}

/// `rule`: what the column should be of the others; %1: to how many degrees they agree.
Error contradiction(const std::string& column, double stated_deg, double computed_deg, Pattern rule)
{
    const auto tenth = [](double angle_deg) { return shortestNumber(std::round(angle_deg * 1e4) / 1e4); };
    return {ErrorCode::InvalidInput,
        {MARKED("core", "%1 %2 contradicts the row's other columns, which give %3; expected %4"), column, tenth(stated_deg),
            tenth(computed_deg), Message{rule, shortestNumber(kAgreement_deg)}}};
}

bool differ(double a_deg, double b_deg)
{
    return std::abs(wrap180(a_deg - b_deg)) > kAgreement_deg + 1e-9; // 1e-9: figures of 0.05 are not exact in binary
}

} // namespace

/// What a row states, as headings and deviations.
struct RowReader::Cells {
    std::optional<MagneticHeading> magnetic;
    std::optional<CompassHeading> compass;
    std::optional<TrueHeading> trueHeading;
    std::optional<Deviation> deviation, indicationError;
    std::optional<double> nominal_deg, pitch_deg, roll_deg;
    std::optional<double> north_deg; ///< of Row

    [[nodiscard]] std::optional<Deviation> anyDeviation() const
    {
        if (deviation || !indicationError)
            return deviation;
        return Deviation::fromDegrees(-indicationError->degrees());
    }
};

bool RowReader::required(Column column) const
{
    return column <= Column::IndicationError || (column == Column::True && m_columns.trueIsDatum());
}

Column RowReader::listed() const
{
    for (const Column column : {Column::Magnetic, Column::True})
        if (m_columns.has(column))
            return column;
    return Column::Compass;
}

Result<void> RowReader::takeHeading(const std::vector<std::string>& cells, Column column, Cells& given) const
{
    const std::string& cell = cellAt(cells, *m_columns.of(column));
    const auto heading = parseWrittenHeading(cell);
    if (!heading)
        return inColumn(column, heading.error());
    if (column == listed() && heading->heading_deg == 0.0)
        given.north_deg = heading->fullTurn ? 360.0 : 0.0;
    // "274T" among magnetic headings is a true one, as in the window.
    const bool trueInstead = column == Column::Magnetic && heading->north == North::True && m_variation_deg && !m_columns.has(Column::True);
    const North meant = column == Column::Compass ? North::Compass : column == Column::True || trueInstead ? North::True : North::Magnetic;
    if (heading->north != North::NotSaid && heading->north != meant)
        return inColumn(column, parseHeading_deg(cell, meant).error());
    if (column == Column::Compass)
        given.compass = CompassHeading::fromDegrees(heading->heading_deg);
    else if (column == Column::Nominal)
        given.nominal_deg = heading->heading_deg;
    else if (column == Column::True || trueInstead)
        given.trueHeading = TrueHeading::fromDegrees(heading->heading_deg);
    else
        given.magnetic = MagneticHeading::fromDegrees(heading->heading_deg);
    return {};
}

Result<void> RowReader::takeAngle(const std::vector<std::string>& cells, Column column, Cells& given) const
{
    const auto angle_deg = angleIn(column, cellAt(cells, *m_columns.of(column)));
    if (!angle_deg)
        return inColumn(column, angle_deg.error());
    if (column == Column::Deviation)
        given.deviation = Deviation::fromDegrees(*angle_deg);
    else if (column == Column::IndicationError)
        given.indicationError = Deviation::fromDegrees(*angle_deg);
    else
        (column == Column::Pitch ? given.pitch_deg : given.roll_deg) = *angle_deg;
    return {};
}

Result<RowReader::Cells> RowReader::angles(const std::vector<std::string>& cells) const
{
    Cells given;
    for (std::size_t i = 0; i <= static_cast<std::size_t>(Column::Roll); ++i) {
        const auto column = static_cast<Column>(i);
        const auto place = m_columns.of(column);
        if (!place)
            continue;
        if (trimmed(cellAt(cells, *place)).empty()) {
            if (required(column))
                return Error{ErrorCode::InvalidInput,
                    {MARKED("core", "%1: the cell is empty; expected degrees, such as 47.5"), std::string(nameOf(column))}};
            continue;
        }
        const auto taken = isHeading(column) ? takeHeading(cells, column, given) : takeAngle(cells, column, given);
        if (!taken)
            return taken.error();
    }
    return given;
}

/// Two of magnetic, compass and deviation give the third.
Result<void> RowReader::complete(Cells& given) const
{
    const auto deviation = given.anyDeviation();
    if (!given.magnetic && given.trueHeading && (m_columns.trueIsDatum() || m_columns.has(Column::Magnetic))) {
        LUBBERLINE_EXPECT(m_variation_deg, "without variation no row is read");
        given.magnetic = toMagnetic(*given.trueHeading, Variation::fromDegrees(*m_variation_deg));
    }
    if (!given.magnetic)
        given.magnetic = toMagnetic(*given.compass, *deviation);
    if (!given.compass)
        given.compass = toCompass(*given.magnetic, *deviation);
    return agree(given);
}

Result<void> RowReader::agree(const Cells& given) const
{
    const double deviation_deg = deviationOf(*given.magnetic, *given.compass).degrees();
    if (given.deviation && differ(given.deviation->degrees(), deviation_deg))
        return contradiction(
            "deviation_deg", given.deviation->degrees(), deviation_deg, MARKED("core", "magnetic - compass, in agreement to %1 degrees"));
    if (given.indicationError && differ(given.indicationError->degrees(), -deviation_deg))
        return contradiction("indication_error_deg", given.indicationError->degrees(), -deviation_deg,
            MARKED("core", "compass - magnetic, in agreement to %1 degrees"));
    if (!given.trueHeading || !m_variation_deg)
        return {};
    const double true_deg = toTrue(*given.magnetic, Variation::fromDegrees(*m_variation_deg)).degrees();
    if (differ(given.trueHeading->degrees(), true_deg))
        return contradiction(
            "true_heading_deg", given.trueHeading->degrees(), true_deg, MARKED("core", "magnetic + variation, in agreement to %1 degrees"));
    return {};
}

std::string RowReader::text(const std::vector<std::string>& cells, Column column) const
{
    const auto place = m_columns.of(column);
    return place ? textOfCell(cellAt(cells, *place)) : std::string();
}

Result<void> RowReader::checkCount(const std::vector<std::string>& cells) const
{
    bool wrong = false;
    for (std::size_t i = m_columns.count; i < cells.size(); ++i)
        wrong |= !trimmed(cells[i]).empty();
    for (std::size_t i = 0; i < kColumnNames.size(); ++i)
        if (const auto place = m_columns.place[i]; place && *place >= cells.size())
            wrong |= required(static_cast<Column>(i));
    if (!wrong)
        return {};
    return Error{ErrorCode::InvalidInput,
        {MARKED_N("core", "the row has %n cell(s); expected %1 cells as in the header"), cells.size(), m_columns.count}};
}

Result<Row> RowReader::read(const std::vector<std::string>& cells) const
{
    if (const auto counted = checkCount(cells); !counted)
        return counted.error();
    for (const std::string& cell : cells)
        if (cell.size() > kLongestText)
            return Error{
                ErrorCode::InvalidInput, {MARKED("core", "a cell holds %1 bytes; expected at most %2"), cell.size(), kLongestText}};
    auto given = angles(cells);
    if (!given)
        return given.error();
    if (const auto completed = complete(*given); !completed)
        return completed.error();

    Reading reading;
    reading.nominal_deg = given->nominal_deg;
    reading.magnetic = given->magnetic;
    reading.compass = given->compass;
    reading.trueHeading = given->trueHeading;
    reading.pitch_deg = given->pitch_deg;
    reading.roll_deg = given->roll_deg;
    reading.note = text(cells, Column::Note);
    if (auto reason = text(cells, Column::Excluded); !reason.empty())
        reading.exclusion = Exclusion{std::move(reason)};
    for (const auto& [place, name] : m_columns.unknown)
        if (!cellAt(cells, place).empty())
            reading.extra.emplace_back(name, textOfCell(cells[place]));
    return Row{std::move(reading), given->north_deg};
}

} // namespace lubberline::csv
