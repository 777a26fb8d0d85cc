#pragma once
/// Deviation from legs by GPS alone: three or more legs at one airspeed in one air mass give the wind, so the true heading of each leg, and
/// with what the compass read there its deviation.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/Result.h"
#include "core/inflight/AirMass.h"

namespace lubberline {

struct Leg {
    std::string name;
    double track_deg = 0, groundSpeed_kt = 0; ///< true; the mean along the leg
    std::optional<double> compassHeading_deg; ///< the mean
    std::optional<double> variation_deg;      ///< east positive
    int samples = 1;
};

struct SolvedLeg {
    Leg leg;
    double trueHeading_deg = 0;
    double standardError_deg = 0; ///< of the heading: of the wind and of the leg's own velocity
    std::optional<double> magneticHeading_deg;
    std::optional<double> deviation_deg; ///< magnetic − compass
    double offCircle_kt = 0;             ///< airspeed of the leg less that of all
};

struct LegsSolution {
    AirMass air;
    double variationError_deg = 0; ///< as stated
    double legError_deg = 0;       ///< of each heading by itself, across the leg: no part of the wind's
    std::vector<SolvedLeg> legs;
    std::vector<Message> warnings;
};

struct LegsOptions {
    double speedError_kt = 0.5;          ///< of the mean ground velocity of a leg: GPS, and an airspeed that was not quite held
    std::optional<double> variation_deg; ///< for legs that state none
    double variationError_deg = 0;       ///< of all that are stated; 0: not known
};

/// Errors: InvalidInput (fewer than three legs), Numeric (directions on too short an arc).
Result<LegsSolution> solveLegs(std::span<const Leg> legs, const LegsOptions& options);

} // namespace lubberline
