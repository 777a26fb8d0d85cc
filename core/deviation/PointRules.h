#pragma once
/// The classical rules that crews can work by hand from readings near the 4 or 8 points.
///   A = mean of all; B = (δE − δW)/2; C = (δN − δS)/2; D = ((δNE + δSW) − (δSE + δNW))/4; E = ((δN + δS) − (δE + δW))/4
/// (NGA Handbook of Magnetic Compass Adjustment 2004, art. 501). With the four cardinals alone
/// A is their mean and D cannot be told.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/deviation/Smith.h"

namespace lubberline {

/// Which heading decides that a reading is "on" a point: the one that comes closer to the points.
enum class HeadingArgument { Magnetic, Compass };

struct PointRules {
    int points = 8; ///< 4 or 8
    HeadingArgument argument = HeadingArgument::Magnetic;
    double A_rad = 0, B_rad = 0, C_rad = 0;
    std::optional<double> D_rad; ///< none with four points
    double E_rad = 0;
    std::array<std::optional<std::size_t>, 8> reading; ///< index of the reading taken for N, NE, …, NW
};

/// How far from its point a reading may be: half the spacing of sixteen points.
inline constexpr double kPointTolerance_deg = 11.25;

/// Of a compass that is far out as a whole the points are those of the compass turned in its mount by its index (SmithFit.h), which is in A.
/// None when not all four cardinals have a reading within kPointTolerance_deg.
[[nodiscard]] std::optional<PointRules> pointRules(std::span<const Observation> readings);

} // namespace lubberline
