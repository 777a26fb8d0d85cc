#pragma once
/// Swings whose deviations may have been written with the other sign. D is soft iron: it is alike in all aircraft of a type, and no
/// correction changes it. A swing whose D lies where the type's would with its sign turned, and not where the type's is, is suspect.
/// Nothing is turned: the record may be right, and another convention is only its likeliest reason.

#include "core/fleet/FleetCurves.h"

namespace lubberline {

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
