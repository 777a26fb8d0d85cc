#pragma once
/// What a log itself says against its reference: another source that disagrees with it, or headings that only repeat the compass.

#include <optional>
#include <vector>

#include "core/nmea/NmeaLog.h"
#include "core/nmea/NmeaSwing.h"
#include "core/nmea/NmeaTimes.h"

namespace lubberline {

struct NmeaContradiction {
    Message told;
    double ofA_deg = 0; ///< standard error of A that it brings: the rms of "this one is right" and "the other one is"; 0: none
};

/// Every other source that may tell what the reference tells, and lies further from it than noise explains: a second receiver's track or
/// true heading by its mean; a track on wheels beside a true or a second magnetic heading by how it varies over the headings.
/// @param leastSpeed_kt below it a track is noise.
[[nodiscard]] std::vector<NmeaContradiction> contradictionsOf(
    const NmeaLog& log, const NmeaStream& reference, const NmeaStream& compass, const NmeaTimes& times, double leastSpeed_kt);

/// Says so where the reference differs from the compass by one figure at all headings, within what both are written to: no second
/// instrument agrees so well, and one that is made of the compass (by a multiplexer, a plotter, an autopilot) shows no deviation.
[[nodiscard]] std::optional<Message> doubtOfRepetition(
    const NmeaStream& reference, const NmeaStream& compass, const std::vector<NmeaPair>& pairs);

struct NmeaJumps {
    std::size_t away = 0;      ///< tracks that jump away from the compass for moments: multipath, a receiver that hardly moves
    std::size_t backwards = 0; ///< tracks of the opposite sense: the aircraft was pushed back
};

/// Takes out the tracks that are no heading of the aircraft, which does not turn by itself what its compass does not see; left in, they
/// look like turns the other way, and A and a delay seem to be told apart. Nothing is taken out where most would be.
/// @param tracks, compass in order of time; what is taken out has no heading any more.
NmeaJumps takeOutJumps(std::vector<TimedHeading>& tracks, const std::vector<TimedHeading>& compass);

} // namespace lubberline
