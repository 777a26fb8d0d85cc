#pragma once
/// A type of which years of swings are looked at as a population, like the one of the source paper [P]: mean deviation with maxima at 135°
/// and 315° and minima at 45° and 225°; D, A and B dominate the mean, A, B and C what differs between aircraft. Crews were trained at a
/// date, after which |A| is a fifth of what it was; three compasses jumped, and one drifts towards its limit. Invented.

#include <array>

#include "core/demo/DemoRandom.h"
#include "core/record/Fleet.h"

namespace lubberline {

inline constexpr char kDemoPopulationType[] = "Su-22M4";
inline constexpr int kDemoPopulationYears = 10; ///< up to the last year of the fleet

struct DemoJump {
    int aircraft = 0; ///< its number in the type
    int year = 0;     ///< before the last of the fleet: it lies before the visit of that year
    std::size_t coefficient = 0;
    double size_deg = 0;
    const char* event = ""; ///< empty: nobody knows
};
[[nodiscard]] const std::array<DemoJump, 3>& demoJumps();
inline constexpr int kDemoDrifting = 17; ///< the number of the aircraft that drifts, in B
inline constexpr double kDemoDrift_deg_year = 0.25;
/// The first year that crews are trained in, before the last of the fleet.
inline constexpr int kDemoTrainedYears = 4;

/// Adds the type with its aircraft, compasses, events and swings to a fleet, after what is there.
void addPopulation(Fleet& fleet, DemoRandom random, int aircraft, int lastYear);

} // namespace lubberline
