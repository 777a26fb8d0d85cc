#pragma once
/// The JSON that commands print (the contract of the command line): every key carries its unit, what cannot be told is null.

#include <functional>
#include <string>
#include <string_view>

#include "core/deviation/Correction.h"
#include "core/record/Fleet.h"
#include "core/swing/Analysis.h"
#include "core/swing/Card.h"
#include "core/swing/Removal.h"

namespace lubberline {

/// One JSON object each, two spaces of indentation, no newline at the end; never NaN or infinity.
/// With a removal: what would remain at each reading without the removed components, and its harmonics.
[[nodiscard]] std::string toJson(const Analysis& analysis, const Removal* removal = nullptr);
/// The same in parts, reading by reading: as a document, a million of them took 1.9 GB.
using TextSink = std::function<void(std::string_view)>;
void writeJson(const Analysis& analysis, const Removal* removal, const TextSink& put);
/// With what has to be said beside it (core/swing/CardRemarks.h). @param record whose swing it is of: its limits and attitude.
[[nodiscard]] std::string toJson(const Card& card, const SwingRecord& record);
[[nodiscard]] std::string toJson(const Correction& correction, const std::vector<Message>& warnings = {});

} // namespace lubberline
