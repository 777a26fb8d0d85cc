#include "core/angle/Circle.h"

#include <algorithm>
#include <cmath>

#include "core/angle/Angle.h"

namespace lubberline {

double nearTo_rad(double angle_rad, double middle_rad) { return middle_rad + std::remainder(angle_rad - middle_rad, 2 * kPi); }

CircularMean circularMean(std::span<const double> angles_deg)
{
    double x = 0, y = 0;
    for (const double angle_deg : angles_deg) {
        x += std::cos(toRadians(angle_deg));
        y += std::sin(toRadians(angle_deg));
    }
    return {toDegrees(std::atan2(y, x)), std::hypot(x, y) / static_cast<double>(angles_deg.size())};
}

EmptyArc widestEmptyArc(std::vector<double> headings_deg)
{
    std::sort(headings_deg.begin(), headings_deg.end());
    EmptyArc widest{headings_deg.back(), headings_deg.front() + 360.0};
    for (std::size_t i = 1; i < headings_deg.size(); ++i)
        if (headings_deg[i] - headings_deg[i - 1] > widest.width_deg())
            widest = {headings_deg[i - 1], headings_deg[i]};
    return widest;
}

} // namespace lubberline
