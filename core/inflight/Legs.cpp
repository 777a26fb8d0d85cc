#include "core/inflight/Legs.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/angle/Circle.h"
#include "core/angle/Heading.h"
#include "core/base/Number.h"
#include "core/inflight/WindVector.h"

namespace lubberline {

namespace {

constexpr double kNoHeading_deg = 20.0; ///< one that is uncertain by more

/// There and back, however often: all directions within a few degrees of one line.
bool alongOneLine(std::span<const Leg> legs)
{
    constexpr double kTogether = 0.9; // within some 15° of each other: wind turns tracks
    std::vector<double> doubled_deg;
    for (const auto& leg : legs)
        doubled_deg.push_back(2 * leg.track_deg);
    const double opposite = circularMean(doubled_deg).togetherness;
    doubled_deg.clear();
    for (const auto& leg : legs)
        doubled_deg.push_back(leg.track_deg);
    return opposite > kTogether && circularMean(doubled_deg).togetherness < kTogether;
}

} // namespace

Result<LegsSolution> solveLegs(std::span<const Leg> legs, const LegsOptions& options)
{
    if (legs.size() < 3)
        return Error{
            ErrorCode::InvalidInput, {MARKED("core", "there are %1 legs; expected three at least, on headings all round"), legs.size()}};
    std::vector<GroundVelocity> velocities;
    for (const auto& leg : legs)
        velocities.push_back({leg.track_deg, leg.groundSpeed_kt});
    const auto air = airMassOf(velocities, {3, false, options.speedError_kt, false});
    const Error untold{ErrorCode::Numeric,
        alongOneLine(legs)
            ? MARKED("core",
                "the legs do not tell the wind: they lie along one line, there and back; expected them all round, as 120\u00B0 apart")
            : MARKED("core",
                "the legs do not tell the wind: their directions over ground lie on too short an arc; expected them all round, as 120\u00B0 apart")};
    if (!air)
        return untold;
    LegsSolution solution;
    solution.air = *air;
    solution.variationError_deg = options.variationError_deg;
    const double own_deg = toDegrees(options.speedError_kt / std::max(air->airspeed_kt, 1e-9));
    solution.legError_deg = own_deg;
    bool anyVariation = true;
    for (const auto& leg : legs) {
        SolvedLeg solved;
        solved.leg = leg;
        solved.trueHeading_deg = headingInWind_deg(*air, leg.track_deg, leg.groundSpeed_kt);
        const Eigen::Vector2d turned = turnedByWind_deg(*air, leg.track_deg, leg.groundSpeed_kt);
        solved.standardError_deg = std::sqrt(turned.dot(air->covariance * turned) + own_deg * own_deg);
        if (solved.standardError_deg > kNoHeading_deg) // any three points lie on some circle
            return untold;
        solved.offCircle_kt = (velocityOf(leg.track_deg, leg.groundSpeed_kt) - air->toward_kt).norm() - air->airspeed_kt;
        const auto variation_deg = leg.variation_deg ? leg.variation_deg : options.variation_deg;
        if (variation_deg) {
            const auto magnetic = toMagnetic(TrueHeading::fromDegrees(solved.trueHeading_deg), Variation::fromDegrees(*variation_deg));
            solved.magneticHeading_deg = magnetic.degrees();
            if (leg.compassHeading_deg)
                solved.deviation_deg = deviationOf(magnetic, CompassHeading::fromDegrees(*leg.compassHeading_deg)).degrees();
        } else {
            anyVariation = false;
        }
        solution.legs.push_back(std::move(solved));
    }
    if (legs.size() == 3)
        solution.warnings.push_back(
            {MARKED("core", "three legs determine the wind exactly: nothing is left to check it; errors are those of %1 kt in each leg"),
                figureText(options.speedError_kt, 1)});
    else if (air->scatter_kt > 3 * options.speedError_kt)
        solution.warnings.push_back({MARKED("core", "the legs are off one circle by %1 kt: wind or airspeed changed between them"),
            figureText(air->scatter_kt, 1)});
    solution.warnings.push_back(
        {MARKED("core",
             "one wind and one airspeed on all legs are assumed, and not all of it shows: 1 kt faster one way and 1 kt slower the other is taken for wind, and turns headings by up to %1\u00B0"),
            figureText(toDegrees(1.0 / std::max(air->airspeed_kt, 1.0)), 1)});
    if (!anyVariation)
        solution.warnings.push_back(MARKED("core", "no variation is stated: headings are true, and deviations are not told"));
    return solution;
}

} // namespace lubberline
