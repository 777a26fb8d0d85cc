#include "core/nmea/NmeaWind.h"

#include <vector>

namespace lubberline {

std::optional<NmeaWind> windOf(std::span<const TimedHeading> tracks)
{
    std::vector<GroundVelocity> velocities;
    for (const auto& track : tracks)
        if (track.heading_deg && track.speed_kt)
            velocities.push_back({*track.heading_deg, *track.speed_kt});
    const auto air = airMassOf(velocities);
    return air ? std::optional(NmeaWind{*air, false}) : std::nullopt;
}

} // namespace lubberline
