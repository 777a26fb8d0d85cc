#pragma once
/// Small questions about text in files.

#include <concepts>
#include <string>
#include <string_view>

#include "core/base/Message.h"

namespace lubberline {

/// @return whether all of it is well-formed UTF-8 (no overlong forms, no surrogates, nothing beyond U+10FFFF).
[[nodiscard]] bool isUtf8(std::string_view text);

/// What spreadsheets and keyboards write between words: space, tab, no-break space U+00A0, narrow no-break space U+202F, and the other
/// spaces of Unicode. @return the bytes of the one that begins the text; 0: it begins with none.
[[nodiscard]] std::size_t spaceAt(std::string_view text);
/// Without those spaces at both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);
/// Of a text that nobody keeps, a text of its own: a view into it would outlive it.
template <std::same_as<std::string> Text>
[[nodiscard]] std::string trimmed(Text&& text)
{
    return std::string(trimmed(std::string_view(text)));
}
/// Small letters; only those of ASCII are changed.
[[nodiscard]] std::string inSmallLetters(std::string_view text);

/// In quotes for an error message: cut to a readable length. What the eye cannot see (control characters, no-break spaces, marks without
/// width) stands there by its code point, as [U+200B].
[[nodiscard]] std::string inQuotes(std::string_view text);
/// The same for figures: letters and digits of other scripts, which look like ours, are followed by their code point.
[[nodiscard]] std::string figuresInQuotes(std::string_view text);

/// Why text that should be UTF-8 cannot be: of the beginning of a file that is UTF-16 or UTF-32, with or without a byte order mark.
/// Empty where nothing speaks against UTF-8 so far.
[[nodiscard]] Message otherEncoding(std::string_view beginning);
/// Why a line is not UTF-8, naming its first byte that is none and what to do; empty when it is.
[[nodiscard]] Message notUtf8(std::string_view line);

inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF"; ///< that may begin a file in UTF-8

} // namespace lubberline
