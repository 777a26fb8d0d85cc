#pragma once
/// What a doubt that all readings share leaves open of the coefficients.

#include <span>
#include <string_view>
#include <vector>

#include "core/angle/Heading.h"
#include "core/record/SharedErrors.h"

namespace lubberline {

/// Something that all readings share, so that more of them make no coefficient surer: what one standard error of it adds to the deviation
/// of each reading [deg].
using SharedDoubt = std::vector<double>;

/// The column of a Swing CSV that says how uncertain the datum was on each heading [deg, one standard deviation]: kept beside the reading.
inline constexpr std::string_view kDatumErrorColumn = "datum_error_deg";

/// With J = (XᵀX)⁻¹Xᵀd for each doubt d, the root of the sum of J² [deg]. None of fewer than three readings, which tell no coefficients.
/// @param doubts each as long as the readings
[[nodiscard]] SharedErrors sharedErrorsOf(std::span<const CompassHeading> readings, std::span<const SharedDoubt> doubts);

} // namespace lubberline
