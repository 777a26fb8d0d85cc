#pragma once
/// The JSON that commands print (the contract of the command line): every key carries its unit, what cannot be told is null.

#include <string>

#include "core/deviation/Analysis.h"
#include "core/deviation/Card.h"
#include "core/deviation/Correction.h"

namespace lubberline {

/// One JSON object each, two spaces of indentation, no newline at the end; never NaN or infinity.
[[nodiscard]] std::string toJson(const Analysis& analysis);
[[nodiscard]] std::string toJson(const Card& card);
[[nodiscard]] std::string toJson(const Correction& correction);

} // namespace lubberline
