#pragma once
/// The one way in which files are opened for reading; small ones are read at once.

#include <istream>
#include <memory>
#include <string>

#include "core/base/Result.h"

namespace lubberline {

/// "-" as the name of a file to read is standard input, and of a file to write standard output.
[[nodiscard]] inline bool isStandardStream(std::string_view path) { return path == "-"; }
/// What messages call it: the path, or "standard input".
[[nodiscard]] std::string nameOfInput(const std::string& path);

/// @param expected as below. Errors: Io (a folder, not there, unreadable).
Result<std::unique_ptr<std::istream>> openInput(const std::string& path, const Message& expected);

/// A larger file is refused before it takes memory.
inline constexpr std::size_t kMaxWholeFileBytes = std::size_t{64} << 20;

/// @param expected what the file should be, for messages: MARKED("core", "a Model JSON"). Errors: Io (a folder, not there, unreadable), Format
/// (too large).
Result<std::string> readWholeFile(const std::string& path, const Message& expected, std::size_t mostBytes = kMaxWholeFileBytes);

} // namespace lubberline
