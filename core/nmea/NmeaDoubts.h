#pragma once
/// What all readings of a log share (a delay, the wind, the variation) makes the coefficients of its swing unsure together.

#include "core/nmea/NmeaSwing.h"
#include "core/swing/Analysis.h"

namespace lubberline {

/// Adds to both fits what the doubts of the log leave open: with J = (XᵀX)⁻¹Xᵀd for each of them, the covariance grows by J Jᵀ.
/// @param analysis of the used pairs.
void widenByDoubts(Analysis& analysis, const NmeaSwing& swing);

} // namespace lubberline
