#pragma once
/// The JSON of `calibrate` (the contract of the command line).

#include <string>

#include "core/calibration/AttitudeFit.h"

namespace lubberline {

/// What is not determined is null, never a number.
[[nodiscard]] std::string toJson(const EllipsoidResult& result, const SensorLog& log, EllipsoidShape shape);
[[nodiscard]] std::string toJson(const AttitudeResult& result, const SensorLog& log, const MeridianField& field);

/// "ellipsoid", "axes", "sphere".
[[nodiscard]] std::string_view nameOf(EllipsoidShape shape);

} // namespace lubberline
