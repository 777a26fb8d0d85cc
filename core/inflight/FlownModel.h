#pragma once
/// A sensor model that is kept with a compass, and what a continuous swing makes of it: the whole model goes from flight to flight.

#include <optional>

#include "core/inflight/ContinuousSwing.h"
#include "core/record/SensorRecord.h"

namespace lubberline {

/// Where a continuous swing of the whole model begins after this one. With its mount, its constant fields and the circuits that are on, as
/// the heading is read with them; a scale that all axes share turns no heading. None: how sure it is, is not known, or some of it is not.
/// @param horizontal_nT  that P, Q and R are counted over
[[nodiscard]] std::optional<ContinuousState> stateOf(const SensorRecord& sensor, double horizontal_nT);

/// What a flight tells of the model, to be kept: k is 0, loads are left out. Where the errors of its reference lasted longer than an update,
/// what this flight added is as much less sure; what was known before it stays as sure as it was. None: not all of the model is told.
/// @param before  where it began
[[nodiscard]] std::optional<SensorRecord> flownModel(const ContinuousResult& result, const std::optional<ContinuousState>& before);

} // namespace lubberline
