#include "core/angle/WrittenDegrees.h"

#include <cmath>
#include <initializer_list>
#include <limits>

#include "core/angle/Angle.h"

namespace lubberline {

namespace {

/// As people write them: 1e-9° is far below what any of them means.
constexpr double kShort = 1e9;
constexpr double kFar = std::numeric_limits<double>::max();

double pick(double angle_rad)
{
    const double plain_deg = toDegrees(angle_rad);
    if (const double short_deg = std::round(plain_deg * kShort) / kShort; toRadians(short_deg) == angle_rad)
        return short_deg;
    // Rounding may have moved the plain figure to a neighbour of the one that was read.
    for (const double figure_deg : {plain_deg, std::nextafter(plain_deg, -kFar), std::nextafter(plain_deg, kFar)})
        if (toRadians(figure_deg) == angle_rad)
            return figure_deg;
    return plain_deg;
}

} // namespace

double writtenDegrees(double angle_rad)
{
    // Not every angle is the reading of some degrees; after one reading it is.
    return pick(toRadians(pick(angle_rad)));
}

} // namespace lubberline
