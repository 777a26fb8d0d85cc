#pragma once
/// Small text files, read at once.

#include <string>

#include "core/base/Result.h"

namespace lubberline {

/// A larger file is refused before it takes memory.
inline constexpr std::size_t kMaxWholeFileBytes = std::size_t{64} << 20;

/// @param expected what the file should be, for messages: MARKED("core", "a Model JSON"). Errors: Io (a folder, not there, unreadable), Format
/// (too large).
Result<std::string> readWholeFile(const std::string& path, const Message& expected);

} // namespace lubberline
