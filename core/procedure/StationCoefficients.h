#pragma once
/// What the readings at the stations of a guided swing say about the coefficients, by the rules of the worksheet.

#include <optional>
#include <span>

#include "core/procedure/JobState.h"

namespace lubberline {

/// C = (N − S)/2, B = (E − W)/2, A = (N + E + S + W)/4 of the correction swing [°], of what was read before controls were turned; none where a
/// cardinal was skipped.
[[nodiscard]] std::optional<double> classicalCoefficient_deg(std::span<const StationState> stations, Control control);

/// A of the check swing [°]: the mean of its cardinals, as the worksheet has it; of the fit where a cardinal could not be reached.
[[nodiscard]] std::optional<double> checkIndex_deg(std::span<const StationState> stations);

} // namespace lubberline
