#pragma once
/// What `winds` prints and writes (the contract of the command line).

#include <string>

#include "core/inflight/WindStudy.h"

namespace lubberline {

/// One JSON object; every key carries its unit, what cannot be told is null.
[[nodiscard]] std::string toJson(const WindResult& result, TableFactor factor);
/// A row an aircraft and heading: what is to be uploaded, with its factor.
[[nodiscard]] std::string windTableCsv(const WindResult& result, TableFactor factor);
/// "paper", "exact", "none".
[[nodiscard]] const char* nameOf(TableFactor factor);

} // namespace lubberline
