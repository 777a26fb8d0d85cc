#include "core/inflight/InflightSwing.h"

#include "core/base/Number.h"
#include "core/swing/Observations.h"
#include "core/swing/SharedDoubts.h"

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
    const Eigen::Matrix2d half = solution.air.covariance.llt().matrixL(); // of the wind, which all legs have in them
    std::vector<CompassHeading> compass;
    SharedDoubt east, north;
    for (const auto& one : solution.legs)
        if (one.magneticHeading_deg && one.leg.compassHeading_deg) {
            Reading reading;
            reading.magnetic = MagneticHeading::fromDegrees(*one.magneticHeading_deg);
            reading.compass = CompassHeading::fromDegrees(*one.leg.compassHeading_deg);
            reading.note = one.leg.name;
            reading.extra.emplace_back(kDatumErrorColumn, figureText(one.standardError_deg, 2));
            swing.readings.push_back(std::move(reading));
            compass.push_back(*swing.readings.back().compass);
            const Eigen::Vector2d turned = half.transpose() * turnedByWind_deg(solution.air, one.leg.track_deg, one.leg.groundSpeed_kt);
            east.push_back(turned.x());
            north.push_back(turned.y());
        }
    swing.sharedErrors = sharedErrorsOf(compass, std::vector{east, north, SharedDoubt(compass.size(), solution.variationError_deg)});
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
