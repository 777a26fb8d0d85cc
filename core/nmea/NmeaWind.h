#pragma once
/// Wind in a turn, from the tracks of a log (core/inflight/AirMass.h).

#include <optional>
#include <span>

#include "core/inflight/AirMass.h"
#include "core/nmea/HeadingLine.h"

namespace lubberline {

/// No aircraft taxies faster: what is, flies, and the wind carries its track away from its heading.
inline constexpr double kFlies_kt = 25.0;

struct NmeaWind : AirMass {
    bool takenOut = false;
};

/// @param tracks in order of time; those without speed or track are passed over. None where the directions do not determine it.
[[nodiscard]] std::optional<NmeaWind> windOf(std::span<const TimedHeading> tracks);

} // namespace lubberline
