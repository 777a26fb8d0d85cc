#pragma once
/// The files that commands write.

#include <string>

#include "app/commands/Command.h"

namespace lubberline::app {

/// Whether the outputs of the command that was called may be written: none is a file that is named beside it or the database; and whether
/// standard input is named once at most. Errors: those of checkOutput(); InvalidInput.
Result<void> checkOutputs(const CLI::App& app, const Invocation& invocation);

/// "wrote FILE" on standard error.
void sayWritten(const Output& output);

} // namespace lubberline::app
