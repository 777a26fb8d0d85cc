#include "core/swing/Observations.h"

#include "core/base/Contract.h"

namespace lubberline {

Observation observationOf(std::optional<double> indexRemoved_deg, MagneticHeading magnetic, CompassHeading compass)
{
    if (!indexRemoved_deg)
        return {magnetic, compass};
    return {magnetic, CompassHeading::fromDegrees(wrap360(compass.degrees() + *indexRemoved_deg))};
}

Observation observationOf(const Swing& swing, const Reading& reading)
{
    LUBBERLINE_EXPECT(reading.complete(), "a reading of two headings is asked for");
    return observationOf(swing.indexRemoved_deg, *reading.magnetic, *reading.compass);
}

std::vector<Observation> observationsOf(const Swing& swing)
{
    std::vector<Observation> observations;
    observations.reserve(swing.readings.size());
    for (const auto& reading : swing.readings)
        if (reading.used())
            observations.push_back(observationOf(swing, reading));
    return observations;
}

} // namespace lubberline
