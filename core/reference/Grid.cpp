#include "core/reference/Grid.h"

namespace lubberline {

double convergence_deg(const Place& place, double reference_deg)
{
    const double east = wrap180(place.longitude_deg - reference_deg);
    return wrap180(place.latitude_deg >= 0 ? east : -east);
}

double gridHeading_deg(TrueHeading heading, const Place& place, double reference_deg)
{
    return wrap360(heading.degrees() - convergence_deg(place, reference_deg));
}

double grivation_deg(Variation variation, const Place& place, double reference_deg)
{
    return wrap180(variation.degrees() - convergence_deg(place, reference_deg));
}

} // namespace lubberline
