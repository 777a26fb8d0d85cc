#pragma once
/// The history of a compass out of its recorded swings.

#include "core/check/CompassBelief.h"
#include "core/record/Fleet.h"

namespace lubberline {

/// What a swing tells as a part of a history (core/swing/SwingResult.h); none: no date, or no fit.
[[nodiscard]] std::optional<PastSwing> pastSwing(const SwingRecord& record);
/// Of one compass, in order of time, without those that tell nothing.
[[nodiscard]] std::vector<PastSwing> historyOf(std::span<const SwingRecord> records);

} // namespace lubberline
