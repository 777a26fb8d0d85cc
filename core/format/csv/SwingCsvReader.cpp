#include <filesystem>
#include <fstream>

#include "core/base/FileText.h"
#include "core/base/LineReader.h"
#include "core/format/csv/RowSplitter.h"
#include "core/format/csv/SwingCsv.h"
#include "core/format/csv/SwingCsvColumns.h"
#include "core/format/csv/SwingCsvKeys.h"
#include "core/format/csv/SwingCsvRow.h"
#include "core/record/DerivedId.h"

namespace lubberline {

namespace {

using namespace csv;

constexpr Pattern kExpectedFile
    = MARKED("core", "expected a Swing CSV: text in UTF-8 with a header of named columns and one reading a row");
constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";

/// Reads one file. Every step returns the error with file and line filled in.
class SwingReader {
public:
    SwingReader(std::istream& input, const std::string& name, const Progress& progress)
        : m_lines(input, progress)
        , m_name(name)
        , m_keys(m_file)
    {
    }
    Result<SwingFile> read();

private:
    Result<void> checkBeginning();
    Result<bool> nextLine(); ///< false at the end
    Result<void> takeLine();
    Result<void> takeKey();
    Result<bool> splitRow();
    Result<void> takeHeader();
    Result<void> takeReading();
    Result<SwingFile> finish();

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
};

Result<void> SwingReader::checkBeginning()
{
    const std::string_view beginning = m_lines.beginning();
    if (beginning.starts_with("\xFF\xFE") || beginning.starts_with("\xFE\xFF"))
        return wholeFile(ErrorCode::Format, MARKED("core", "is UTF-16; expected UTF-8: save it as \"CSV UTF-8\""));
    return {};
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
    if (m_lines.lineNumber() == 1 && std::string_view(m_line).starts_with(kUtf8Mark))
        m_line.erase(0, kUtf8Mark.size());
    if (!isUtf8(m_line))
        return Error{
            ErrorCode::Format, MARKED("core", "the line is not well-formed UTF-8; expected text in UTF-8"), m_name, m_lines.lineNumber()};
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
    if (content.front() == '#')
        return takeKey();
    if (!m_columns)
        return takeHeader();
    return takeReading();
}

Result<void> SwingReader::takeKey()
{
    const auto line = keyLineOf(trimmed(m_line));
    if (!line)
        return {};
    if (m_columns && line->key == "variation_deg")
        return here(ErrorCode::InvalidInput,
            MARKED("core", "variation_deg stands below the header; expected it above, since the rows are computed with it"));
    const auto taken = m_keys.take(*line);
    return taken ? Result<void>() : Result<void>(here(taken.error()));
}

/// Splits the row that begins in this line; a quoted cell may draw in more lines.
Result<bool> SwingReader::splitRow()
{
    auto state = m_splitter->begin(m_line);
    while (state == RowSplitter::State::Open) {
        const auto more = nextLine();
        if (!more)
            return more.error();
        if (!*more || m_splitter->bytes() + m_line.size() > kMaxLineBytes)
            return here(ErrorCode::Format, MARKED("core", "a quoted cell that begins in this row is not closed; expected a second \""));
        state = m_splitter->resume(m_line);
    }
    if (state == RowSplitter::State::TextAfterQuote)
        return here(ErrorCode::Format,
            MARKED("core", "there is text behind a closing quote; expected a separator there, or \"\" for a quote inside"));
    return true;
}

Result<void> SwingReader::takeHeader()
{
    const char separator = separatorOf(m_line);
    m_splitter.emplace(separator);
    if (const auto split = splitRow(); !split)
        return split.error();
    auto columns = columnsOf(m_splitter->cells());
    if (!columns)
        return here(columns.error());
    m_columns = std::move(columns.value());
    const auto variation_deg = m_file.swing.variation_deg;
    if (m_columns->trueIsDatum() && !variation_deg)
        return here(ErrorCode::InvalidInput,
            MARKED("core",
                "true_heading_deg stands in place of the magnetic heading, but the variation is not stated; expected a line \"# variation_deg: \u2026\" (degrees, east positive) above the header"));
    m_rows.emplace(*m_columns, separator != ',', variation_deg);
    for (const auto& [place, name] : m_columns->unknown)
        m_file.warnings.push_back({MARKED("core", "the column %1 means nothing here; it is kept with the readings"), inQuotes(name)});
    return {};
}

Result<void> SwingReader::takeReading()
{
    if (const auto split = splitRow(); !split)
        return split.error();
    auto reading = m_rows->read(m_splitter->cells());
    if (!reading)
        return here(reading.error());
    if (m_file.swing.readings.size() == kMaxReadings)
        return here(ErrorCode::InvalidInput, {MARKED("core", "there are more than %1 readings; expected a compass swing"), kMaxReadings});
    m_file.swing.readings.push_back(std::move(reading.value()));
    return {};
}

Result<SwingFile> SwingReader::finish()
{
    if (m_lines.lineNumber() == 0)
        return wholeFile(ErrorCode::Format, {MARKED("core", "is empty; %1"), kExpectedFile});
    if (!m_columns)
        return wholeFile(ErrorCode::Format, {MARKED("core", "has no header; %1"), kExpectedFile});
    if (m_file.swing.readings.empty())
        return wholeFile(ErrorCode::Format, MARKED("core", "has a header but no readings; expected one reading a row below it"));
    for (const auto& [key, value] : m_file.otherKeys)
        m_file.swing.note += (m_file.swing.note.empty() ? "" : "\n") + key + ": " + value;
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
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        return Error{ErrorCode::Io, MARKED("core", "is a folder; expected a Swing CSV"), path};
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return Error{ErrorCode::Io, MARKED("core", "cannot be opened; expected a Swing CSV that exists and may be read"), path};
    return readSwingCsv(file, path, progress);
}

} // namespace lubberline
