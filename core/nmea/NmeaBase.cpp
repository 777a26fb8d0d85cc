#include "core/nmea/NmeaBase.h"

#include <cmath>

#include "core/base/Number.h"
#include "core/site/SiteSurvey.h"

namespace lubberline {

namespace {

/// An aerodrome is so large, and the field of its ground reaches no further.
constexpr double kReach_km = 3.0;
constexpr double kBaseApart_deg = 0.5;
constexpr double kKilometresPerDegree = 111.2; // a sphere of 6371 km: what a reach is measured with

double distance_km(const Site& base, const NmeaSwing& swing)
{
    const double north = *base.latitude_deg - *swing.latitude_deg;
    const double east = wrap180(*base.longitude_deg - *swing.longitude_deg) * std::cos(toRadians(*swing.latitude_deg));
    return kKilometresPerDegree * std::hypot(north, east);
}

} // namespace

void holdAgainstBases(NmeaSwing& swing, const NmeaOptions& options, std::span<const Site> bases)
{
    if (!swing.latitude_deg || !swing.variationOfModel_deg || std::holds_alternative<Variation>(options.variation))
        return;
    for (const Site& base : bases) {
        if (!base.latitude_deg || !base.longitude_deg || distance_km(base, swing) > kReach_km)
            continue;
        const auto survey = summarise(base.survey, 0.0);
        if (!survey || !survey->declination_deg)
            continue;
        const double surveyed_deg = survey->declination_deg->mean;
        const double apart_deg = std::abs(wrap180(surveyed_deg - *swing.variationOfModel_deg));
        if (apart_deg <= kBaseApart_deg)
            continue;
        swing.limits.push_back(
            {MARKED("core",
                 "the survey of %1 has the declination %2° (east +), the model %3°: what lies in the ground there is in no "
                 "model; state the variation of the survey"),
                base.name, signedFigureText(surveyed_deg, 1), signedFigureText(*swing.variationOfModel_deg, 1)});
        swing.warnings.push_back(swing.limits.back());
        swing.doubts.emplace_back(swing.used, apart_deg);
    }
}

} // namespace lubberline
