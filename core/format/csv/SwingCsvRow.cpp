#include "core/format/csv/SwingCsvRow.h"

#include <cmath>

#include "core/base/FileText.h"
#include "core/base/Number.h"

namespace lubberline::csv {

namespace {

struct Range {
    double least, most;
    Pattern words;
};

Range rangeOf(Column column)
{
    switch (column) {
    case Column::Deviation:
    case Column::IndicationError: return {-180, 180, MARKED("core", "degrees from -180 to 180, east positive")};
    case Column::Pitch: return {-90, 90, MARKED("core", "degrees from -90 to 90")};
    case Column::Roll: return {-180, 180, MARKED("core", "degrees from -180 to 180")};
    default: return {0, 360, MARKED("core", "degrees from 0 to 360")};
    }
}

/// `what`: of the column %1, the cell %2 and what was expected %3.
Error wrongCell(Column column, const std::string& cell, Pattern what, const Range& range)
{
    return {ErrorCode::InvalidInput, {what, std::string(nameOf(column)), inQuotes(cell), range.words}};
}

/// `rule`: what the column should be of the others; %1: to how many degrees they agree.
Error contradiction(const std::string& column, double stated_deg, double computed_deg, Pattern rule)
{
    const auto tenth = [](double angle_deg) { return shortestNumber(std::round(angle_deg * 1e4) / 1e4); };
    return {ErrorCode::InvalidInput,
        {MARKED("core", "%1 %2 contradicts the row's other columns, which give %3; expected %4"), column, tenth(stated_deg),
            tenth(computed_deg), Message{rule, shortestNumber(kAgreement_deg)}}};
}

template <class Angle>
std::optional<Angle> as(std::optional<double> angle_deg)
{
    return angle_deg ? std::optional(Angle::fromDegrees(*angle_deg)) : std::nullopt;
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

Result<std::optional<double>> RowReader::angle(const std::vector<std::string>& cells, Column column) const
{
    const auto place = m_columns.of(column);
    if (!place || (cells[*place].empty() && !required(column)))
        return std::optional<double>{};
    const std::string& cell = cells[*place];
    const Range range = rangeOf(column);
    const FileNumber number = readNumber(cell, m_decimalComma);
    if (cell.empty())
        return wrongCell(column, cell, MARKED("core", "%1: %2 is empty; expected %3"), range);
    if (number.fault == NumberFault::NotANumber)
        return wrongCell(column, cell, MARKED("core", "%1: %2 is not a number; expected %3"), range);
    if (number.fault == NumberFault::OutOfRange || number.value < range.least || number.value > range.most)
        return wrongCell(column, cell, MARKED("core", "%1: %2 is out of range; expected %3"), range);
    return std::optional(number.value);
}

Result<RowReader::Cells> RowReader::angles(const std::vector<std::string>& cells) const
{
    std::array<std::optional<double>, kColumnNames.size()> value;
    for (std::size_t i = 0; i <= static_cast<std::size_t>(Column::Roll); ++i) {
        const auto read = angle(cells, static_cast<Column>(i));
        if (!read)
            return read.error();
        value[i] = *read;
    }
    const auto of = [&](Column column) { return value[static_cast<std::size_t>(column)]; };
    Cells given;
    given.magnetic = as<MagneticHeading>(of(Column::Magnetic));
    given.compass = as<CompassHeading>(of(Column::Compass));
    given.trueHeading = as<TrueHeading>(of(Column::True));
    given.deviation = as<Deviation>(of(Column::Deviation));
    given.indicationError = as<Deviation>(of(Column::IndicationError));
    if (const auto nominal_deg = of(Column::Nominal))
        given.nominal_deg = wrap360(*nominal_deg);
    given.pitch_deg = of(Column::Pitch);
    given.roll_deg = of(Column::Roll);
    return given;
}

/// Two of magnetic, compass and deviation give the third.
Result<void> RowReader::complete(Cells& given) const
{
    const auto deviation = given.anyDeviation();
    if (!given.magnetic && m_columns.trueIsDatum()) {
        LUBBERLINE_EXPECT(m_variation_deg && given.trueHeading, "without variation no row is read");
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
    return place ? cells[*place] : std::string();
}

Result<Reading> RowReader::read(const std::vector<std::string>& cells) const
{
    if (cells.size() != m_columns.count)
        return Error{ErrorCode::InvalidInput,
            {MARKED_N("core", "the row has %n cell(s); expected %1 cells as in the header"), cells.size(), m_columns.count}};
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
        if (!cells[place].empty())
            reading.extra.emplace_back(name, cells[place]);
    return reading;
}

} // namespace lubberline::csv
