#pragma once

#include <cmath>

#include "core/angle/Angle.h"

namespace lubberline {

/// A heading that is about to be printed with so many decimals: what they would round up to 360 is north, 0.
[[nodiscard]] inline double printedHeading_deg(double heading_deg, int decimals)
{
    const double wrapped_deg = wrap360(heading_deg);
    return wrapped_deg < 360.0 - 0.5 * std::pow(10.0, -decimals) ? wrapped_deg : 0.0;
}

} // namespace lubberline
