#pragma once
/// Small questions about text in files.

#include <string>
#include <string_view>

namespace lubberline {

/// @return whether all of it is well-formed UTF-8 (no overlong forms, no surrogates, nothing beyond U+10FFFF).
[[nodiscard]] bool isUtf8(std::string_view text);

/// @return whether it is YYYY-MM-DD and a day of the calendar: 2024-02-29 is, 2023-02-29 is not.
[[nodiscard]] bool isIsoDate(std::string_view text);

/// Without spaces and tabs at both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// In quotes for an error message: cut to a readable length, control characters shown as '?'.
[[nodiscard]] std::string inQuotes(std::string_view text);

} // namespace lubberline
