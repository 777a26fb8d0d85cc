#pragma once
/// Swings whose deviations may have been written with the other sign. D is soft iron: it is alike in all aircraft of a type, and no
/// correction changes it. A swing whose D lies where the type's would with its sign turned, and not where the type's is, is suspect.
/// Nothing is turned: the record may be right, and another convention is only its likeliest reason.

#include <span>
#include <vector>

#include "core/fleet/FleetCurves.h"

namespace lubberline {

/// D of one swing, as much as is needed to hold its sign against its type's.
struct DOfSwing {
    std::int32_t compass = 0, kind = 0; ///< those of one kind have one D
    double D_deg = 0, variance_deg2 = 0;
};

struct SuspectCompass {
    std::int32_t compass = 0;
    std::vector<std::size_t> swings; ///< places of the suspect ones
    std::size_t all = 0;             ///< swings of this compass that tell D
    double D_deg = 0, siblingsD_deg = 0;
};
/// By compass. Kinds count from 0.
[[nodiscard]] std::vector<SuspectCompass> suspectSigns(std::span<const DOfSwing> swings);

struct SignSuspicion {
    std::int32_t compass = 0;
    std::vector<std::uint32_t> rows;     ///< of FleetSwings::swings, its suspect swings
    std::size_t swings = 0;              ///< of this compass that tell D
    double D_deg = 0, siblingsD_deg = 0; ///< median of the suspect ones, and of the compasses that are not suspect
};

/// By compass. Kinds with fewer than four compasses that tell D, or a D that is not clear of nothing, say nothing.
[[nodiscard]] std::vector<SignSuspicion> suspectSigns(const FleetSwings& fleet, const FleetCurves& curves);
[[nodiscard]] Message inWords(const SignSuspicion& suspicion, const FleetSwings& fleet);

} // namespace lubberline
