#pragma once
/// Headings near the poles: from grid north, which is the direction of a meridian drawn over the whole chart (polar stereographic).
///   grid = true − convergence, convergence = (λ − λ0) in the north, −(λ − λ0) in the south (east positive)

#include "core/angle/Heading.h"
#include "core/earth/EarthField.h"

namespace lubberline {

/// true − grid [deg], (−180, 180]. @param reference_deg λ0: longitude whose meridian is grid north (0: Greenwich).
[[nodiscard]] double convergence_deg(const Place& place, double reference_deg = 0);
[[nodiscard]] double gridHeading_deg(TrueHeading heading, const Place& place, double reference_deg = 0);
/// Grid variation (grivation): what is added to a magnetic heading to make a grid heading.
[[nodiscard]] double grivation_deg(Variation variation, const Place& place, double reference_deg = 0);

} // namespace lubberline
