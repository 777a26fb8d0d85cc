#include "core/calibration/LineOfSight.h"

#include <gmock/gmock.h>

#include <stdexcept>

#include "core/angle/Angle.h"

namespace lubberline::test {
namespace {

const MeridianField kField = MeridianField::fromDip(20000, toRadians(67));

const SightCause& causeOf(const SightBudget& budget, const std::string& name)
{
    for (const auto& cause : budget.causes)
        if (cause.name.english() == name)
            return cause;
    throw std::runtime_error("no cause " + name);
}

/// Both sensors exact: the line is where one looks, whatever the aircraft's attitude, and no cause moves it.
TEST(LineOfSight, withoutErrorsItIsWhereOneLooks)
{
    SightCase given{.field = kField, .aircraftAttitude = {MagneticHeading::fromDegrees(217), toRadians(8), toRadians(-25)}};
    given.turret.yaw_rad = toRadians(90);
    const auto budget = sightBudget(given, {40, -20}, 15);
    EXPECT_NEAR(budget.truth.aircraft.azimuth_deg, 40, 1e-9);
    EXPECT_NEAR(budget.truth.aircraft.elevation_deg, -20, 1e-9);
    EXPECT_NEAR(budget.truth.turret.azimuth_deg, -50, 1e-9) << "a turret that looks to starboard";
    EXPECT_NEAR(budget.truth.turret.elevation_deg, -20, 1e-9);
    EXPECT_EQ(budget.causes.size(), 12u);
    for (const auto& cause : budget.causes) {
        EXPECT_NEAR(cause.error.turret.azimuth_deg, 0, 1e-9) << cause.name.english();
        EXPECT_NEAR(cause.error.aircraft.elevation_deg, 0, 1e-9) << cause.name.english();
    }
}

/// Nose north, the helmet looks east over a dip of 67°. A pitch error ε of the helmet turns its heading by ε tan I and its elevation by ε.
TEST(LineOfSight, aTiltTurnsTheHeadingByTheTangentOfTheDip)
{
    SightCase given{.field = kField};
    given.helmet.tiltError_deg = 0.1;
    const auto budget = sightBudget(given, {90, 0});
    const auto& pitch = causeOf(budget, "pitch of the helmet");
    EXPECT_TRUE(pitch.byChance);
    EXPECT_NEAR(pitch.error.aircraft.azimuth_deg, 0.1 * std::tan(toRadians(67)), 0.001);
    EXPECT_NEAR(pitch.error.aircraft.elevation_deg, 0.1, 0.001);
    // Towards east a roll error moves nothing of the field that heading rests on (φ cos ψ).
    EXPECT_NEAR(causeOf(budget, "roll of the helmet").error.aircraft.azimuth_deg, 0, 0.001);
    const auto north = sightBudget(given, {0, 0});
    EXPECT_NEAR(causeOf(north, "roll of the helmet").error.aircraft.azimuth_deg, 0.1 * std::tan(toRadians(67)), 0.001);
    EXPECT_NEAR(causeOf(north, "pitch of the helmet").error.aircraft.azimuth_deg, 0, 0.001);
    EXPECT_NEAR(north.byChance.aircraft.azimuth_deg, 0.1 * std::tan(toRadians(67)), 0.001);
}

/// P = 1000 nT on H = 20 000 nT: at 090 a sensor reads atan2(20, 1) = 87.138°.
TEST(LineOfSight, ironOfTheTwoSensorsWorksOppositeWays)
{
    SightCase given{.field = kField, .aircraftAttitude = {MagneticHeading::fromDegrees(90)}};
    given.aircraft.iron.hardIron_nT = {1000, 0, 0};
    EXPECT_NEAR(sightBudget(given, {0, 0}).stays.aircraft.azimuth_deg, 2.862, 0.001) << "the aircraft reads low, the line stands high";
    given.helmet.iron.hardIron_nT = {1000, 0, 0};
    const auto ahead = sightBudget(given, {0, 0});
    EXPECT_NEAR(ahead.stays.aircraft.azimuth_deg, 0, 1e-9) << "the same iron in both, and both look one way";
    EXPECT_NEAR(causeOf(ahead, "iron at the helmet's sensor").error.aircraft.azimuth_deg, -2.862, 0.001);
    EXPECT_NEAR(sightBudget(given, {-90, 0}).stays.aircraft.azimuth_deg, 2.862, 0.001) << "towards north iron ahead turns no heading";
}

/// A field that stands in the cockpit turns no heading of a helmet that looks along it, wherever that is in the helmet's axes.
TEST(LineOfSight, aFieldOfTheCockpitStandsInTheAircraftsAxes)
{
    SightCase given{.field = kField};
    given.cockpit_nT = {1000, 0, 0}; // along north
    for (const double azimuth : {-90.0, 0.0, 60.0})
        EXPECT_NEAR(sightBudget(given, {azimuth, 0}).stays.aircraft.azimuth_deg, 0, 1e-9) << azimuth;
    given.cockpit_nT = {0, 1000, 0}; // east: all headings of the helmet are less by atan(1/20)
    for (const double azimuth : {-90.0, 0.0, 60.0})
        EXPECT_NEAR(sightBudget(given, {azimuth, 0}).stays.aircraft.azimuth_deg, -toDegrees(std::atan(0.05)), 1e-6) << azimuth;
}

/// 0.1° of the mount's roll lifts a line abeam by 0.1° and turns none ahead; errors add as squares.
TEST(LineOfSight, theTurretHasItsOwn)
{
    SightCase given{.field = kField};
    given.turretError_deg = 0.1;
    const auto abeam = sightBudget(given, {90, 0});
    EXPECT_NEAR(causeOf(abeam, "roll of the turret's mount").error.turret.elevation_deg, 0.1, 1e-6);
    EXPECT_NEAR(causeOf(abeam, "roll of the turret's mount").error.aircraft.elevation_deg, 0, 1e-12);
    EXPECT_NEAR(causeOf(abeam, "yaw of the turret's mount").error.turret.azimuth_deg, 0.1, 1e-6);
    given.helmet.noise_nT = 20;
    const auto both = sightBudget(given, {0, 0});
    EXPECT_NEAR(both.byChance.aircraft.azimuth_deg, toDegrees(20.0 / 20000), 1e-4);
    EXPECT_NEAR(both.byChance.turret.azimuth_deg, std::hypot(toDegrees(20.0 / 20000), 0.1), 1e-4);
    EXPECT_NEAR(both.whole.turret.azimuth_deg, both.byChance.turret.azimuth_deg, 1e-12);
}

TEST(LineOfSight, theSweepAndItsLimits)
{
    const auto sweep = sightSweep({.field = kField});
    ASSERT_EQ(sweep.size(), 51u);
    EXPECT_EQ(sweep.front().look.azimuth_deg, -120);
    EXPECT_EQ(sweep.back().look.elevation_deg, 30);
    EXPECT_THAT(together(sightBudget({.field = kField}, {0, 85}).warnings).english(), testing::HasSubstr("steeper than 80"));
    EXPECT_THAT(together(sweep.front().warnings).english(), testing::HasSubstr("not modelled"));
}

} // namespace
} // namespace lubberline::test
