#pragma once
/// Scales in steps of 1, 2 or 5 times a power of ten.

#include <QString>

namespace lubberline::ui {

struct NiceScale {
    double end = 1;  ///< a whole number of steps
    double step = 1; ///< 1, 2 or 5 · 10ⁿ
};

/// The smallest 1-2-5 number that is not below `least` (> 0).
[[nodiscard]] double niceStep(double least);

/// A scale −end…+end (or 0…end) that holds `maxAbs` with at most `steps` steps on a side; a maxAbs below `floor` (> 0) or not
/// finite counts as `floor`, so that noise is not blown up to full size.
[[nodiscard]] NiceScale niceScale(double maxAbs, int steps = 4, double floor = 1.0);

/// "+2", "0", "−0.5": as many decimals as the step needs, U+2212 for minus.
[[nodiscard]] QString signedTick(double value, double step);
/// The same without the plus.
[[nodiscard]] QString plainTick(double value, double step);

} // namespace lubberline::ui
