#pragma once
/// Private to core/deviation: the equation that one reading gives to a fit.

#include <array>
#include <cmath>

#include "core/angle/Circle.h"
#include "core/deviation/Smith.h"

namespace lubberline {

/// What distinguishes the two fits: a row of the design matrix and its right-hand side.
struct SmithRow {
    std::array<double, kCoefficientCount> x;
    double y;
};

/// The readings' deviations about `index_deg`: without a jump from +180° to −180° among them.
inline double aboutIndex_deg(const Observation& reading, double index_deg)
{
    return index_deg + wrap180(deviationOf(reading.magnetic, reading.compass).degrees() - index_deg);
}

inline SmithRow approximateRow(const Observation& reading, double index_deg)
{
    const double z = reading.compass.radians() + toRadians(index_deg), s1 = std::sin(z), c1 = std::cos(z);
    return {{1, s1, c1, 2 * s1 * c1, c1 * c1 - s1 * s1}, toRadians(aboutIndex_deg(reading, index_deg))};
}

/// As if the compass had been turned in its mount by the index.
inline SmithRow exactRow(const Observation& reading, double index_deg)
{
    const double z = reading.compass.radians() + toRadians(index_deg), sum = reading.magnetic.radians() + z;
    const double deviation = reading.magnetic.radians() - z;
    return {{std::cos(deviation), std::sin(z), std::cos(z), std::sin(sum), std::cos(sum)}, std::sin(deviation)};
}

} // namespace lubberline
