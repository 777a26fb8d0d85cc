#include "core/format/csv/RowSplitter.h"

#include "core/base/FileText.h"

namespace lubberline {

RowSplitter::State RowSplitter::begin(std::string_view line)
{
    m_cells.clear();
    m_cell.clear();
    m_place = Place::CellStart;
    m_bytes = 0;
    return take(line);
}

RowSplitter::State RowSplitter::resume(std::string_view line, std::string_view lineBreak)
{
    m_cell += lineBreak;
    return take(line);
}

RowSplitter::State RowSplitter::take(std::string_view line)
{
    m_bytes += line.size() + 1;
    for (const char c : line)
        if (takeByte(c) == State::TextAfterQuote)
            return State::TextAfterQuote;
    if (m_place == Place::Quoted)
        return State::Open;
    endCell();
    return State::Complete;
}

RowSplitter::State RowSplitter::takeByte(char c)
{
    if (m_place == Place::Quoted) {
        if (c == '"')
            m_place = Place::AfterQuote;
        else
            m_cell += c;
        return State::Complete;
    }
    if (c == m_separator) {
        endCell();
    } else if (m_place == Place::AfterQuote) {
        if (c == '"') { // the second of ""
            m_cell += c;
            m_place = Place::Quoted;
        } else if (c != ' ' && c != '\t') {
            return State::TextAfterQuote;
        }
    } else if (c == '"' && (m_place == Place::CellStart || m_cell == "=")) { // ="000": a text, so that a spreadsheet keeps its zeros
        m_cell.clear();
        m_place = Place::Quoted;
    } else {
        m_cell += c;
        if (c != ' ' && c != '\t')
            m_place = Place::Bare;
    }
    return State::Complete;
}

void RowSplitter::endCell()
{
    const bool textFormula = m_cell.size() >= 3 && m_cell.starts_with("=\"") && m_cell.ends_with('"'); // "=""000""", the same in quotes
    if (textFormula)
        m_cell = m_cell.substr(2, m_cell.size() - 3);
    m_cells.push_back(m_place == Place::AfterQuote ? m_cell : std::string(trimmed(m_cell)));
    m_cell.clear();
    m_place = Place::CellStart;
}

Result<void> checkColumns(std::size_t columns)
{
    if (columns > kMostColumns)
        return Error{ErrorCode::Format, {MARKED("core", "there are %1 columns; expected at most %2"), columns, kMostColumns}};
    return {};
}

std::optional<char> toldSeparator(std::string_view line)
{
    constexpr std::string_view kWord = "sep=";
    if (line.starts_with('"'))
        line.remove_prefix(1);
    if (line.size() <= kWord.size() || inSmallLetters(line.substr(0, kWord.size())) != kWord)
        return {};
    const char separator = line[kWord.size()];
    const bool nothingElse = line.find_first_not_of("\",;\t ", kWord.size() + 1) == std::string_view::npos;
    return nothingElse && (separator == '\t' || (separator > ' ' && separator < 0x7F && separator != '"')) ? std::optional(separator)
                                                                                                           : std::nullopt;
}

} // namespace lubberline
