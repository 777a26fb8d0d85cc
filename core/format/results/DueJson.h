#pragma once
/// The JSON of `due` (the contract of the command line).

#include <span>
#include <string>

#include "core/due/DueList.h"

namespace lubberline {

/// {"today", "compasses": [{"type", "aircraft", "compass", "compass_record", "state", "last_signed", "next_by_calendar",
/// "flags": [{"state", "since", "reason", "event"}]}], "warnings"}. Dates ISO 8601; a date or event that there is none of is
/// null.
[[nodiscard]] std::string toJson(std::span<const DueLine> lines, std::span<const Message> warnings, Date today);

} // namespace lubberline
