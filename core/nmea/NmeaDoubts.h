#pragma once
/// What all readings of a log share (a delay, the wind, the variation) makes the coefficients of its swing unsure together.

#include "core/nmea/NmeaSwing.h"
#include "core/record/SharedErrors.h"

namespace lubberline {

/// What the doubts of the log leave open of the used pairs: with J = (XᵀX)⁻¹Xᵀd for each of them, the root of the sum of J² [deg].
[[nodiscard]] SharedErrors sharedErrorsOf(const NmeaSwing& swing);

} // namespace lubberline
