#pragma once
/// Readable tables of results for a terminal: what commands print without --json. Signs and units in every head.

#include <string>

#include "core/deviation/Correction.h"
#include "core/swing/Analysis.h"
#include "core/swing/Card.h"
#include "core/swing/Removal.h"

namespace lubberline::app {

[[nodiscard]] std::string tableOf(const Analysis& analysis);
/// What would remain without the removed components, reading by reading and order by order.
[[nodiscard]] std::string tableOf(const Analysis& analysis, const Removal& removal, CoefficientSet removed);
[[nodiscard]] std::string tableOf(const Correction& correction);
/// `labels`: the heads of the STEER columns, one for each card; all cards have the same FOR headings.
[[nodiscard]] std::string tableOf(const std::vector<Card>& cards, const std::vector<std::string>& labels);

} // namespace lubberline::app
