#pragma once
/// One NMEA 0183 sentence: `$` talker, type, fields, `*` and the exclusive or of all that stands between, in two hexadecimal
/// digits.

#include <string>
#include <string_view>
#include <vector>

namespace lubberline {

struct NmeaSentence {
    std::string talker; ///< "HC", "GP", "II"; "P" for proprietary sentences
    std::string type;   ///< "HDG", "RMC"; what follows the P of a proprietary one
    std::vector<std::string> fields;
    bool hasChecksum = false;
    [[nodiscard]] std::string_view field(std::size_t index) const
    {
        return index < fields.size() ? std::string_view(fields[index]) : std::string_view();
    }
};

enum class NmeaFault {
    None,
    NotASentence, ///< no `$` or `!` with an address behind it, control characters, half a sentence
    BadChecksum,
};

struct ParsedNmea {
    NmeaFault fault = NmeaFault::NotASentence;
    NmeaSentence sentence;
};

/// All that a line holds, in order: loggers put time stamps before a sentence and text behind its checksum, wrap it in quotes,
/// brackets or braces, write several on a line, or binary messages between them; a second `$` begins anew. What lies outside is
/// passed over. A sentence without `*` is read, too (hasChecksum tells): it ends with the line, or before what wraps it.
/// A line without any sentence gives one NotASentence, a blank one nothing.
[[nodiscard]] std::vector<ParsedNmea> nmeaSentences(std::string_view line);

/// The exclusive or of the characters, as the standard's checksum.
[[nodiscard]] unsigned char nmeaChecksum(std::string_view betweenDollarAndStar);

/// `$` body `*hh`, without a line end: for tests and for replaying.
[[nodiscard]] std::string makeNmea(std::string_view body);

} // namespace lubberline
