#pragma once
/// Readable tables of results for a terminal: what commands print without --json. Signs and units in every head.

#include <string>

#include "core/deviation/Correction.h"
#include "core/swing/Analysis.h"
#include "core/swing/Removal.h"
#include "ui/report/card/CardDocument.h"

namespace lubberline::app {

[[nodiscard]] std::string tableOf(const Analysis& analysis);
/// What would remain without the removed components, reading by reading and order by order.
[[nodiscard]] std::string tableOf(const Analysis& analysis, const Removal& removal, CoefficientSet removed);
[[nodiscard]] std::string tableOf(const Correction& correction);
/// The rows of all columns, with their marks and how sure they are, and what has to be said of each.
[[nodiscard]] std::string tableOf(const ui::CardInput& input);

} // namespace lubberline::app
