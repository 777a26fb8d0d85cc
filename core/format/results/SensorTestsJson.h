#pragma once
/// The JSON of `spectrum`, `coil`, `interference`, `locate` and `site-check` (the contract of the command line).

#include <string>

#include "core/calibration/DipoleSource.h"
#include "core/calibration/Interference.h"
#include "core/calibration/Spectrum.h"
#include "core/coil/CoilHistory.h"
#include "core/deviation/TurnedBothWays.h"

namespace lubberline {

[[nodiscard]] std::string toJson(const LogSpectrum& spectrum, const SensorLog& log);
[[nodiscard]] std::string toJson(const CoilResult& result, const SensorLog& log);
/// Of `coil --history`: each with its result and its drift since the one before it, newest first.
[[nodiscard]] std::string toJson(const std::vector<CoilBench>& benches);
[[nodiscard]] std::string toJson(const InterferenceResult& result, const SensorLog& log);

[[nodiscard]] std::string toJson(const DipoleSource& source);
[[nodiscard]] std::string toJson(const BothWays& both);

} // namespace lubberline
