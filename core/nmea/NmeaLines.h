#pragma once
/// Cuts a stream of bytes into lines, however it arrives: half sentences are kept until the rest comes, a line that never ends
/// is given up (it is babble, no sentence), CR, LF and both end a line.

#include <functional>
#include <string>
#include <string_view>

namespace lubberline {

/// Longer than any sentence (82 characters) with what loggers put before it.
inline constexpr std::size_t kMaxNmeaLine = 1024;

class NmeaLines {
public:
    using Each = std::function<void(std::string_view line)>;
    /// Calls `each` for every line that ends within these bytes; a line that is too long is given once, cut.
    void feed(std::string_view bytes, const Each& each);
    /// What stands without a line end at the end of a file.
    void finish(const Each& each);

private:
    std::string m_line;
    bool m_givenUp = false; ///< the rest of a line that was too long
};

} // namespace lubberline
