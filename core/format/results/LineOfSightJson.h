#pragma once
/// The JSON of `line-of-sight` (the contract of the command line).

#include <span>
#include <string>

#include "core/calibration/LineOfSight.h"

namespace lubberline {

[[nodiscard]] std::string toJson(const SightBudget& budget, std::span<const SightBudget> sweep);

} // namespace lubberline
