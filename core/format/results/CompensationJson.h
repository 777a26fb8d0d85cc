#pragma once
/// The JSON of `compensate` (the contract of the command line).

#include <string>

#include "core/calibration/Compensation.h"

namespace lubberline {

[[nodiscard]] std::string toJson(const CompensatedLog& compensated, const SensorLog& log);

} // namespace lubberline
