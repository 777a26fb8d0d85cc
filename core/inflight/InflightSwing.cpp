#include "core/inflight/InflightSwing.h"

#include "core/swing/Observations.h"

namespace lubberline {

namespace {

Swing swingInFlight(std::string datum)
{
    Swing swing;
    swing.kind = SwingKind::Air;
    swing.stage = SwingStage::NotStated;
    swing.datum.instrument = std::move(datum);
    return swing;
}

} // namespace

Swing swingOf(const LegsSolution& solution)
{
    Swing swing = swingInFlight("GPS tracks of legs, wind taken out");
    for (const auto& one : solution.legs)
        if (one.magneticHeading_deg && one.leg.compassHeading_deg) {
            Reading reading;
            reading.magnetic = MagneticHeading::fromDegrees(*one.magneticHeading_deg);
            reading.compass = CompassHeading::fromDegrees(*one.leg.compassHeading_deg);
            reading.note = one.leg.name;
            swing.readings.push_back(std::move(reading));
        }
    return swing;
}

Swing swingOf(std::span<const LegMean> legs)
{
    Swing swing = swingInFlight("heading reference in flight");
    for (const auto& leg : legs) {
        Reading reading;
        reading.compass = CompassHeading::fromDegrees(leg.compassHeading_deg);
        reading.magnetic = toMagnetic(*reading.compass, Deviation::fromDegrees(leg.deviation_deg));
        reading.note = leg.leg;
        swing.readings.push_back(std::move(reading));
    }
    return swing;
}

std::optional<ContinuousState> stateAfter(std::span<const Swing> swings, double noise_deg)
{
    StateFilter filter(5);
    std::int64_t updates = 0;
    for (const Swing& swing : swings)
        for (const Observation& read : observationsOf(swing)) {
            filter.update(
                continuousRow(read.compass.degrees(), {}, 0), deviationOf(read.magnetic, read.compass).degrees(), noise_deg * noise_deg);
            ++updates;
        }
    if (!filter.told())
        return {};
    return ContinuousState{0, updates, {}, {}, filter.state(), filter.covariance()};
}

} // namespace lubberline
