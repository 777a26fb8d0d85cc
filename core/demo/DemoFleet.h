#pragma once
/// A demonstration fleet, the same on every machine: at least 3 types, 12 aircraft, several years of swings each, plausible
/// coefficients with reading noise, three aircraft out of limits at their last swing, one misread figure (10°) in the year
/// before, one draft. Invented: every aircraft is marked so. With one swing a compass the misread figure is in the last swing,
/// too. Three aircraft have a magnetometer besides that is swung at home and at two far bases in the last years, in limits
/// everywhere; one hidden sensor model gives all its readings (DemoDeployment.h). Two of them keep sensor models: one entered,
/// one of an iron bench. A fifth type is a population (DemoPopulation.h): ten years of swings of twenty aircraft, some of which are out
/// of limits besides. Every swing has the Earth's field of its base and day, to 0.01 nT.

#include <cstdint>

#include "core/record/Fleet.h"

namespace lubberline {

struct DemoOptions {
    std::uint64_t seed = 1;
    int swingsPerCompass = 5; ///< one a year up to `lastYear`
    int aircraftPerType = 4;
    int lastYear = 2026;
    int populationAircraft = 20; ///< of the type that is a population (DemoPopulation.h); 0: there is none
};

[[nodiscard]] Fleet demoFleet(const DemoOptions& options = {});

} // namespace lubberline
