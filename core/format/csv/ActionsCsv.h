#pragma once
/// Actions of an interference test: a header `time_s, action`, and an action a row, in order of time.

#include "core/base/Result.h"
#include "core/calibration/Interference.h"

namespace lubberline {

/// Errors: Format, InvalidInput with the line (no number, time that goes back, no action).
Result<std::vector<TimedAction>> readActions(std::istream& input, const std::string& name);
/// Errors: also Io. "-": standard input.
Result<std::vector<TimedAction>> readActionsFile(const std::string& path);
/// As readActions() reads them back.
[[nodiscard]] std::string writeActions(const std::vector<TimedAction>& actions);

} // namespace lubberline
