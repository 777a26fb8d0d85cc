#pragma once
/// Sines and arctangents for inner loops (ten million reports, 180,000 steps of an hour), to the last digits by short series near zero, where
/// most of their arguments are; the library's functions elsewhere.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/angle/Angle.h"

namespace lubberline {

/// c₀ + c₁ y + c₂ y² + …
template <std::size_t count>
constexpr double polynomial(double y, const std::array<double, count>& c)
{
    double sum = 0;
    for (std::size_t i = count; i-- > 0;)
        sum = sum * y + c[i];
    return sum;
}

struct SineCosine {
    double sine = 0, cosine = 1;
};

/// Where the series of sineCosineNearZero() hold: to some 45°.
inline bool nearZero(double angle_rad) { return std::abs(angle_rad) <= 0.79; }

/// Of radians, without a branch.
inline SineCosine sineCosineNearZero(double angle_rad)
{
    constexpr std::array kSine{
        1.0, -1.0 / 6, 1.0 / 120, -1.0 / 5040, 1.0 / 362880, -1.0 / 39916800, 1.0 / 6227020800.0, -1.0 / 1307674368000.0};
    constexpr std::array kCosine{
        1.0, -0.5, 1.0 / 24, -1.0 / 720, 1.0 / 40320, -1.0 / 3628800, 1.0 / 479001600, -1.0 / 87178291200.0, 1.0 / 20922789888000.0};
    const double square = angle_rad * angle_rad;
    return {angle_rad * polynomial(square, kSine), polynomial(square, kCosine)};
}

/// Of radians.
inline SineCosine quickSineCosine(double angle_rad)
{
    if (!nearZero(angle_rad))
        return {std::sin(angle_rad), std::cos(angle_rad)};
    return sineCosineNearZero(angle_rad);
}

/// Of degrees, of which quarters of a turn are taken off exactly.
inline SineCosine quickSineCosineOfDegrees(double angle_deg)
{
    constexpr double kManyTurns_deg = 1e5;
    if (!(std::abs(angle_deg) < kManyTurns_deg))
        return {std::sin(toRadians(angle_deg)), std::cos(toRadians(angle_deg))};
    const int quarters = static_cast<int>(angle_deg * (1.0 / 90.0) + (angle_deg < 0 ? -0.5 : 0.5));
    const SineCosine rest = quickSineCosine(toRadians(angle_deg - 90.0 * quarters));
    // Chosen without a branch: headings come from all quarters in no order.
    const bool odd = (quarters & 1) != 0;
    const double sine = odd ? rest.cosine : rest.sine, cosine = odd ? rest.sine : rest.cosine;
    return {(quarters & 2) != 0 ? -sine : sine, ((quarters + 1) & 2) != 0 ? -cosine : cosine};
}

/// wrap180(), whose remainder is only needed where there is something to wrap.
inline double quickWrap180(double angle_deg) { return angle_deg > -180.0 && angle_deg <= 180.0 ? angle_deg : wrap180(angle_deg); }

/// Where the series of arctangentNearZero() holds: to some 11°.
inline bool arctangentIsNearZero(double y, double x) { return std::abs(y) < 0.2 * x; }

/// std::atan2 [rad], without a branch.
inline double arctangentNearZero(double y, double x)
{
    constexpr std::array kSeries{1.0, -1.0 / 3, 1.0 / 5, -1.0 / 7, 1.0 / 9, -1.0 / 11, 1.0 / 13, -1.0 / 15, 1.0 / 17, -1.0 / 19};
    const double tangent = y / x;
    return tangent * polynomial(tangent * tangent, kSeries);
}

/// std::atan2 [rad] of any direction, without a branch; not a number where both are zero. By the tangent of the difference to 0°, 22.5°
/// or 45°, whichever is within 11.25°.
inline double arctangentAround(double y, double x)
{
    constexpr double kEighth = 0.41421356237309503, kFrom = 0.19891236737965801, kTo = 0.66817863791929888; // tan 22.5°, 11.25°, 33.75°
    const double across = std::abs(y), along = std::abs(x);
    const bool steep = across > along;
    const double small = steep ? along : across, large = steep ? across : along;
    const double tangent = small < kFrom * large ? 0.0 : small < kTo * large ? kEighth : 1.0;
    const double base = small < kFrom * large ? 0.0 : small < kTo * large ? kPi / 8 : kPi / 4;
    const double near = base + arctangentNearZero(small - tangent * large, large + tangent * small);
    const double within = steep ? kPi / 2 - near : near;
    return std::copysign(x < 0 ? kPi - within : within, y);
}

/// std::atan2 [rad].
inline double quickArctangent(double y, double x) { return arctangentIsNearZero(y, x) ? arctangentNearZero(y, x) : std::atan2(y, x); }

/// Where (east, north) points, clockwise from north in [0, 360), within 2e-6° [Abramowitz & Stegun 4.4.49]: for plots and means.
inline double directionNearly_deg(double east, double north)
{
    constexpr std::array kArctangent{
        1.0, -0.3333314528, 0.1999355085, -0.1420889944, 0.1065626393, -0.0752896400, 0.0429096138, -0.0161657367, 0.0028662257};
    const double large = std::max(std::abs(east), std::abs(north)), small = std::min(std::abs(east), std::abs(north));
    if (!(large > 0))
        return 0;
    const double ratio = small / large;
    double angle = ratio * polynomial(ratio * ratio, kArctangent);
    if (std::abs(east) > std::abs(north))
        angle = kPi / 2 - angle;
    if (north < 0)
        angle = kPi - angle;
    const double direction_deg = toDegrees(east < 0 ? 2 * kPi - angle : angle);
    return direction_deg < 360 ? direction_deg : 0;
}

} // namespace lubberline
