#pragma once
/// The JSON of `fleet` (the contract of the command line), and its tables as CSV.

#include <string>

#include "core/fleet/FleetReport.h"

namespace lubberline {

[[nodiscard]] std::string toJson(const FleetReport& report, const FleetSwings& fleet);

/// The tables one after the other, each with its name in a line "# …" before its head, and an empty line between.
[[nodiscard]] std::string toCsv(const FleetReport& report, const FleetSwings& fleet);

} // namespace lubberline
