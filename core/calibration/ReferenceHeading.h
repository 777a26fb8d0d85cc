#pragma once
/// Whether a log's reference heading is a reference: one that the calibrated compass made itself sees none of its deviation.

#include <vector>

#include "core/base/Message.h"
#include "core/calibration/SensorLog.h"

namespace lubberline {

/// Why the heading column is the compass's own: level or tilt-compensated headings of the raw field agree with it, but for one angle, to
/// 0.02° and its own rounding in all rows, or differ by what smoothing and delay make. Empty where it is not.
[[nodiscard]] Message headingOfItsOwn(const SensorLog& log, const std::vector<std::uint8_t>& used);

} // namespace lubberline
