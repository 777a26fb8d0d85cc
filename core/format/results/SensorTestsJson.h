#pragma once
/// The JSON of `spectrum`, `coil` and `interference` (the contract of the command line).

#include <string>

#include "core/calibration/CoilBench.h"
#include "core/calibration/Interference.h"
#include "core/calibration/Spectrum.h"

namespace lubberline {

[[nodiscard]] std::string toJson(const LogSpectrum& spectrum, const SensorLog& log);
[[nodiscard]] std::string toJson(const CoilResult& result, const SensorLog& log);
[[nodiscard]] std::string toJson(const InterferenceResult& result, const SensorLog& log);

} // namespace lubberline
