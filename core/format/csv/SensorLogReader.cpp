#include <algorithm>
#include <cmath>

#include "core/base/FileText.h"
#include "core/base/LineReader.h"
#include "core/base/Number.h"
#include "core/base/PlainNumber.h"
#include "core/base/WholeFile.h"
#include "core/format/csv/RowSplitter.h"
#include "core/format/csv/SensorLogColumns.h"

namespace lubberline {

namespace {

constexpr Pattern kExpectedLog = MARKED("core", "expected a sensor log CSV: a header with bx_nT, by_nT, bz_nT, and one sample a row");
constexpr std::int64_t kMostBadCells = 100;
// A row takes memory for each column of the header, whatever it holds: a file of a few megabytes must not take all there is.
constexpr std::size_t kMostCellsNotThere = 4'000'000;
constexpr std::size_t kMostOtherCells = 40'000'000; ///< 320 MB

/// Blanks part cells only where nothing else does.
char logSeparatorOf(std::string_view line)
{
    for (const char separator : {';', '\t', ','})
        if (line.find(separator) != std::string_view::npos)
            return separator;
    return ' ';
}

std::vector<std::string> cellsOf(std::string_view line, char separator)
{
    if (separator != ' ') {
        RowSplitter splitter(separator);
        static_cast<void>(splitter.begin(line));
        auto cells = splitter.cells();
        while (!cells.empty() && trimmed(cells.back()).empty())
            cells.pop_back();
        return cells;
    }
    std::vector<std::string> cells;
    for (std::size_t at = line.find_first_not_of(' '); at != std::string_view::npos; at = line.find_first_not_of(' ', at)) {
        const auto end = std::min(line.find(' ', at), line.size());
        cells.emplace_back(line.substr(at, end - at));
        at = end;
    }
    return cells;
}

class LogReader {
public:
    LogReader(std::istream& input, const std::string& name, const SensorLogOptions& options, const Progress& progress)
        : m_lines(input, progress)
        , m_name(name)
        , m_options(options)
    {
    }

    Result<std::vector<std::string>> header();
    Result<SensorLog> read();

private:
    Result<bool> nextLine();
    Result<void> takeRow(std::string_view row);
    bool takeCell(std::string_view cell, std::vector<double>& values);
    Result<void> checkTime();
    Result<SensorLog> finish();
    void bindColumns();
    [[nodiscard]] Error here(ErrorCode code, const Message& message) const { return {code, message, m_name, m_lines.lineNumber()}; }

    LineReader m_lines;
    const std::string& m_name;
    const SensorLogOptions& m_options;
    SensorLog m_log;
    csv::LogHeader m_header;
    std::vector<std::vector<double>*> m_targets; ///< of each column
    std::string m_line;
    char m_separator = ',';
    bool m_decimalComma = false;
    bool m_noHeader = false;
    std::int64_t m_othersNotNumbers = 0;
    std::size_t m_cellsNotThere = 0, m_otherCells = 0;
};

Result<bool> LogReader::nextLine()
{
    switch (m_lines.next(m_line)) {
    case LineOutcome::Line: return true;
    case LineOutcome::End: return false;
    case LineOutcome::Binary:
        return Error{
            ErrorCode::Format, {MARKED("core", "is binary: it has NUL bytes or lines of more than 1 MiB; %1"), kExpectedLog}, m_name};
    case LineOutcome::ReadError: return Error{ErrorCode::Io, MARKED("core", "cannot be read to its end"), m_name};
    case LineOutcome::Cancelled: break;
    }
    return Error{ErrorCode::Cancelled, MARKED("core", "reading was cancelled"), m_name};
}

/// The names of the columns; of a file without a header "x", "y", "z", or "time_s" and these, and m_line is its first row.
Result<std::vector<std::string>> LogReader::header()
{
    if (const Message other = otherEncoding(m_lines.beginning()); !other.empty())
        return Error{ErrorCode::Format, other, m_name};
    for (bool first = true;; first = false) {
        const auto line = nextLine();
        if (!line)
            return line.error();
        if (!*line)
            return Error{ErrorCode::Format, {MARKED("core", "is empty; %1"), kExpectedLog}, m_name};
        if (first && m_line.starts_with(kByteOrderMark))
            m_line.erase(0, kByteOrderMark.size());
        if (const auto content = trimmed(m_line);
            content.empty() || content.starts_with('#') || inSmallLetters(content).starts_with("sep="))
            continue;
        break;
    }
    if (const Message bad = notUtf8(m_line); !bad.empty())
        return here(ErrorCode::Format, bad);
    m_separator = logSeparatorOf(m_line);
    std::vector<std::string> cells = cellsOf(m_line, m_separator);
    if (const auto few = checkColumns(cells.size()); !few)
        return here(few.error().code, few.error().message);
    m_decimalComma = m_separator == ';' || m_separator == '\t' || m_separator == ' ';
    m_noHeader = std::all_of(cells.begin(), cells.end(),
        [this](const std::string& cell) { return readNumber(trimmed(cell), m_decimalComma).fault == NumberFault::None; });
    if (!m_noHeader)
        return cells;
    if (cells.size() == 3)
        return std::vector<std::string>{"x", "y", "z"};
    if (cells.size() == 4)
        return std::vector<std::string>{"time_s", "x", "y", "z"};
    return here(ErrorCode::Format,
        {MARKED("core", "has no header, and %1 numbers a row; expected three (x, y, z), four (time, x, y, z), or names"), cells.size()});
}

void LogReader::bindColumns()
{
    using csv::LogRole;
    const auto count
        = [this](LogRole role) { return static_cast<std::size_t>(std::count(m_header.roles.begin(), m_header.roles.end(), role)); };
    m_log.currents.reserve(count(LogRole::Current)); // they are pointed at
    m_log.others.reserve(count(LogRole::Other));
    for (std::size_t column = 0; column < m_header.roles.size(); ++column) {
        switch (m_header.roles[column]) {
        case LogRole::Time: m_targets.push_back(&m_log.time_s); break;
        case LogRole::X: m_targets.push_back(&m_log.field[0]); break;
        case LogRole::Y: m_targets.push_back(&m_log.field[1]); break;
        case LogRole::Z: m_targets.push_back(&m_log.field[2]); break;
        case LogRole::Heading: m_targets.push_back(&m_log.heading_deg); break;
        case LogRole::Pitch: m_targets.push_back(&m_log.pitch_deg); break;
        case LogRole::Roll: m_targets.push_back(&m_log.roll_deg); break;
        case LogRole::Current: m_targets.push_back(&m_log.currents.emplace_back(LogColumn{m_header.keys[column], {}}).values); break;
        case LogRole::Other: m_targets.push_back(&m_log.others.emplace_back(LogColumn{m_header.keys[column], {}}).values); break;
        }
    }
}

/// @return whether the cell is a number, empty, or says that it is none.
bool LogReader::takeCell(std::string_view cell, std::vector<double>& values)
{
    double value = 0;
    if (takePlainNumber(cell, value)) {
        values.push_back(value);
        return true;
    }
    cell = trimmed(cell);
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"')
        cell = trimmed(cell.substr(1, cell.size() - 2));
    if (const FileNumber number = readNumber(cell, m_decimalComma); number.fault == NumberFault::None) {
        values.push_back(number.value);
        return true;
    }
    values.push_back(kNoValue);
    if (cell.empty()) {
        ++m_log.counts.emptyCells;
        return true;
    }
    const std::string small = inSmallLetters(cell);
    if (small == "nan" || small == "-nan" || small == "na" || small == "n/a" || small == "null" || small == "inf" || small == "-inf") {
        ++m_log.counts.nanCells;
        return true;
    }
    return false;
}

Result<void> LogReader::takeRow(std::string_view row)
{
    ++m_log.counts.rows;
    std::size_t column = 0;
    for (std::size_t at = 0; column < m_targets.size(); ++column) {
        if (m_separator == ' ')
            at = std::min(row.find_first_not_of(' ', at), row.size());
        if (at > row.size() || (m_separator == ' ' && at == row.size()))
            break;
        const auto end = std::min(row.find(m_separator, at), row.size());
        const std::string_view cell = row.substr(at, end - at);
        at = end + 1;
        if (takeCell(cell, *m_targets[column]))
            continue;
        if (m_header.roles[column] == csv::LogRole::Other) {
            ++m_othersNotNumbers; // a note, a word: nobody asked for it
            continue;
        }
        if (++m_log.counts.badCells > kMostBadCells)
            return here(ErrorCode::InvalidInput,
                {MARKED("core", "%1 in column %2 is no number, as more than %3 cells before it; expected one, or an empty cell"),
                    figuresInQuotes(cell), inQuotes(m_header.names[column]), kMostBadCells});
        if (m_log.counts.badCells == 1)
            m_log.warnings.push_back({MARKED("core", "line %1: %2 in column %3 is no number; its row counts as empty there"),
                m_lines.lineNumber(), figuresInQuotes(cell), inQuotes(m_header.names[column])});
    }
    if (column < m_targets.size())
        ++m_log.counts.shortRows;
    m_cellsNotThere += m_targets.size() - column;
    if (m_cellsNotThere > kMostCellsNotThere)
        return here(ErrorCode::InvalidInput,
            {MARKED("core", "the row has %1 cells where the header has %2, as many rows before it; expected a cell a column"), column,
                m_targets.size()});
    m_otherCells += m_log.others.size();
    if (m_otherCells > kMostOtherCells)
        return here(ErrorCode::InvalidInput,
            {MARKED("core", "%1 columns that are no field, heading or current hold more than %2 cells; expected a log without them"),
                m_log.others.size(), kMostOtherCells});
    for (; column < m_targets.size(); ++column)
        m_targets[column]->push_back(kNoValue);
    return checkTime();
}

Result<void> LogReader::checkTime()
{
    if (m_log.time_s.size() < 2)
        return {};
    const double now = m_log.time_s.back(), before = m_log.time_s[m_log.time_s.size() - 2];
    if (std::isnan(now)) { // between both neighbours, as far as can be told
        m_log.time_s.back() = before;
        return {};
    }
    if (now < before)
        return here(ErrorCode::InvalidInput,
            {MARKED("core", "time goes back, from %1 to %2; expected rows in order of time, of one log"), shortestNumber(before),
                shortestNumber(now)});
    return {};
}

Result<SensorLog> LogReader::finish()
{
    if (m_log.size() == 0)
        return Error{ErrorCode::Format, {MARKED("core", "holds no samples; %1"), kExpectedLog}, m_name};
    if (!m_log.time_s.empty() && m_header.perSecond != 1.0)
        for (auto& time : m_log.time_s)
            time /= m_header.perSecond;
    std::erase_if(m_log.others, [](const LogColumn& column) {
        return std::none_of(column.values.begin(), column.values.end(), [](double value) { return std::isfinite(value); });
    });
    if (m_noHeader)
        m_log.warnings.push_back({MARKED("core", "there is no header: the columns are taken for %1"),
            m_header.names.size() == 3 ? std::string("x, y, z") : std::string("time_s, x, y, z")});
    const auto& counts = m_log.counts;
    if (counts.emptyCells > 0)
        m_log.warnings.push_back({MARKED_N("core", "%n empty cell(s)"), counts.emptyCells});
    if (counts.nanCells > 0)
        m_log.warnings.push_back({MARKED_N("core", "%n cell(s) without a number (NaN)"), counts.nanCells});
    if (counts.shortRows > 0)
        m_log.warnings.push_back({MARKED_N("core", "%n row(s) with fewer cells than the header"), counts.shortRows});
    m_header.timeUnitNamed = m_header.timeUnitNamed && !m_noHeader; // a name of ours says nothing of the file
    csv::takeTime(m_log, m_header);
    csv::takeUnit(m_log, m_header, m_options);
    return std::move(m_log);
}

Result<SensorLog> LogReader::read()
{
    const auto names = header();
    if (!names)
        return names.error();
    auto roles = csv::logHeaderOf(*names, m_options);
    if (!roles)
        return here(roles.error().code, roles.error().message);
    m_header = std::move(roles.value());
    bindColumns();
    if (m_noHeader)
        if (auto taken = takeRow(m_line); !taken)
            return taken.error();
    for (;;) {
        const auto line = nextLine();
        if (!line)
            return line.error();
        if (!*line)
            return finish();
        if (m_line.empty() || m_line.front() == '#' || trimmed(m_line).empty())
            continue;
        if (auto taken = takeRow(m_line); !taken)
            return taken.error();
    }
}

} // namespace

Result<SensorLog> readSensorLog(std::istream& input, const std::string& name, const SensorLogOptions& options, const Progress& progress)
{
    return LogReader(input, name, options, progress).read();
}

Result<SensorLog> readSensorLogFile(const std::string& path, const SensorLogOptions& options, const Progress& progress)
{
    const auto file = openInput(path, MARKED("core", "a sensor log"));
    return file ? readSensorLog(**file, nameOfInput(path), options, progress) : Result<SensorLog>(file.error());
}

Result<SensorLogHeader> readSensorLogHeader(std::istream& input, const std::string& name)
{
    const SensorLogOptions options;
    const Progress progress;
    const auto names = LogReader(input, name, options, progress).header();
    if (!names)
        return names.error();
    SensorLogHeader header;
    header.columns = *names;
    if (const auto roles = csv::logHeaderOf(*names, {}))
        for (std::size_t column = 0; column < names->size(); ++column)
            if (roles->roles[column] < csv::LogRole::Current)
                header.recognised.emplace(csv::keyOf(roles->roles[column]), (*names)[column]);
    return header;
}

Result<SensorLogHeader> readSensorLogHeaderFile(const std::string& path)
{
    const auto file = openInput(path, MARKED("core", "a sensor log"));
    return file ? readSensorLogHeader(**file, nameOfInput(path)) : Result<SensorLogHeader>(file.error());
}

} // namespace lubberline
