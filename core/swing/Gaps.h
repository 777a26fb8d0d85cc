#pragma once
/// Where nobody read: a fitted curve goes on through such an arc, but nothing was seen there.

#include <optional>
#include <vector>

#include "core/swing/Analysis.h"

namespace lubberline {

/// An arc between two neighbouring readings, clockwise.
struct ReadingGap {
    CompassHeading from, to;                  ///< what the compass read at its ends
    MagneticHeading magneticFrom, magneticTo; ///< of the same two readings
    double width_deg = 0;                     ///< by compass
    /// Half width of the 95 % band of the approximate fit where it is widest inside; none: the readings do not tell.
    std::optional<double> widestBand_rad;
    /// Between the two readings, and further from both than a crew stands off the heading that it turns to (3°).
    [[nodiscard]] bool holds(MagneticHeading heading) const;
};

/// Wider than any step that swings are made in (45°): readings on six evenly spaced headings leave none.
inline constexpr double kWideGap_deg = 60;

/// The arcs of compass headings wider than kWideGap_deg, in the order of their beginning; whatever the condition of the fit.
[[nodiscard]] std::vector<ReadingGap> gapsOf(const Analysis& analysis);

/// "no reading between 219° and 008° (compass) …; the curve is known to ±4.5° there (95 %)".
[[nodiscard]] Message wordsOf(const ReadingGap& gap);

} // namespace lubberline
