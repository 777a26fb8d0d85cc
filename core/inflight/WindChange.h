#pragma once
/// Between which two flights the coefficients of an aircraft changed (recalibrated, degaussed, repaired): the largest step of A, B and C
/// over all places, each standardised by its own covariance. The chance is that of the maximum: places times F's tail, or what simulated
/// series with the aircraft's own flights gave where that is less.

#include <optional>
#include <span>
#include <vector>

#include "core/inflight/ClusteredFit.h"

namespace lubberline {

struct WindChange {
    std::size_t after = 0;              ///< the last flight before the change, in order of time
    double p = 1;                       ///< over all places
    WindRow step_deg = WindRow::Zero(); ///< after − before, of the indication error
};

/// @param flights in order of time, of three columns. @param freedom of the estimate of the errors that flights share; 0: they are known
[[nodiscard]] std::optional<WindChange> largestChange(std::span<const FlightTold> flights, const ClusteredFit& fit, double freedom);

} // namespace lubberline
