#pragma once
/// Cuts a stream of bytes into lines, however it arrives: half sentences are kept until the rest comes, CR, LF and both end a line.
/// A line that does not end (JSON, binary) is cut before its newest `$`; without one it is babble and given up until the next.

#include <functional>
#include <string>
#include <string_view>

namespace lubberline {

/// Longer than any sentence (82 characters) with what loggers put before it.
inline constexpr std::size_t kMaxNmeaLine = 1024;

class NmeaLines {
public:
    using Each = std::function<void(std::string_view line)>;
    /// Calls `each` for every line that ends within these bytes, and for each piece of one that is too long.
    void feed(std::string_view bytes, const Each& each);
    /// What stands without a line end at the end of a file.
    void finish(const Each& each);

private:
    void giveUp(const Each& each);

    std::string m_line;
    bool m_givenUp = false; ///< the rest of a line that was too long
};

} // namespace lubberline
