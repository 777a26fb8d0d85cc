#include "core/swing/Observations.h"

#include "core/base/Contract.h"

namespace lubberline {

Observation observationOf(const Swing& swing, const Reading& reading)
{
    LUBBERLINE_EXPECT(reading.complete(), "a reading of two headings is asked for");
    if (!swing.indexRemoved_deg)
        return {*reading.magnetic, *reading.compass};
    return {*reading.magnetic, CompassHeading::fromDegrees(wrap360(reading.compass->degrees() + *swing.indexRemoved_deg))};
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
