#pragma once
/// From what a log holds to a swing: sources, variation, times, wind, delay.

#include "core/nmea/NmeaLog.h"
#include "core/nmea/NmeaSwing.h"

namespace lubberline {

/// Errors: those of readNmeaSwing() that concern what the log holds.
Result<NmeaSwing> makeSwing(const NmeaLog& log, const NmeaOptions& options);

} // namespace lubberline
