#pragma once
/// A swing in flight: the means of its legs are stored as readings, and its result is computed from them like any other's.

#include <optional>
#include <span>

#include "core/inflight/ContinuousSwing.h"
#include "core/inflight/Legs.h"
#include "core/record/Swing.h"

namespace lubberline {

/// Legs without a compass heading or without a variation are left out.
[[nodiscard]] Swing swingOf(const LegsSolution& solution);
/// @param legs deviations are magnetic − compass
[[nodiscard]] Swing swingOf(std::span<const LegMean> legs);

/// What swings in flight tell so far, the earliest first, recomputed from their readings: where the next continuous swing begins. Each
/// reading that counts is one update. None: they do not tell all of A to E.
/// @param noise_deg standard deviation of a reading; none: the usual one, or how they scatter where that is more
[[nodiscard]] std::optional<ContinuousState> stateAfter(std::span<const Swing> swings, std::optional<double> noise_deg = {});

} // namespace lubberline
