#pragma once
/// A swing in flight: the means of its legs are stored as readings, and its result is computed from them like any other's.

#include <span>

#include "core/inflight/ContinuousSwing.h"
#include "core/inflight/Legs.h"
#include "core/record/Swing.h"

namespace lubberline {

/// Legs without a compass heading or without a variation are left out.
[[nodiscard]] Swing swingOf(const LegsSolution& solution);
/// @param legs deviations are magnetic − compass
[[nodiscard]] Swing swingOf(std::span<const LegMean> legs);

} // namespace lubberline
