#pragma once
/// The files that commands write.

#include <string>

#include "app/commands/Command.h"

namespace lubberline::app {

/// Whether the outputs of the command that was called may be written: none is a file that is named beside it or the database.
/// Errors: those of checkOutput().
Result<void> checkOutputs(const CLI::App& app, const Invocation& invocation);

/// "-": then nothing else goes there.
[[nodiscard]] bool isStandardOutput(const std::string& path);

/// Writes what a command made, whole or not at all; "-" is standard output. Errors: those of writeWholeFile().
Result<void> writeOutput(const std::string& path, const std::string& content);

/// "wrote FILE" on standard error.
void sayWritten(const std::string& path);

} // namespace lubberline::app
