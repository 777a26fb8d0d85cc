#pragma once
/// A demonstration fleet, the same on every machine: at least 3 types, 12 aircraft, several years of swings each, plausible
/// coefficients with reading noise, a few aircraft out of limits, one misread figure. Invented: every aircraft is marked so.

#include <cstdint>

#include "core/record/Fleet.h"

namespace lubberline {

struct DemoOptions {
    std::uint64_t seed = 1;
    int swingsPerCompass = 5;     ///< one a year up to `lastYear`
    int aircraftPerType = 4;
    int lastYear = 2026;
};

[[nodiscard]] Fleet demoFleet(const DemoOptions& options = {});

} // namespace lubberline
