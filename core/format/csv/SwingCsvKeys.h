#pragma once
/// Private to the Swing CSV: the `# key: value` lines.

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/format/csv/SwingCsv.h"

namespace lubberline::csv {

struct KeyLine {
    std::string_view key, value;
};

/// A line that begins with #, or with "#, as a spreadsheet leaves it: without the empty cells behind it, and out of its quotes.
[[nodiscard]] std::string keyTextOf(std::string_view line, char separator);

/// @return none for a comment: no word of letters, digits and underscores directly followed by a colon.
[[nodiscard]] std::optional<KeyLine> keyLineOf(std::string_view line);

/// The keys that mean something, in small letters.
[[nodiscard]] std::vector<std::string_view> keyNames();
[[nodiscard]] bool isKey(std::string_view name);

/// Takes key lines into a SwingFile, each key once; keys that are known are so in any case.
class KeyReader {
public:
    explicit KeyReader(SwingFile& file) : m_file(file) {}
    /// Errors (without file and line): InvalidInput (a key twice, a value that is not allowed).
    Result<void> take(const KeyLine& line);

private:
    SwingFile& m_file;
    std::set<std::string, std::less<>> m_taken;
};

/// The field stamp of a file that states place and date; where there is none, a warning says why.
/// Errors (without file and line): InvalidInput (latitude without longitude, or the other way round).
Result<void> stampFromKeys(SwingFile& file);

/// The value of every key that the swing states, in the order in which it is written; one line each.
[[nodiscard]] std::string keyLinesOf(const SwingRecord& record);

} // namespace lubberline::csv
