#pragma once
/// How fast the compass card turned at each heading of a log: in a turn a compass lags, and such readings are cut off.

#include <optional>
#include <span>
#include <vector>

#include "core/nmea/NmeaLog.h"

namespace lubberline {

/// [°/s, clockwise positive] for each of the chosen headings, from the neighbours in time; none where the log does not tell the
/// time or its neighbours lie more than ten seconds away.
[[nodiscard]] std::vector<std::optional<double>> turnRates(std::span<const NmeaHeadingEvent> headings);

} // namespace lubberline
