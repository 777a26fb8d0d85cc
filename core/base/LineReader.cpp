#include "core/base/LineReader.h"

#include <algorithm>

namespace lubberline {

namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 16;

std::int64_t bytesAhead(std::istream& input)
{
    const auto here = input.tellg();
    if (here == std::istream::pos_type(-1)) {
        input.clear(); // a pipe: its size is not known
        return 0;
    }
    input.seekg(0, std::ios::end);
    const auto end = input.tellg();
    input.clear();
    input.seekg(here);
    return static_cast<std::int64_t>(end - here);
}

/// Old programs of the Macintosh end lines by CR alone. A CR that is the last byte may have its LF in the next buffer.
char endOfLines(std::string_view beginning)
{
    const auto carriageReturn = beginning.find('\r');
    const bool alone = carriageReturn != std::string_view::npos && carriageReturn + 1 < beginning.size();
    return alone && beginning.find('\n') == std::string_view::npos ? '\r' : '\n';
}

} // namespace

LineReader::LineReader(std::istream& input, const Progress& progress) : m_input(input), m_progress(progress), m_buffer(kBufferBytes)
{
    if (progress)
        m_size = bytesAhead(input);
}

std::string_view LineReader::beginning()
{
    if (m_filled == 0)
        static_cast<void>(fill()); // a failure shows again in next()
    return unread();
}

LineOutcome LineReader::fill()
{
    const double fraction = m_size > 0 ? std::min(1.0, static_cast<double>(m_read) / static_cast<double>(m_size)) : 0.0;
    if (m_progress && !m_progress(fraction))
        return LineOutcome::Cancelled;
    m_input.read(m_buffer.data(), static_cast<std::streamsize>(m_buffer.size()));
    m_position = 0;
    m_filled = static_cast<std::size_t>(m_input.gcount());
    m_read += static_cast<std::int64_t>(m_filled);
    if (m_input.bad())
        return LineOutcome::ReadError;
    return m_filled == 0 ? LineOutcome::End : LineOutcome::Line;
}

LineOutcome LineReader::next(std::string& line)
{
    line.clear();
    bool any = false, ended = false;
    for (;;) {
        if (m_position == m_filled) {
            const LineOutcome outcome = fill();
            if (outcome == LineOutcome::End && any)
                break;
            if (outcome != LineOutcome::Line)
                return outcome;
        }
        if (!any)
            ++m_lineNumber;
        any = true;
        const std::string_view rest = unread();
        if (m_end == 0)
            m_end = endOfLines(rest);
        const auto length = std::min(rest.find(m_end), rest.size());
        const std::string_view part = rest.substr(0, length);
        if (part.find('\0') != std::string_view::npos || line.size() + length > kMaxLineBytes)
            return LineOutcome::Binary;
        line += part;
        m_position += length;
        if (length < rest.size()) {
            ++m_position;
            ended = true;
            break;
        }
    }
    m_crLf = ended && line.ends_with('\r');
    if (line.ends_with('\r'))
        line.pop_back();
    return LineOutcome::Line;
}

} // namespace lubberline
