#pragma once
/// A log made on a compass base that was surveyed: the survey is held against the model.

#include <span>

#include "core/nmea/NmeaSwing.h"
#include "core/record/Site.h"

namespace lubberline {

/// Where the log's first fix lies on one of these bases and the declination of its survey is more than half a degree from the model's, that is told
/// and widens A, unless the user stated the variation.
void holdAgainstBases(NmeaSwing& swing, const NmeaOptions& options, std::span<const Site> bases);

} // namespace lubberline
