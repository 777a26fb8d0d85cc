#pragma once
/// Reads JSON text strictly: well-formed, no key twice, not deeper than our formats are.

#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "core/base/Result.h"

namespace lubberline {

/// A larger text is refused before it takes memory, by who reads it and by parseJson(). With its values, which have a limit of their own, a
/// hostile one stays under 512 MB; a fleet of 10,000 swings of twelve headings takes 12 MiB, each signed by two keys some 100.
inline constexpr std::size_t kMostJsonBytes = std::size_t{128} << 20;

/// Errors: Format (empty; too large, or a text in it; not JSON: line and column; a key twice or nesting too deep: its path), InvalidInput (a number that no
/// double can hold: its path). `name` is the file named in errors, `expected` what it should have been.
Result<nlohmann::json> parseJson(std::string_view text, const std::string& name, const Message& expected);

} // namespace lubberline
