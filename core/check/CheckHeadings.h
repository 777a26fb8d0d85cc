#pragma once
/// Which headings tell most about a compass: those that leave least of the curve unknown, among the changes with which its card would not
/// hold any more. With Σ the second moment of those changes,
///   minimise the mean over heading of xᵀ (Σ⁻¹ + XᵀX/s²)⁻¹ x

#include "core/check/TwoMinuteCheck.h"

namespace lubberline {

struct ChosenHeadings {
    std::vector<double> compass_deg; ///< in the order in which one turns through them, every 15°
    double left_deg = 0;             ///< standard deviation of the curve after them, over heading
    double leftEven_deg = 0;         ///< the same of as many evenly spaced ones from north
    double before_deg = 0;
};

/// Up to three headings by trying all; more by exchange. @param count 1 … 24.
[[nodiscard]] ChosenHeadings headingsFor(const CompassBelief& belief, int count, const CheckOptions& options);
/// 0, 360/n …
[[nodiscard]] std::vector<double> evenHeadings(int count);

} // namespace lubberline
