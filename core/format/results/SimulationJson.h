#pragma once
/// The JSON of `smith`, `simulate` and `compensator` (the contract of the command line): every key carries its unit, what does not exist is
/// null.

#include <span>
#include <string>

#include "core/sensor/Compensator.h"
#include "core/sensor/PoissonSmith.h"
#include "core/sensor/SensorReading.h"

namespace lubberline {

/// One JSON object each, two spaces of indentation, no newline at the end; never NaN or infinity.
[[nodiscard]] std::string toJson(const PoissonSmith& smith, const MeridianField& field);
[[nodiscard]] std::string toJson(std::span<const SensorReading> points, const MeridianField& field);

[[nodiscard]] std::string toJson(const CompensatorResult& result, const AttitudeRange& range, double limit_deg);

} // namespace lubberline
