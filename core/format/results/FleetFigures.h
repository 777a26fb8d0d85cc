#pragma once
/// Private to the JSON and the CSV of a fleet.

#include <string>

#include "core/fleet/FleetReport.h"

namespace lubberline {

inline std::string letterAt(std::size_t c) { return std::string(1, letterOf(kCoefficients[c])); }
inline const FleetCompass& compassAt(const FleetSwings& fleet, std::int32_t compass)
{
    return fleet.compasses[static_cast<std::size_t>(compass)];
}
inline int dayAt(const FleetSwings& fleet, std::uint32_t row) { return fleet.swings[row].day; }

} // namespace lubberline
