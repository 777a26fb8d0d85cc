// An unlevelled sensor read as if level: Kayton & Fried, Avionics Navigation Systems, 2nd ed., equations 9.13–9.17 and
// problem 9.6, as limits of the chain. And what a misaligned mount does to a level swing.

#include <gtest/gtest.h>

#include "core/deviation/Harmonics.h"
#include "tests/core/sensor/Chain.h"

namespace lubberline::test {
namespace {

/// The deviation of a sensor that leans with the aircraft, read by [P 19] as if it were level.
double readAsIfLevel_rad(const MeridianField& field, double heading_deg, double pitch_rad, double roll_rad)
{
    const auto reading = readSensor(SensorModel{}, field, {MagneticHeading::fromDegrees(heading_deg), pitch_rad, roll_rad});
    return deviationOf(
        MagneticHeading::fromDegrees(heading_deg), CompassHeading::fromRadians(std::atan2(-reading.field_nT.y(), reading.field_nT.x())))
        .radians();
}

/// A mount that leans by pitch and roll in a level aircraft sees the same.
double leaningMount_rad(const MeridianField& field, double heading_deg, double pitch_rad, double roll_rad)
{
    SensorModel model;
    model.misalignment = {roll_rad, pitch_rad, 0};
    return readLevel(model, field, heading_deg).deviation->radians();
}

TEST(Tilt, problem9_6NoseNorthStarboardWingDownFiveDegrees)
{
    const MeridianField field = dipField(18500, 67);
    // It reads 11.6° low: the deviation, magnetic − compass, is +11.6°; exactly, tan δ = sin φ tan I.
    const double deviation_rad = readAsIfLevel_rad(field, 0, 0, toRadians(5));
    EXPECT_NEAR(toDegrees(deviation_rad), 11.6, 0.05);
    EXPECT_NEAR(deviation_rad, std::atan(std::sin(toRadians(5)) * std::tan(toRadians(67))), 1e-13);
    EXPECT_NEAR(toDegrees(leaningMount_rad(field, 0, 0, toRadians(5))), 11.6, 0.05);
    // The other wing down, and the other hemisphere, turn the sign round.
    EXPECT_NEAR(readAsIfLevel_rad(field, 0, 0, toRadians(-5)), -deviation_rad, 1e-13);
    EXPECT_NEAR(readAsIfLevel_rad(dipField(18500, -67), 0, 0, toRadians(5)), -deviation_rad, 1e-13);
}

TEST(Tilt, equations9_16And9_17AreTheLimitOfSmallAngles)
{
    for (const double dip_deg : {-60.0, -5.0, 0.0, 45.0, 67.0, 80.0})
        for (int heading_deg = 0; heading_deg < 360; heading_deg += 15) {
            const double tanI = std::tan(toRadians(dip_deg)), psi = toRadians(heading_deg);
            const double pitch = 0.6e-5, roll = -0.8e-5;
            const double limit_rad = (roll * std::cos(psi) - pitch * std::sin(psi)) * tanI;
            // What is left out is of second order: angles squared, times tan² I and less.
            EXPECT_NEAR(readAsIfLevel_rad(dipField(18500, dip_deg), heading_deg, pitch, roll), limit_rad, 1e-10 * (1 + tanI * tanI));
            EXPECT_NEAR(leaningMount_rad(dipField(18500, dip_deg), heading_deg, pitch, roll), limit_rad, 1e-10 * (1 + tanI * tanI));
        }
}

TEST(Tilt, theRemainderIsOfSecondOrder)
{
    const MeridianField field = dipField(18500, 67);
    const auto remainder = [&](double angle_rad) {
        const double limit_rad = (angle_rad * std::cos(0.7) - angle_rad * std::sin(0.7)) * std::tan(toRadians(67));
        return std::abs(readAsIfLevel_rad(field, toDegrees(0.7), angle_rad, angle_rad) - limit_rad);
    };
    // Half the angle, a quarter of what the limit leaves out.
    EXPECT_NEAR(remainder(1e-3) / remainder(5e-4), 4, 0.05);
}

TEST(Tilt, leaningMountAndUnlevelledSensorAreOne)
{
    for (int i = 0; i < 36; ++i)
        EXPECT_NEAR(
            readAsIfLevel_rad(dipField(18500, 67), 10.0 * i, 0.1, -0.2), leaningMount_rad(dipField(18500, 67), 10.0 * i, 0.1, -0.2), 1e-13);
}

TEST(Tilt, pitchShowsOnEastAndRollOnNorth)
{
    const MeridianField field = dipField(18500, 67);
    const double lean = toRadians(2);
    EXPECT_NEAR(readAsIfLevel_rad(field, 0, lean, 0), 0, 1e-12) << "nose up on north only weakens the field";
    EXPECT_NEAR(readAsIfLevel_rad(field, 90, 0, lean), 0, 1e-12) << "a wing down on east only changes the field's size";
    EXPECT_LT(readAsIfLevel_rad(field, 90, lean, 0), 0) << "nose up on east: the dip pulls the needle aft, to the west of north";
    EXPECT_GT(readAsIfLevel_rad(field, 0, 0, lean), 0) << "starboard wing down on north: the dip pulls the needle to starboard, east";
}

// Harmonics of a misaligned sensor

struct Orders {
    double constant_rad = 0, first_rad = 0, second_rad = 0, higher_rad = 0; ///< amplitudes
};

Orders ordersOf(const SensorModel& model, const MeridianField& field, double pitch_rad, double roll_rad)
{
    std::vector<HarmonicSample> samples;
    for (int i = 0; i < 360; ++i) {
        const auto reading = readSensor(model, field, {MagneticHeading::fromDegrees(i), pitch_rad, roll_rad});
        samples.push_back({toRadians(i), reading.deviation->radians()});
    }
    const auto found = harmonics(samples);
    Orders orders{std::abs(found->orders[0].cos_rad), found->orders[1].amplitude_rad(), found->orders[2].amplitude_rad(), 0};
    for (std::size_t n = 3; n < 20; ++n)
        orders.higher_rad = std::max(orders.higher_rad, found->orders[n].amplitude_rad());
    return orders;
}

SensorModel mounted(double roll_deg, double pitch_deg, double yaw_deg)
{
    SensorModel model;
    model.misalignment = {toRadians(roll_deg), toRadians(pitch_deg), toRadians(yaw_deg)};
    return model;
}

TEST(MisalignedSensor, yawAloneIsCoefficientAOfALevelSwing)
{
    const Orders orders = ordersOf(mounted(0, 0, 3), dipField(18500, 67), 0, 0);
    EXPECT_NEAR(toDegrees(orders.constant_rad), 3, 1e-11);
    EXPECT_LT(orders.first_rad + orders.second_rad + orders.higher_rad, 1e-13);
    EXPECT_NEAR(readLevel(mounted(0, 0, 3), dipField(18500, 67), 40).deviation->degrees(), -3, 1e-11)
        << "turned to starboard it reads high";
}

TEST(MisalignedSensor, yawShowsInTheFirstHarmonicOnceTheAircraftIsTilted)
{
    // Turned about the fin, which leans out of the vertical by the roll: its horizontal part acts as a leaning mount does.
    const double epsilon = 1e-4, roll = toRadians(40);
    SensorModel model;
    model.misalignment.yaw_rad = epsilon;
    const Orders orders = ordersOf(model, dipField(18500, 67), 0, roll);
    EXPECT_NEAR(orders.constant_rad, epsilon * std::cos(roll), 1e-7);
    EXPECT_NEAR(orders.first_rad, epsilon * std::sin(roll) * std::tan(toRadians(67)), 1e-7);
    EXPECT_LT(orders.second_rad, 1e-3 * orders.first_rad);
}

/// [P] finds a misaligned sensor's map dominated by the second harmonic in heading. In this model that is so where the dip is
/// small: a mount that leans by ε gives a first harmonic ε tan I and a second one of about ε²/4.
TEST(MisalignedSensor, theSecondHarmonicDominatesWhereTheDipIsSmall)
{
    for (const auto& model : {mounted(5, 0, 0), mounted(0, 5, 0), mounted(4, -3, 0)})
        for (const double roll_deg : {0.0, 20.0, -45.0}) {
            const Orders orders = ordersOf(model, dipField(40000, 0), 0, toRadians(roll_deg));
            EXPECT_GT(orders.second_rad, 100 * orders.first_rad) << roll_deg;
            EXPECT_GT(orders.second_rad, 10 * orders.higher_rad) << roll_deg;
        }
    // Level, leaning by ε about one axis: 𝔇 = tan²(ε/2).
    const double epsilon = toRadians(5);
    EXPECT_NEAR(ordersOf(mounted(5, 0, 0), dipField(40000, 0), 0, 0).second_rad, std::pow(std::tan(epsilon / 2), 2), 1e-9);
}

/// At middle latitudes the first harmonic is far the larger, level and tilted, whatever the axis of a mount that leans.
TEST(MisalignedSensor, theFirstHarmonicDominatesAtMiddleLatitudes)
{
    for (const auto& model : {mounted(5, 0, 0), mounted(0, 5, 0), mounted(4, -3, 0), mounted(3, 3, 3)})
        for (const double roll_deg : {0.0, 20.0, -45.0})
            for (const double pitch_deg : {0.0, 15.0, -30.0}) {
                const Orders orders = ordersOf(model, dipField(18500, 67), toRadians(pitch_deg), toRadians(roll_deg));
                EXPECT_GT(orders.first_rad, 5 * orders.second_rad) << roll_deg << " " << pitch_deg;
            }
    // They change places where tan I is about ε/4.
    const double epsilon = toRadians(5);
    const auto larger = [&](double tanI) {
        const Orders orders = ordersOf(mounted(5, 0, 0), {40000, 40000 * tanI}, 0, 0);
        return orders.first_rad > orders.second_rad;
    };
    EXPECT_FALSE(larger(0.9 * epsilon / 4));
    EXPECT_TRUE(larger(1.1 * epsilon / 4));
}

} // namespace
} // namespace lubberline::test
