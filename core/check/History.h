#pragma once
/// The history of a compass out of its recorded swings.

#include <span>
#include <string>
#include <vector>

#include "core/base/Result.h"
#include "core/check/CompassBelief.h"
#include "core/record/Fleet.h"

namespace lubberline {

/// What a swing tells as a part of a history (core/swing/SwingResult.h); none: no date, or no fit.
[[nodiscard]] std::optional<PastSwing> pastSwing(const SwingRecord& record);
/// A swing and where it comes from, as it is named to people.
struct SourcedRecord {
    std::string source;
    SwingRecord record;
};
/// Whether both are the same swing: the same day, readings and configuration, whatever else stands above them.
[[nodiscard]] bool isSameSwing(const SwingRecord& one, const SwingRecord& other);
/// Whether both state an aircraft or a compass, and not the same.
[[nodiscard]] bool isOfAnotherCompass(const SwingRecord& one, const SwingRecord& other);
/// A history is of one compass, and has each swing once: why this one is none. Errors: Conflict, with its source.
Result<void> checkHistory(std::span<const SourcedRecord> history);
/// Two histories are of two compasses of one aircraft. Errors: Conflict, with the source of the second.
Result<void> checkTwoCompasses(std::span<const SourcedRecord> first, std::span<const SourcedRecord> second);
/// Of which swings it is not said of which aircraft and compass they are, where others of them do; empty: all do, or none.
[[nodiscard]] std::vector<Message> doubtsOfHistory(std::span<const SourcedRecord> history);

/// Of one compass, in order of time, without those that tell nothing.
[[nodiscard]] std::vector<PastSwing> historyOf(std::span<const SwingRecord> records);

} // namespace lubberline
