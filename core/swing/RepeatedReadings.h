#pragma once
/// A list of readings that was entered more than once.

#include <optional>
#include <span>

#include "core/base/Message.h"
#include "core/deviation/SmithFit.h"

namespace lubberline {

/// Where every reading is there equally often with the same two headings, and more than once, as when a table is pasted twice: its copies tell
/// nothing new. Gives both fits (of all readings) the errors, intervals and degrees of freedom of the list once, and says so. None else, of
/// fewer than four different readings, and of a log.
[[nodiscard]] std::optional<Message> countOnce(std::span<const Observation> readings, ApproximateFit& approximate, ExactFit& exact);

} // namespace lubberline
