#include <algorithm>

#include "core/angle/AngleText.h"
#include "core/base/FileText.h"
#include "core/base/LineReader.h"
#include "core/base/NearWord.h"
#include "core/base/Number.h"
#include "core/base/WholeFile.h"
#include "core/format/csv/ColumnName.h"
#include "core/format/csv/RowSplitter.h"
#include "core/format/csv/SwingCsv.h"
#include "core/format/csv/SwingCsvAside.h"
#include "core/format/csv/SwingCsvColumns.h"
#include "core/format/csv/SwingCsvKeys.h"
#include "core/format/csv/SwingCsvRow.h"
#include "core/format/csv/TextCell.h"
#include "core/record/DerivedId.h"
#include "core/record/NorthTwice.h"
#include "core/record/Ranges.h"
#include "core/swing/SharedDoubts.h"

namespace lubberline {

namespace {

using namespace csv;

constexpr Pattern kExpectedFile
    = MARKED("core", "expected a Swing CSV: text in UTF-8 with a header of named columns and one reading a row");

constexpr std::size_t kMostBytesAbove = std::size_t{4} << 20;
/// What is only kept must not take more memory than the readings may.
constexpr std::size_t kMostExtraBytes = std::size_t{128} << 20;

std::size_t bytesOfExtra(const Reading& reading)
{
    std::size_t bytes = 0;
    for (const auto& [name, value] : reading.extra)
        bytes += name.size() + value.size() + sizeof reading.extra.front();
    return bytes;
}

bool isKeyLine(std::string_view content) { return content.starts_with('#') || content.starts_with("\"#"); }

/// "#N/A", "#VALUE!", "#DIV/0!", "#NAME?": what spreadsheets write where they cannot compute, alone in its cell.
bool isSpreadsheetError(std::string_view cell)
{
    constexpr std::size_t kShortest = 3, kLongest = 12;
    if (cell.size() < kShortest || cell.size() > kLongest || cell.front() != '#')
        return false;
    return std::all_of(cell.begin() + 1, cell.end(),
        [](char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '/' || c == '!' || c == '?'; });
}

bool isEmptyRow(const std::vector<std::string>& cells)
{
    return std::all_of(cells.begin(), cells.end(), [](const std::string& cell) { return trimmed(cell).empty(); });
}

/// Rows above the header, which spreadsheets have for their title; more of them are another kind of file.
constexpr std::size_t kMostTitleRows = 20;

/// The reading of a row whose heading is north, and where it stands.
struct NorthRow {
    std::size_t reading = 0;
    std::int64_t line = 0;
};

/// Reads one file. Every step returns the error with file and line filled in.
class SwingReader {
public:
    SwingReader(std::istream& input, const std::string& name, const Progress& progress)
        : m_lines(input, progress)
        , m_name(name)
        , m_keys(m_file)
    {
        m_file.swing.kind = SwingKind::NotStated;
        m_file.swing.stage = SwingStage::NotStated;
    }
    Result<SwingFile> read();

private:
    Result<void> checkBeginning();
    Result<bool> nextLine(); ///< false at the end
    Result<void> takeLine();
    Result<void> gatherQuotedKey();
    Result<void> takeKey(const std::string& line);
    Result<void> splitRow();
    Result<void> takeHeader();
    void keepTitle(const std::vector<std::string>& cells);
    Result<void> takeReading();
    [[nodiscard]] bool standsAside();
    Result<SwingFile> finish();
    void tellNorthTwice();

    [[nodiscard]] Error wholeFile(ErrorCode code, const Message& message) const { return {code, message, m_name}; }
    [[nodiscard]] Error here(ErrorCode code, const Message& message) const { return {code, message, m_name, m_rowLine}; }
    [[nodiscard]] Error here(const Error& error) const { return here(error.code, error.message); }

    LineReader m_lines;
    const std::string& m_name;
    SwingFile m_file;
    KeyReader m_keys;
    std::string m_line;
    std::int64_t m_rowLine = 0; ///< where the row begins: a quoted cell may go on over several lines
    std::optional<RowSplitter> m_splitter;
    std::optional<Columns> m_columns;
    std::optional<RowReader> m_rows;
    /// Keys above the header: the separator of the cells behind them is known with it.
    std::vector<std::pair<std::int64_t, std::string>> m_keysAbove;
    std::size_t m_bytesAbove = 0; ///< of those
    std::size_t m_extraBytes = 0; ///< of columns that mean nothing here
    std::vector<std::string> m_titles;
    std::optional<Error> m_noHeader; ///< what to say where none comes after a title: it was meant as the header
    char m_told = 0;                 ///< the separator of a line "sep=;"
    bool m_started = false;          ///< past the first line that is not blank
    bool m_rowsCrLf = false;         ///< rows end in CRLF: the line breaks in their cells are no others
    std::optional<NorthRow> m_zero, m_fullTurn;
};

Result<void> SwingReader::checkBeginning()
{
    const Message other = otherEncoding(m_lines.beginning());
    return other.empty() ? Result<void>() : Result<void>(wholeFile(ErrorCode::Format, other));
}

Result<bool> SwingReader::nextLine()
{
    switch (m_lines.next(m_line)) {
    case LineOutcome::Line: break;
    case LineOutcome::End: return false;
    case LineOutcome::Binary:
        return wholeFile(ErrorCode::Format, {MARKED("core", "is binary: it has NUL bytes or lines of more than 1 MiB; %1"), kExpectedFile});
    case LineOutcome::ReadError: return wholeFile(ErrorCode::Io, MARKED("core", "cannot be read to its end"));
    case LineOutcome::Cancelled: return wholeFile(ErrorCode::Cancelled, MARKED("core", "reading was cancelled"));
    }
    if (m_lines.lineNumber() == 1 && std::string_view(m_line).starts_with(kByteOrderMark))
        m_line.erase(0, kByteOrderMark.size());
    if (const Message bytes = notUtf8(m_line); !bytes.empty())
        return Error{ErrorCode::Format, bytes, m_name, m_lines.lineNumber()};
    return true;
}

Result<SwingFile> SwingReader::read()
{
    if (const auto text = checkBeginning(); !text)
        return text.error();
    for (;;) {
        const auto more = nextLine();
        if (!more)
            return more.error();
        if (!*more)
            return finish();
        m_rowLine = m_lines.lineNumber();
        if (const auto taken = takeLine(); !taken)
            return taken.error();
    }
}

Result<void> SwingReader::takeLine()
{
    const auto content = trimmed(m_line);
    if (content.empty())
        return {};
    if (!std::exchange(m_started, true))
        for (const std::string_view line : {content, std::string_view(m_line)}) // "sep=" and a tab ends where it was trimmed
            if (const auto told = toldSeparator(line)) {
                m_told = *told;
                return {};
            }
    if (isKeyLine(content)) {
        if (const auto whole = gatherQuotedKey(); !whole)
            return whole;
        if (m_columns)
            return takeKey(m_line);
        m_keysAbove.emplace_back(m_rowLine, m_line);
        m_bytesAbove += m_line.size() + sizeof m_keysAbove.back();
        if (m_bytesAbove > kMostBytesAbove)
            return here(ErrorCode::Format,
                {MARKED("core", "lines of # take more than %1 MiB and no header follows; %2"), kMostBytesAbove >> 20, kExpectedFile});
        return {};
    }
    if (m_columns)
        return takeReading();
    return content.find_first_not_of(",;|\" \t") == std::string_view::npos ? Result<void>() : takeHeader();
}

/// A cell in quotes may go on over several lines.
Result<void> SwingReader::gatherQuotedKey()
{
    std::string whole = m_line;
    while (trimmed(whole).starts_with('"') && std::count(whole.begin(), whole.end(), '"') % 2 != 0) {
        const auto more = nextLine();
        if (!more)
            return more.error();
        if (!*more || whole.size() + m_line.size() > kMaxLineBytes)
            return here(ErrorCode::Format, MARKED("core", "a quoted cell that begins in this row is not closed; expected a second \""));
        whole += '\n' + m_line;
    }
    m_line = std::move(whole);
    return {};
}

Result<void> SwingReader::takeKey(const std::string& line)
{
    const char separator = m_splitter->separator();
    const std::string text = keyTextOf(trimmed(line), separator);
    if (m_columns)
        if (const auto first = trimmed(text.substr(0, text.find(separator))); isSpreadsheetError(first))
            return here(ErrorCode::InvalidInput,
                {MARKED("core", "%1 is what a spreadsheet writes where it cannot compute; expected a heading"), inQuotes(first)});
    const auto key = keyLineOf(text);
    if (!key)
        return {};
    if (m_columns && inSmallLetters(key->key) == "variation_deg")
        return here(ErrorCode::InvalidInput,
            MARKED("core", "variation_deg stands below the header; expected it above, since the rows are computed with it"));
    const auto taken = m_keys.take(*key);
    return taken ? Result<void>() : Result<void>(here(taken.error()));
}

/// Splits the row that begins in this line; a quoted cell may draw in more lines.
Result<void> SwingReader::splitRow()
{
    auto state = m_splitter->begin(m_line);
    while (state == RowSplitter::State::Open) {
        const char* const lineBreak = m_lines.endedInCrLf() && !m_rowsCrLf && m_columns ? "\r\n" : "\n";
        const auto more = nextLine();
        if (!more)
            return more.error();
        if (!*more || m_splitter->bytes() + m_line.size() > kMaxLineBytes)
            return here(ErrorCode::Format, MARKED("core", "a quoted cell that begins in this row is not closed; expected a second \""));
        state = m_splitter->resume(m_line, lineBreak);
    }
    if (state == RowSplitter::State::TextAfterQuote)
        return here(ErrorCode::Format,
            MARKED("core", "there is text behind a closing quote; expected a separator there, or \"\" for a quote inside"));
    return {};
}

Result<void> SwingReader::takeHeader()
{
    m_splitter.emplace(separatorOf(m_line, m_told));
    const auto headerLine = m_rowLine;
    if (const auto split = splitRow(); !split)
        return m_noHeader ? *m_noHeader : split.error();
    auto columns = columnsOf(m_splitter->cells());
    if (!columns) {
        if (!m_noHeader)
            m_noHeader = here(columns.error());
        if (!isTitle(m_splitter->cells()) || m_titles.size() == kMostTitleRows)
            return *m_noHeader;
        keepTitle(m_splitter->cells());
        return {};
    }
    for (const auto& [line, text] : m_keysAbove) {
        m_rowLine = line;
        if (const auto taken = takeKey(text); !taken)
            return taken;
    }
    m_keysAbove.clear();
    m_rowLine = headerLine;
    for (const std::string& title : m_titles)
        m_file.otherKeys.emplace_back("title", title);
    if (!m_titles.empty())
        m_file.warnings.push_back(
            {MARKED_N("core", "%n row(s) above the header, where no column is named, kept in the swing's note"), m_titles.size()});
    m_columns = std::move(columns.value());
    m_rowsCrLf = m_lines.endedInCrLf();
    const auto variation_deg = m_file.swing.variation_deg;
    if (m_columns->trueIsDatum() && !variation_deg)
        return here(ErrorCode::InvalidInput,
            MARKED("core",
                "true_heading_deg stands in place of the magnetic heading, but the variation is not stated; expected a line \"# variation_deg: \u2026\" (degrees, east positive) above the header"));
    m_rows.emplace(*m_columns, variation_deg);
    for (const auto& [place, name] : m_columns->unknown)
        if (columnKey(name) != kDatumErrorColumn)
            m_file.warnings.push_back({MARKED("core", "the column %1 means nothing here; it is kept with the readings"), inQuotes(name)});
    return {};
}

void SwingReader::keepTitle(const std::vector<std::string>& cells)
{
    std::string title;
    for (const std::string& cell : cells)
        if (const auto said = trimmed(textOfCell(cell)); !said.empty())
            title += (title.empty() ? "" : " ") + std::string(said);
    m_titles.push_back(std::move(title));
}

/// A row that is no reading, and is told; where only its note sounds so it is read, and told as well.
bool SwingReader::standsAside()
{
    const auto& cells = m_splitter->cells();
    auto& warnings = m_file.warnings;
    if (m_file.swing.readings.empty() && isUnitsRow(cells, *m_columns)) {
        warnings.push_back({MARKED("core", "line %1 holds the units of the columns and no reading"), m_rowLine});
        return true;
    }
    const SummaryRow summary = summaryRowOf(cells, *m_columns);
    if (summary.word.empty() || m_file.swing.readings.empty() || warnings.size() > kMostTitleRows)
        return false;
    const bool read = summary.onlyInNote && m_rows->read(cells);
    warnings.push_back({read ? MARKED("core", "line %1 is noted as %2 and taken for a reading: exclude it where it sums up the others")
                             : MARKED("core", "line %1 is left out: %2 sums up the readings and is none"),
        m_rowLine, inQuotes(summary.word)});
    return !read;
}

Result<void> SwingReader::takeReading()
{
    if (const auto split = splitRow(); !split)
        return split.error();
    if (isEmptyRow(m_splitter->cells()) || standsAside())
        return {};
    auto row = m_rows->read(m_splitter->cells());
    if (!row)
        return here(row.error());
    if (m_file.swing.readings.size() == kMaxReadings)
        return here(ErrorCode::InvalidInput, {MARKED("core", "there are more than %1 readings; expected a compass swing"), kMaxReadings});
    if (row->north_deg)
        if (auto& north = *row->north_deg == 0.0 ? m_zero : m_fullTurn; !north)
            north = NorthRow{m_file.swing.readings.size(), m_rowLine};
    m_extraBytes += bytesOfExtra(row->reading);
    if (m_extraBytes > kMostExtraBytes)
        return here(ErrorCode::InvalidInput,
            {MARKED("core", "the columns that mean nothing here take more than %1 MiB; expected a compass swing"), kMostExtraBytes >> 20});
    m_file.swing.readings.push_back(std::move(row->reading));
    return {};
}

void SwingReader::tellNorthTwice()
{
    if (!m_zero || !m_fullTurn)
        return;
    const bool zeroFirst = m_zero->line < m_fullTurn->line, byCompass = m_rows->listed() == Column::Compass;
    auto& readings = m_file.swing.readings;
    Reading& zero = readings[m_zero->reading];
    Reading& fullTurn = readings[m_fullTurn->reading];
    const auto shown = [byCompass](const Reading& reading) {
        return formatHeading(byCompass ? reading.magnetic->degrees() : reading.compass->degrees());
    };
    switch (settleNorthTwice(zeroFirst ? zero : fullTurn, zeroFirst ? fullTurn : zero, byCompass)) {
    case NorthTwice::Settled: return;
    case NorthTwice::CountsOnce:
        m_file.warnings.push_back({MARKED("core", "lines %1 and %2 list one heading, 000 and 360, with the same reading: it counts once"),
            m_zero->line, m_fullTurn->line});
        return;
    case NorthTwice::Differs:
        m_file.warnings.push_back(
            {MARKED("core",
                 "lines %1 and %2 list one heading, 000 and 360, with different readings, %3 and %4: both count, so look which is right"),
                m_zero->line, m_fullTurn->line, shown(zero), shown(fullTurn)});
    }
}

Result<SwingFile> SwingReader::finish()
{
    if (m_lines.lineNumber() == 0)
        return wholeFile(ErrorCode::Format, {MARKED("core", "is empty; %1"), kExpectedFile});
    if (!m_columns)
        return m_noHeader ? *m_noHeader : wholeFile(ErrorCode::Format, {MARKED("core", "has no header; %1"), kExpectedFile});
    if (m_file.swing.readings.empty())
        return wholeFile(ErrorCode::Format, MARKED("core", "has a header but no readings; expected one reading a row below it"));
    tellNorthTwice();
    const auto known = keyNames();
    for (const auto& [key, value] : m_file.otherKeys) // a slip in a key loses what it says
        if (const auto near = nearWord(inSmallLetters(key), known); key != "title" && !near.empty())
            m_file.warnings.push_back({MARKED("core", "the key %1 means nothing here; it is kept in the swing's note (did you mean %2?)"),
                inQuotes(key), std::string(near)});
    for (const auto& [key, value] : m_file.otherKeys)
        m_file.swing.note += (m_file.swing.note.empty() ? "" : "\n") + key + ": " + value;
    if (m_file.swing.note.size() > kLongestText)
        return wholeFile(ErrorCode::InvalidInput,
            {MARKED("core", "note and keys that mean nothing here are %1 bytes together; expected at most %2"), m_file.swing.note.size(),
                kLongestText});
    if (const auto stamped = stampFromKeys(m_file); !stamped)
        return wholeFile(stamped.error().code, stamped.error().message);
    m_file.swing.record = recordIdOfSwing(m_file.swing, m_file.aircraft, m_file.compass, m_file.site);
    return std::move(m_file);
}

} // namespace

Result<SwingFile> readSwingCsv(std::istream& input, const std::string& name, const Progress& progress)
{
    return SwingReader(input, name, progress).read();
}

Result<SwingFile> readSwingCsvFile(const std::string& path, const Progress& progress)
{
    const auto file = openInput(path, MARKED("core", "a Swing CSV"));
    return file ? readSwingCsv(**file, nameOfInput(path), progress) : Result<SwingFile>(file.error());
}

} // namespace lubberline
