#pragma once
/// What `legs` and `continuous` print and write, and the state that is kept from flight to flight.

#include <string>

#include "core/base/Result.h"
#include "core/inflight/ContinuousSwing.h"
#include "core/inflight/Legs.h"

namespace lubberline {

[[nodiscard]] std::string toJson(const LegsSolution& solution);
[[nodiscard]] std::string toJson(const ContinuousResult& result);
/// The history: time_s, each state with its standard error.
[[nodiscard]] std::string historyCsv(const ContinuousResult& result);

[[nodiscard]] std::string stateJson(const ContinuousState& state);
/// Errors: Format (no JSON), InvalidInput (a key, a covariance that is none).
Result<ContinuousState> readStateJson(std::string_view text, const std::string& name);

} // namespace lubberline
