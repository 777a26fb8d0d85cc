#pragma once
/// Angles that lie round a circle: where they are on the whole, and where there are none.

#include <span>
#include <vector>

namespace lubberline {

struct CircularMean {
    double mean_deg = 0;     ///< (−180, 180]; means little where togetherness is near 0
    double togetherness = 0; ///< length of the mean unit vector: 1 all the same, near 0 all round
};
/// @param angles_deg at least one.
[[nodiscard]] CircularMean circularMean(std::span<const double> angles_deg);

/// The same angle, within half a turn of another [rad]: angles on both sides of ±180° without a jump.
[[nodiscard]] double nearTo_rad(double angle_rad, double middle_rad);

/// An arc that holds none of some headings, clockwise from one of them to the next.
struct EmptyArc {
    double from_deg = 0, to_deg = 0; ///< from_deg in [0, 360), to_deg may be beyond 360
    [[nodiscard]] double width_deg() const { return to_deg - from_deg; }
};
/// The widest; all round where there is one heading only. @param headings_deg in [0, 360), at least one.
[[nodiscard]] EmptyArc widestEmptyArc(std::vector<double> headings_deg);

} // namespace lubberline
