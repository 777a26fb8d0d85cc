#pragma once
/// What is wrong with the compass or the list as a whole is said before any coefficient: coefficients of it mean nothing.

#include <optional>
#include <span>

#include "core/deviation/Smith.h"

namespace lubberline {

/// An error that names it when the compass reads the same on headings all round (stuck, or one figure copied down), or falls as the
/// aircraft turns right (a mirrored card, figures of the other scale). Fewer than three readings, or readings within 45°, tell neither.
[[nodiscard]] std::optional<Error> faultOf(std::span<const Observation> readings);

/// The words for an index that is no deviation any more (largeIndex_deg of SmithFit.h), none for 0.
[[nodiscard]] std::optional<Message> indexWords(double index_deg);

} // namespace lubberline
