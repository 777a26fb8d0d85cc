#include "core/swing/ReadingError.h"

#include <algorithm>
#include <cmath>

#include "core/angle/Angle.h"

namespace lubberline {

namespace {

void widen(SmithFitReport& fit, double error_rad)
{
    if (!fit.sigma_rad || *fit.sigma_rad >= error_rad)
        return;
    const double factor = error_rad / std::max(*fit.sigma_rad, kLeastScatter_rad);
    fit.covariance *= factor * factor;
    for (auto& error : fit.standardError)
        if (error)
            *error *= factor;
}

} // namespace

double readingError_rad(double compass_deg, double datum_deg) { return toRadians(std::hypot(compass_deg, datum_deg) / std::sqrt(12.0)); }

void widenToReadings(Analysis& analysis, double error_rad)
{
    widen(analysis.approximate, error_rad);
    widen(analysis.exact, error_rad);
}

} // namespace lubberline
