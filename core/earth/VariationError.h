#pragma once
/// How wrong a model's variation may be.

#include "core/earth/FieldModel.h"

namespace lubberline {

/// Where a model states no uncertainty (IGRF): WMM states some 0.4° at middle latitudes for its own five years.
inline constexpr double kUnstatedVariationError_deg = 0.5;

/// One standard deviation [deg].
[[nodiscard]] inline double variationError_deg(const FieldAnswer& answer)
{
    return answer.uncertainty ? answer.uncertainty->declination_deg : kUnstatedVariationError_deg;
}

} // namespace lubberline
