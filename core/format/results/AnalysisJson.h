#pragma once
/// The JSON that commands print (the contract of the command line): every key carries its unit, what cannot be told is null.

#include <string>

#include "core/deviation/Correction.h"
#include "core/record/Fleet.h"
#include "core/swing/Analysis.h"
#include "core/swing/Card.h"
#include "core/swing/Removal.h"

namespace lubberline {

/// One JSON object each, two spaces of indentation, no newline at the end; never NaN or infinity.
[[nodiscard]] std::string toJson(const Analysis& analysis);
/// The same with "removal": what would remain at each reading without the removed components, and its harmonics.
[[nodiscard]] std::string toJson(const Analysis& analysis, const Removal& removal);
/// With what has to be said beside it (core/swing/CardRemarks.h). @param record whose swing it is of: its limits and attitude.
[[nodiscard]] std::string toJson(const Card& card, const SwingRecord& record);
[[nodiscard]] std::string toJson(const Correction& correction);

} // namespace lubberline
