#pragma once
/// Reads JSON text strictly: well-formed, no key twice, not deeper than our formats are.

#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "core/base/Result.h"

namespace lubberline {

/// Errors: Format (empty; not JSON: line and column; a key twice or nesting too deep: its path), InvalidInput (a number that no
/// double can hold: its path). `name` is the file named in errors, `expected` what it should have been.
Result<nlohmann::json> parseJson(std::string_view text, const std::string& name, const Message& expected);

} // namespace lubberline
