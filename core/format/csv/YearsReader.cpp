#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <unordered_set>

#include "core/base/FileText.h"
#include "core/format/csv/FigureCsv.h"
#include "core/format/csv/SwingCsvKeys.h"
#include "core/format/csv/SwingCsvRow.h"
#include "core/format/csv/TextCell.h"
#include "core/format/csv/YearsColumns.h"
#include "core/record/DerivedId.h"
#include "core/record/NorthTwice.h"

namespace lubberline {

using namespace csv;

namespace {

constexpr Pattern kExpectedYears = MARKED("core", "a table of swings: a header of named columns, and a row a swing or a row a reading");
constexpr double kTooLarge_deg = 45.0; ///< of a deviation: then the cells are likely something else than was said
constexpr std::size_t kMostNamed = 20; ///< columns that mean nothing, or swings that list a heading twice, in warnings

/// What people write where nothing was read.
bool standsForNothing(std::string_view cell)
{
    constexpr std::array<std::string_view, 6> kNothing{"-", "\u2013", "\u2014", "n/a", "N/A", "n.a."};
    return cell.empty() || std::ranges::find(kNothing, trimmed(cell)) != kNothing.end();
}

Result<void> readYearsHeader(FigureCsv& csv, const YearsTable& table)
{
    const auto names = yearsNames(table);
    return csv.readHeader(std::vector<std::string_view>(names.begin(), names.end()));
}

} // namespace

class YearsReader::Table {
public:
    Table(std::istream& input, std::string name, YearsTable table, const Progress& progress)
        : m_name(std::move(name))
        , m_progress(progress)
        , m_csv(input, m_name, kExpectedYears, m_progress)
        , m_table(std::move(table))
    {
    }

    Result<std::optional<YearsSwing>> next()
    {
        if (!m_begun) {
            m_begun = true;
            if (const auto begun = begin(); !begun)
                return begun.error();
        }
        auto swing = m_columns.rowIsSwing() ? nextRow() : nextRows();
        if (swing && !*swing && m_swings == 0)
            return m_csv.wholeFile({MARKED("core", "has a header but no rows; expected %1"), kExpectedYears});
        if (swing && !*swing)
            tellAtEnd();
        m_swings += swing && *swing ? 1 : 0;
        return swing;
    }

    std::string m_name;
    std::vector<Message> m_warnings;

private:
    Result<void> begin()
    {
        if (const auto header = readYearsHeader(m_csv, m_table); !header)
            return header;
        for (const auto& comment : m_csv.comments())
            if (const std::string text = keyTextOf(comment, m_csv.separator()); const auto line = keyLineOf(text))
                if (!m_table.common.emplace(inSmallLetters(line->key), std::string(line->value)).second)
                    return m_csv.here({MARKED("core", "the key %1 is said twice for all swings; expected it once"), inQuotes(line->key)});
        auto columns = yearsColumnsOf(m_csv, m_table);
        if (!columns)
            return m_csv.here(columns.error().message);
        m_columns = std::move(columns.value());
        if (!m_columns.of("aircraft") && !m_table.common.contains("aircraft"))
            return m_csv.here(MARKED("core", "no column is the aircraft; expected a column of registrations"));
        if (!m_columns.of("date"))
            return m_csv.here(MARKED("core", "no column is the date; expected a column of the days of the swings"));
        for (std::size_t i = 0; i < m_columns.unknown.size() && i < kMostNamed; ++i)
            m_warnings.push_back(m_columns.rowIsSwing()
                    ? Message{MARKED("core", "the column %1 means nothing here; it is kept in the swings' notes"),
                        inQuotes(m_columns.unknown[i])}
                    : Message{
                        MARKED("core", "the column %1 means nothing here; it is kept with the readings"), inQuotes(m_columns.unknown[i])});
        const auto variation = m_table.common.find("variation_deg");
        if (m_columns.reading.trueIsDatum() && variation == m_table.common.end() && !m_columns.of("variation_deg"))
            return m_csv.here(MARKED("core", "true headings stand in place of magnetic ones, and no variation_deg is said for them"));
        return {};
    }

    /// A row is a swing.
    Result<std::optional<YearsSwing>> nextRow()
    {
        const auto more = m_csv.next();
        if (!more)
            return more.error();
        if (!*more)
            return std::optional<YearsSwing>();
        auto swing = beginSwing();
        if (!swing)
            return swing.error();
        const RowReader rows(m_columns.reading, swing->file.swing.variation_deg);
        std::optional<std::size_t> zero, fullTurn;
        auto& readings = swing->file.swing.readings;
        for (const auto& column : m_columns.headings) {
            const auto cell = m_csv.cell(column.place);
            if (standsForNothing(cell))
                continue; // not read on this heading
            m_cells = {column.text, std::string(cell)};
            auto row = rows.read(m_cells);
            if (!row)
                return inHeadingColumn(column, row.error());
            if (column.heading_deg == 0)
                zero = readings.size();
            if (column.heading_deg == 360)
                fullTurn = readings.size();
            readings.push_back(std::move(row->reading));
        }
        if (zero && fullTurn)
            tellNorthTwice(swing->line,
                settleNorthTwice(readings[std::min(*zero, *fullTurn)], readings[std::max(*zero, *fullTurn)], m_table.byCompass));
        if (readings.empty())
            return m_csv.here(MARKED("core", "no heading of this swing has a reading; expected at least one"));
        return finish(std::move(swing.value()));
    }

    /// Rows that stand together and say the same of their swing are one.
    Result<std::optional<YearsSwing>> nextRows()
    {
        if (!m_ahead) {
            const auto more = m_csv.next();
            if (!more)
                return more.error();
            if (!*more)
                return std::optional<YearsSwing>();
        }
        m_ahead = false;
        const std::string particulars = particularsOfRow();
        if (const auto known = takeParticulars(particulars); !known)
            return known.error();
        auto swing = beginSwing();
        if (!swing)
            return swing.error();
        const RowReader rows(m_columns.reading, swing->file.swing.variation_deg);
        std::optional<std::size_t> zero, fullTurn;
        auto& readings = swing->file.swing.readings;
        for (;;) {
            m_cells.clear();
            for (std::size_t place = 0; place < m_csv.columns().size(); ++place)
                m_cells.emplace_back(m_csv.cell(place));
            auto row = rows.read(m_cells);
            if (!row)
                return m_csv.here(row.error().message);
            if (readings.size() == kMaxReadings)
                return m_csv.here({MARKED("core", "there are more than %1 readings; expected a compass swing"), kMaxReadings});
            if (row->north_deg)
                if (auto& north = *row->north_deg == 0 ? zero : fullTurn; !north)
                    north = readings.size();
            readings.push_back(std::move(row->reading));
            const auto more = m_csv.next();
            if (!more)
                return more.error();
            if (!*more)
                break;
            const std::string others = particularsOfRow();
            if (others == particulars || others == m_nothing)
                continue;
            m_ahead = true;
            break;
        }
        if (zero && fullTurn)
            tellNorthTwice(swing->line,
                settleNorthTwice(
                    readings[std::min(*zero, *fullTurn)], readings[std::max(*zero, *fullTurn)], rows.listed() == Column::Compass));
        return finish(std::move(swing.value()));
    }

    void tellNorthTwice(std::int64_t line, NorthTwice north)
    {
        if (north == NorthTwice::Settled || m_northTwice++ >= kMostNamed)
            return;
        m_warnings.push_back(north == NorthTwice::CountsOnce
                ? Message{MARKED("core", "line %1 lists one heading, 000 and 360, with the same reading: it counts once"), line}
                : Message{
                    MARKED("core", "line %1 lists one heading, 000 and 360, with different readings: both count, so look which is right"),
                    line});
    }

    [[nodiscard]] std::string particularsOfRow() const
    {
        std::string text;
        for (const auto& column : m_columns.keys) {
            text += m_csv.cell(column.place);
            text += '\x1f'; // no cell has it
        }
        return text;
    }

    Result<void> takeParticulars(const std::string& particulars)
    {
        m_nothing = std::string(m_columns.keys.size(), '\x1f');
        if (m_seen.insert(std::hash<std::string>()(particulars)).second)
            return {};
        return m_csv.here(MARKED("core",
            "a swing goes on here that rows above began, with others between; expected the rows of a swing to stand together, or a column \"swing\" that tells it from the other"));
    }

    Result<YearsSwing> beginSwing()
    {
        YearsSwing swing;
        swing.line = m_csv.line();
        swing.file.swing.kind = SwingKind::NotStated;
        swing.file.swing.stage = SwingStage::NotStated;
        KeyReader keys(swing.file);
        for (const auto& [key, value] : m_table.common) {
            const auto place = m_columns.of(key);
            if (place && !m_csv.cell(*place).empty())
                continue;
            if (const auto taken = takeKey(keys, key, value); !taken)
                return taken.error();
        }
        for (const auto& column : m_columns.keys) {
            const auto cell = m_csv.cell(column.place);
            if (cell.empty())
                continue;
            if (const auto taken = takeKey(keys, column.key, textOfCell(cell)); !taken)
                return taken.error();
        }
        if (swing.file.aircraft.empty())
            return m_csv.here(MARKED("core", "the aircraft is not named in this row; expected its registration"));
        if (swing.file.swing.date.empty())
            return m_csv.here(MARKED("core", "the date is not stated in this row; expected the day of the swing"));
        return swing;
    }

    Result<void> takeKey(KeyReader& keys, const std::string& key, const std::string& value)
    {
        std::string text = value;
        if (key == "date" || key == "datum_calibration_due") {
            const auto day = dateAsWritten(text, m_table.dates);
            if (!day)
                return m_csv.here({MARKED("core", "%1: %2 is no day; expected %3"), key, inQuotes(text), expectedDate()});
            text = day->text();
        }
        const auto taken = keys.take({key, text});
        return taken ? Result<void>() : Result<void>(m_csv.here(taken.error().message));
    }

    [[nodiscard]] Message expectedDate() const
    {
        switch (m_table.dates) {
        case DateOrder::DayMonthYear: return MARKED("core", "day, month and year, as 31.12.2019");
        case DateOrder::MonthDayYear: return MARKED("core", "month, day and year, as 12/31/2019");
        case DateOrder::YearMonthDay: break;
        }
        return MARKED("core", "YYYY-MM-DD");
    }

    [[nodiscard]] Error inHeadingColumn(const HeadingColumn& column, const Error& error) const
    {
        return m_csv.here({MARKED("core", "column %1: %2"), m_csv.columns()[column.place], error.message});
    }

    Result<std::optional<YearsSwing>> finish(YearsSwing swing)
    {
        auto& file = swing.file;
        for (const auto& [key, value] : file.otherKeys)
            file.swing.note += (file.swing.note.empty() ? "" : "\n") + key + ": " + value;
        if (const auto stamped = stampFromKeys(file); !stamped)
            return Error{ErrorCode::InvalidInput, stamped.error().message, m_name, swing.line};
        for (const auto& reading : file.swing.readings)
            if (reading.used()) {
                ++m_readings;
                m_tooLarge += std::abs(deviationOf(*reading.magnetic, *reading.compass).degrees()) > kTooLarge_deg ? 1 : 0;
            }
        file.swing.record = recordIdOfSwing(file.swing, file.aircraft, file.compass, file.site);
        return std::optional(std::move(swing));
    }

    void tellAtEnd()
    {
        if (m_told || 4 * m_tooLarge <= m_readings)
            return;
        m_told = true;
        m_warnings.push_back(
            {MARKED("core", "%1 of %2 deviations are larger than 45\u00B0: look whether the columns are what they were said to be"),
                m_tooLarge, m_readings});
    }

    Progress m_progress; ///< the reader of lines keeps a reference
    FigureCsv m_csv;
    YearsTable m_table;
    YearsColumns m_columns;
    std::vector<std::string> m_cells;
    std::unordered_set<std::size_t> m_seen; ///< of rows that are readings: the swings so far
    std::string m_nothing;                  ///< the particulars of a row that has none
    std::int64_t m_swings = 0, m_readings = 0, m_tooLarge = 0;
    std::size_t m_northTwice = 0; ///< swings that list one heading as 000 and as 360
    bool m_begun = false, m_ahead = false, m_told = false;
};

YearsReader::YearsReader(std::istream& input, std::string name, YearsTable table, const Progress& progress)
    : m_table(std::make_unique<Table>(input, std::move(name), std::move(table), progress))
{
}

YearsReader::~YearsReader() = default;

Result<std::optional<YearsSwing>> YearsReader::next() { return m_table->next(); }
const std::vector<Message>& YearsReader::warnings() const { return m_table->m_warnings; }
const std::string& YearsReader::name() const { return m_table->m_name; }

bool YearsHeader::looksLikeYears() const
{
    const auto has = [this](std::string_view name) { return std::ranges::find(columns, name) != columns.end(); };
    return has("aircraft") && has("date");
}

Result<YearsHeader> yearsHeader(std::istream& input, const std::string& name)
{
    const Progress none;
    FigureCsv csv(input, name, kExpectedYears, none);
    if (const auto header = readYearsHeader(csv, {}); !header)
        return header.error();
    YearsHeader header{csv.columns(), {}};
    for (const auto& column : header.columns)
        if (headingOfColumn(column))
            header.headings.push_back(column);
    return header;
}

} // namespace lubberline
