#pragma once
/// What may have been meant where a figure was written: shared by the judge of one reading and by the search in a whole swing.

#include <vector>

#include "core/deviation/SlipCheck.h"

namespace lubberline {

struct SlipVariant {
    Slip slip = Slip::TenDegrees;
    double meant_deg = 0;
    double prior = 0; ///< how likely the slip is, a reading, before the reading is looked at
};

/// Swapped digits, the reciprocal, 5°, 10° and 100° off.
[[nodiscard]] std::vector<SlipVariant> slipVariantsOf(double figure_deg);

/// How often each other slip happens, a reading. Our estimates: only their order of size matters, as likelihoods differ by far more.
inline constexpr double kWrongSignRate = 1e-3, kWrongRowRate = 2e-3, kUnexplainedRate = 1e-3;

} // namespace lubberline
