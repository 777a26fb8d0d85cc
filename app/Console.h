#pragma once
/// What commands say: results on standard output, messages and progress on standard error.

#include <string>
#include <string_view>
#include <vector>

#include "core/base/Progress.h"
#include "core/base/Result.h"

namespace lubberline::app {

/// Exit statuses of the command line.
enum ExitStatus { kDone = 0, kFailed = 1, kUsage = 2 };

/// printf to standard output; what a terminal would act on is escaped (core/base/TerminalText.h).
void put(const char* format, ...) __attribute__((format(printf, 1, 2)));
void putText(std::string_view text);
/// The end of a command: what it printed has arrived, or it has failed. @return `status`, or kFailed.
[[nodiscard]] int whenPrinted(int status);

/// "lubberline: FILE:LINE: what is wrong and what was expected" on standard error. @return kFailed.
int fail(const Error& error);
/// "lubberline: warning: …" on standard error, a line each.
void warn(const std::vector<Message>& warnings);
/// "lubberline: …" on standard error.
void say(const std::string& message);

/// Shows a percentage when standard error is a terminal; cancels when the user presses Ctrl-C, so that the command can end
/// with its files and database as they were.
[[nodiscard]] Progress consoleProgress(const std::string& what);

/// printf into a string: for the columns of tables.
[[nodiscard]] std::string text(const char* format, ...) __attribute__((format(printf, 1, 2)));

/// "1 swing", "2 swings": of a word that takes an s.
[[nodiscard]] std::string counted(std::int64_t count, const char* one);

} // namespace lubberline::app
