#pragma once
/// Private to the look at a log (LogQuality.h): what tells a sound log, in one pass, from one that must be looked at row by row.

#include "core/calibration/LogQuality.h"

namespace lubberline {

inline constexpr std::size_t kStuckRows = 50; ///< of one figure: an axis is stuck

struct QuickLook {
    std::array<AxisEnds, 3> ends;
    std::array<bool, 3> stands{}; ///< two figures lie half of kStuckRows apart and are alike: there are such in every stuck axis
    std::array<bool, 3> leaves{}; ///< a row leaves the middle of the five around it by more than its axis' limit
    bool incomplete = false;      ///< a row has no whole field, or is the row before it once more
};
[[nodiscard]] QuickLook lookOver(const SensorLog& log, const std::array<double, 3>& limits);

/// away[i] = v[i + 2] − the middle of v[i] … v[i + 4], by comparisons alone; NaN where one of the five is.
void awayFromMiddle(const double* v, std::size_t count, double* away);

} // namespace lubberline
