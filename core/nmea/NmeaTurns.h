#pragma once
/// The two ways round of a turn, held against each other.

#include <optional>
#include <span>

#include "core/nmea/NmeaSwing.h"

namespace lubberline {

/// What each way round makes of the coefficients; none where one of the two is missing or too short.
/// @param rates_deg_s how fast the aircraft turned at each used pair, in their order
[[nodiscard]] std::optional<NmeaDirections> directionsOf(std::span<const NmeaPair> pairs, std::span<const double> rates_deg_s);

} // namespace lubberline
