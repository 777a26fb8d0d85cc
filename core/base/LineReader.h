#pragma once
/// Lines of a text file through one fixed buffer, whatever the size of the file.

#include <cstdint>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/Progress.h"

namespace lubberline {

/// A longer line is no line of text: the file is binary.
inline constexpr std::size_t kMaxLineBytes = std::size_t{1} << 20;

enum class LineOutcome { Line, End, Binary, ReadError, Cancelled };

class LineReader {
public:
    /// `progress` is told how much of a seekable stream is read, each time that the buffer is filled.
    LineReader(std::istream& input, const Progress& progress);

    /// The first bytes of the file, at most one buffer, before any line is taken.
    [[nodiscard]] std::string_view beginning();

    /// The next line without its LF or CRLF, or without its CR where the file has no LF. Binary: a NUL byte, or longer than kMaxLineBytes.
    LineOutcome next(std::string& line);

    /// Whether the line that next() gave last ended in CRLF.
    [[nodiscard]] bool endedInCrLf() const { return m_crLf; }

    /// Of the line that next() gave last; 1-based.
    [[nodiscard]] std::int64_t lineNumber() const { return m_lineNumber; }

private:
    LineOutcome fill();
    [[nodiscard]] std::string_view unread() const { return {m_buffer.data() + m_position, m_filled - m_position}; }

    std::istream& m_input;
    Progress m_progress; ///< its own: callers may give a temporary
    std::vector<char> m_buffer;
    std::size_t m_position = 0, m_filled = 0;
    std::int64_t m_size = 0; ///< 0: not known
    std::int64_t m_read = 0;
    std::int64_t m_lineNumber = 0;
    char m_end = 0; ///< of a line; 0: not known yet
    bool m_crLf = false;
};

} // namespace lubberline
