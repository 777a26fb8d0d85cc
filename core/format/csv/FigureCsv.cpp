#include "core/format/csv/FigureCsv.h"

#include <algorithm>
#include <bit>
#include <limits>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "core/base/FileText.h"
#include "core/base/Number.h"
#include "core/base/PlainNumber.h"
#include "core/format/csv/ColumnName.h"

namespace lubberline {

namespace {

constexpr std::size_t kMostComments = 1000,
                      kMostCommentBytes = std::size_t{4}
    << 20; ///< above a header; of a file that has no other lines memory is not taken for all

/// Where cells part, and what else a line holds, in one look at each byte.
struct Looked {
    bool quoted = false, ascii = true;
};

/// @param ends the places of the separator, and the line's end
Looked lookAt(std::string_view text, char separator, std::vector<std::uint32_t>& ends)
{
    ends.clear();
    Looked looked;
    std::size_t at = 0;
#ifdef __SSE2__
    const __m128i parting = _mm_set1_epi8(separator), quote = _mm_set1_epi8('"');
    int high = 0, quotes = 0;
    for (; at + 16 <= text.size(); at += 16) {
        const __m128i bytes = _mm_loadu_si128(reinterpret_cast<const __m128i*>(text.data() + at));
        high |= _mm_movemask_epi8(bytes);
        quotes |= _mm_movemask_epi8(_mm_cmpeq_epi8(bytes, quote));
        for (auto places = static_cast<unsigned>(_mm_movemask_epi8(_mm_cmpeq_epi8(bytes, parting))); places != 0; places &= places - 1)
            ends.push_back(static_cast<std::uint32_t>(at) + static_cast<std::uint32_t>(std::countr_zero(places)));
    }
    looked = {quotes != 0, high == 0};
#endif
    for (; at < text.size(); ++at) {
        looked.quoted = looked.quoted || text[at] == '"';
        looked.ascii = looked.ascii && static_cast<unsigned char>(text[at]) < 0x80;
        if (text[at] == separator)
            ends.push_back(static_cast<std::uint32_t>(at));
    }
    ends.push_back(static_cast<std::uint32_t>(text.size()));
    return looked;
}

char separatorByKnown(const std::string& header, std::span<const std::string_view> known, char told)
{
    if (told != 0)
        return told;
    char best = ',';
    std::ptrdiff_t most = -1;
    for (const char separator : {',', ';', '\t'}) {
        RowSplitter splitter(separator);
        if (splitter.begin(header) != RowSplitter::State::Complete)
            continue;
        const auto found = std::count_if(splitter.cells().begin(), splitter.cells().end(), [&](const std::string& cell) {
            const std::string name = csv::columnKey(cell);
            return std::any_of(known.begin(), known.end(), [&](std::string_view one) { return name.starts_with(one); });
        });
        if (found > most) {
            most = found;
            best = separator;
        }
    }
    return best;
}

} // namespace

FigureCsv::FigureCsv(std::istream& input, std::string name, Message expected, const Progress& progress)
    : m_lines(input, progress)
    , m_name(std::move(name))
    , m_expected(std::move(expected))
{
}

Result<bool> FigureCsv::nextLine()
{
    switch (m_lines.next(m_text)) {
    case LineOutcome::Line: break;
    case LineOutcome::End: return false;
    case LineOutcome::Binary:
        return wholeFile({MARKED("core", "is binary: it has NUL bytes or lines of more than 1 MiB; expected %1"), m_expected});
    case LineOutcome::ReadError: return Error{ErrorCode::Io, MARKED("core", "cannot be read to its end"), m_name};
    case LineOutcome::Cancelled: return Error{ErrorCode::Cancelled, MARKED("core", "reading was cancelled"), m_name};
    }
    m_line = m_lines.lineNumber();
    if (m_line == 1 && std::string_view(m_text).starts_with(kByteOrderMark))
        m_text.erase(0, kByteOrderMark.size());
    const Looked looked = lookAt(m_text, m_separator, m_ends);
    m_quoted = looked.quoted;
    if (!looked.ascii)
        if (const Message bytes = notUtf8(m_text); !bytes.empty())
            return Error{ErrorCode::Format, bytes, m_name, m_line};
    return true;
}

/// Of a row without quotes.
void FigureCsv::splitBare()
{
    m_cells.resize(m_ends.size());
    std::size_t begin = 0;
    const auto isPlain = [](char c) { return static_cast<unsigned char>(c - '!') < 0x80 - '!'; };
    for (std::size_t i = 0; i < m_ends.size(); ++i) {
        const std::size_t end = m_ends[i];
        std::string_view cell(m_text.data() + begin, end - begin);
        if (!cell.empty() && !(isPlain(cell.front()) && isPlain(cell.back())))
            cell = trimmed(cell);
        m_cells[i] = cell;
        begin = end + 1;
    }
}

Result<void> FigureCsv::split()
{
    if (!m_quoted) {
        splitBare();
        return {};
    }
    m_cells.clear();
    if (m_splitter.begin(m_text) != RowSplitter::State::Complete)
        return Error{
            ErrorCode::Format, MARKED("core", "a quoted cell does not end in this row; expected figures and short texts"), m_name, m_line};
    for (const std::string& cell : m_splitter.cells())
        m_cells.push_back(trimmed(cell));
    return {};
}

Result<void> FigureCsv::readHeader(std::span<const std::string_view> known)
{
    if (const Message other = otherEncoding(m_lines.beginning()); !other.empty())
        return wholeFile(other);
    char told = 0;
    std::size_t commentBytes = 0;
    for (;;) {
        const auto more = nextLine();
        if (!more)
            return more.error();
        if (!*more)
            return wholeFile(
                {m_line == 0 ? MARKED("core", "is empty; expected %1") : MARKED("core", "has no header; expected %1"), m_expected});
        const std::string_view content = trimmed(m_text);
        if (content.starts_with('#') || content.starts_with("\"#")) {
            if (m_comments.size() < kMostComments && content.size() <= kMostCommentBytes - commentBytes) {
                commentBytes += content.size();
                m_comments.emplace_back(content);
            }
            continue;
        }
        if (content.empty())
            continue;
        if (const auto separator = toldSeparator(content)) {
            told = *separator;
            continue;
        }
        break;
    }
    m_separator = separatorByKnown(m_text, known, told);
    m_splitter = RowSplitter(m_separator);
    m_quoted = lookAt(m_text, m_separator, m_ends).quoted;
    if (const auto row = split(); !row)
        return row;
    while (!m_cells.empty() && m_cells.back().empty())
        m_cells.pop_back();
    if (const auto few = checkColumns(m_cells.size()); !few)
        return here(few.error().message);
    for (const auto cell : m_cells) {
        std::string name = csv::columnKey(cell);
        if (!name.empty() && std::find(m_columns.begin(), m_columns.end(), name) != m_columns.end())
            return here({MARKED("core", "the column %1 stands there twice; expected each once"), inQuotes(name)});
        m_columns.push_back(std::move(name));
    }
    return {};
}

std::optional<std::size_t> FigureCsv::column(std::string_view name) const
{
    const auto found = std::find(m_columns.begin(), m_columns.end(), name);
    return found == m_columns.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - m_columns.begin()));
}

Result<std::optional<FigureColumn>> FigureCsv::column(std::string_view name, std::span<const UnitSuffix> units) const
{
    std::optional<FigureColumn> found;
    std::string first;
    for (const auto& unit : units) {
        const std::string full = std::string(name) + std::string(unit.suffix);
        const auto place = column(full);
        if (!place)
            continue;
        if (found)
            return Error{ErrorCode::InvalidInput,
                {MARKED("core", "the columns %1 and %2 say the same; expected one of them"), inQuotes(first), inQuotes(full)}, m_name,
                m_line};
        found = FigureColumn{*place, unit.factor};
        first = full;
    }
    return found;
}

Result<bool> FigureCsv::next()
{
    for (;;) {
        const auto more = nextLine();
        if (!more || !*more)
            return more;
        if (m_text.empty() || m_text.front() == '#' || m_text.starts_with("\"#"))
            continue;
        if (!m_quoted)
            splitBare();
        else if (const auto row = split(); !row)
            return row.error();
        while (m_cells.size() > m_columns.size() && m_cells.back().empty())
            m_cells.pop_back();
        if (std::all_of(m_cells.begin(), m_cells.end(), [](std::string_view cell) { return cell.empty(); }))
            continue;
        if (m_cells.size() > m_columns.size())
            return Error{ErrorCode::Format,
                {MARKED("core", "has %1 cells; expected the %2 of the header"), m_cells.size(), m_columns.size()}, m_name, m_line};
        return true;
    }
}

bool FigureCsv::takePlain(std::string_view text, double& value)
{
    if (text.empty()) {
        value = std::numeric_limits<double>::quiet_NaN();
        return true;
    }
    return takePlainNumber(text, value);
}

bool FigureCsv::takeOther(std::string_view text, double& value) const
{
    const std::string word = inSmallLetters(text);
    if (word == "nan" || word == "na" || word == "null" || word == "n/a") {
        value = std::numeric_limits<double>::quiet_NaN();
        return true;
    }
    const FileNumber number = readNumber(text, true); // a comma that parts cells is not in one
    value = number.value;
    return number.fault == NumberFault::None;
}

Error FigureCsv::noName(std::size_t place) const
{
    return here({MARKED("core", "%1 has %2 bytes; expected at most %3"), m_columns[place], cell(place).size(), kLongestName});
}

Error FigureCsv::noFigure(std::size_t place) const
{
    return here({MARKED("core", "%1 %2 is no figure; expected a number, or nothing where it is missing"), m_columns[place],
        figuresInQuotes(cell(place))});
}

} // namespace lubberline
