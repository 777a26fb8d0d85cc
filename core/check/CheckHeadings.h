#pragma once
/// Which headings tell most about a compass: those that leave least of the curve unknown, among the changes with which its card would not
/// hold any more. With Σ the second moment of those changes,
///   minimise the mean over heading of w xᵀ (Σ⁻¹ + XᵀX/s²)⁻¹ x
/// Up to three are a check, whose question is whether the card holds: w is the square of the chance that it fails on that heading, so that a
/// compass whose B wanders is read near east and west. (By simulation the verdicts are then as good as with headings chosen by their own
/// expected error, and some 4 % better than with three evenly spaced ones, 15 % with two.) More are a swing: w is 1.

#include "core/check/TwoMinuteCheck.h"

namespace lubberline {

struct ChosenHeadings {
    std::vector<double> compass_deg; ///< in the order in which one turns through them, every 15°
    double left_deg = 0;             ///< standard deviation of the curve after them, over heading, with w
    double leftEven_deg = 0;         ///< the same of as many evenly spaced ones from north
    double before_deg = 0;
};

/// Up to three headings by trying all; more by exchange. @param count 1 … 24.
[[nodiscard]] ChosenHeadings headingsFor(const CompassBelief& belief, int count, const CheckOptions& options);
/// 0, 360/n …
[[nodiscard]] std::vector<double> evenHeadings(int count);

} // namespace lubberline
