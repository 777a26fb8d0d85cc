#include "core/inflight/InflightSwing.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <vector>

#include "core/angle/Angle.h"
#include "core/base/Number.h"
#include "core/inflight/HeadingNoise.h"
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
    std::vector<SharedDoubt> doubts{east, north, SharedDoubt(compass.size(), solution.variationError_deg)};
    for (std::size_t leg = 0; leg < compass.size(); ++leg) { // of so few readings no scatter shows what each has by itself
        doubts.emplace_back(compass.size(), 0.0);
        doubts.back()[leg] = solution.legError_deg;
    }
    swing.sharedErrors = sharedErrorsOf(compass, doubts);
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

std::optional<ContinuousState> stateAfter(std::span<const Swing> swings, std::optional<double> noise_deg)
{
    constexpr double kUsual = kUsualNoise_deg * kUsualNoise_deg;
    std::vector<HeadingRow> rows;
    for (const Swing& swing : swings)
        for (const Observation& read : observationsOf(swing)) {
            const double deviation_deg = deviationOf(read.magnetic, read.compass).degrees();
            const double first_deg = rows.empty() ? deviation_deg : rows.front().z; // of a reciprocal +179 and −179 are neighbours
            rows.push_back({continuousRow(read.compass.degrees(), {}, 0), first_deg + wrap180(deviation_deg - first_deg), kUsual});
        }
    const double variance = noise_deg ? *noise_deg * *noise_deg : kUsual * std::max(1.0, scatterOf(rows).blended());
    StateFilter filter(5);
    for (const HeadingRow& row : rows)
        filter.update(row.h, row.z, variance);
    if (!filter.told())
        return {};
    return ContinuousState{0, static_cast<std::int64_t>(rows.size()), {}, {}, filter.state(), filter.covariance()};
}

} // namespace lubberline
