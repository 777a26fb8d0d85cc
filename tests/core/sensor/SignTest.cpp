// Which way the compass turns, in words and numbers. A north-seeking pole drives the needle's north end away.

#include <gtest/gtest.h>

#include "tests/core/sensor/Chain.h"

namespace lubberline::test {
namespace {

const MeridianField kNorthern = dipField(20000, 65);

double deviation_deg(const SensorModel& model, double heading_deg, const MeridianField& field = kNorthern)
{
    return readLevel(model, field, heading_deg).deviation->degrees();
}

SensorModel hardIron(double P, double Q, double R)
{
    SensorModel model;
    model.hardIron_nT = {P, Q, R};
    return model;
}

SensorModel softIron(int row, int column, double value)
{
    SensorModel model;
    model.softIron(row, column) = value;
    return model;
}

TEST(Signs, aNorthSeekingPoleAhead)
{
    // Its field at the sensor points aft. Nose east, the needle is driven west: the compass reads more than 90, deviation west.
    const SensorModel magnet = hardIron(-2000, 0, 0);
    EXPECT_NEAR(deviation_deg(magnet, 90), -toDegrees(std::atan2(2000.0, 20000.0)), 1e-12);
    EXPECT_GT(readLevel(magnet, kNorthern, 90).compass->degrees(), 90);
    EXPECT_NEAR(deviation_deg(magnet, 270), +toDegrees(std::atan2(2000.0, 20000.0)), 1e-12);
    // Nose north or south it only weakens or strengthens the field.
    EXPECT_NEAR(deviation_deg(magnet, 0), 0, 1e-12);
    EXPECT_NEAR(deviation_deg(magnet, 180), 0, 1e-12);
    EXPECT_NEAR(readLevel(magnet, kNorthern, 0).horizontal_nT, 18000, 1e-9);
    EXPECT_NEAR(readLevel(magnet, kNorthern, 180).horizontal_nT, 22000, 1e-9);
}

TEST(Signs, aNorthSeekingPoleToPort)
{
    // Its field points to starboard. Nose north, the needle goes east: the compass reads less than 360, deviation east.
    const SensorModel magnet = hardIron(0, 2000, 0);
    EXPECT_NEAR(deviation_deg(magnet, 0), +toDegrees(std::atan2(2000.0, 20000.0)), 1e-12);
    EXPECT_NEAR(readLevel(magnet, kNorthern, 0).compass->degrees(), 360 - toDegrees(std::atan(0.1)), 1e-9);
    EXPECT_NEAR(deviation_deg(magnet, 180), -toDegrees(std::atan2(2000.0, 20000.0)), 1e-12);
    EXPECT_NEAR(deviation_deg(magnet, 90), 0, 1e-12);
}

TEST(Signs, aNorthSeekingPoleAboveTellsOnlyWhenTheAircraftHeels)
{
    // Its field points to the floor. Level: nothing. Starboard wing down on north, the floor looks to port: the needle goes
    // west.
    const SensorModel magnet = hardIron(0, 0, 3000);
    for (int heading_deg = 0; heading_deg < 360; heading_deg += 30)
        EXPECT_NEAR(deviation_deg(magnet, heading_deg), 0, 1e-12);
    const auto heeled = readSensor(magnet, kNorthern, {MagneticHeading::fromDegrees(0), 0, toRadians(10)});
    EXPECT_NEAR(heeled.deviation->radians(), -std::atan2(3000 * std::sin(toRadians(10)), 20000.0), 1e-12);
}

TEST(Signs, ironRodsAlongTheFuselageAndAcross)
{
    // Fore-and-aft iron (+a) pulls the needle towards the fuselage line: nose north-east, to the east. Quadrantal: D > 0.
    const SensorModel along = softIron(0, 0, 0.1);
    EXPECT_GT(deviation_deg(along, 45), 0);
    EXPECT_LT(deviation_deg(along, 135), 0);
    EXPECT_NEAR(deviation_deg(along, 45), deviation_deg(along, 225), 1e-12);
    EXPECT_NEAR(deviation_deg(along, 0), 0, 1e-12);
    EXPECT_LT(deviation_deg(softIron(1, 1, 0.1), 45), 0) << "iron across (+e) the other way";
}

TEST(Signs, verticalIronAheadChangesSidesAtTheEquator)
{
    // +c: the vertical field magnetises iron so that its field at the sensor points forward in the north.
    const SensorModel vertical = softIron(0, 2, 0.05);
    EXPECT_GT(deviation_deg(vertical, 90), 0);
    EXPECT_NEAR(deviation_deg(vertical, 90, dipField(20000, 0)), 0, 1e-12);
    EXPECT_NEAR(deviation_deg(vertical, 90, dipField(20000, -65)), -deviation_deg(vertical, 90), 1e-12);
}

TEST(Signs, unsymmetricalIronTurnsLikeAMount)
{
    // d = −b > 0: the same on all headings, to first order; a mount turned to starboard (+yaw) reads high: d − b < 0.
    SensorModel model;
    model.softIron(1, 0) = 0.02;
    model.softIron(0, 1) = -0.02;
    for (int heading_deg = 0; heading_deg < 360; heading_deg += 45)
        EXPECT_NEAR(deviation_deg(model, heading_deg), toDegrees(std::atan(0.02)), 1e-12);
}

TEST(Signs, aCircuitActsWhenItIsOn)
{
    SensorModel model;
    model.circuits = {{"landing light", {0, 50, 0}, 20, true}};
    EXPECT_NEAR(deviation_deg(model, 0), toDegrees(std::atan2(1000.0, 20000.0)), 1e-12);
    model.circuits[0].current_A = -20;
    EXPECT_NEAR(deviation_deg(model, 0), -toDegrees(std::atan2(1000.0, 20000.0)), 1e-12);
    model.circuits[0].on = false;
    EXPECT_NEAR(deviation_deg(model, 0), 0, 1e-12);
}

TEST(Signs, hardIronSoftConstantAndCurrentsAddUp)
{
    SensorModel parts = hardIron(300, -200, 100), sum = hardIron(1000, 1000, 1000);
    parts.softConstant_nT = {200, 700, 400};
    parts.circuits = {{"one", {25, 25, 25}, 20, true}};
    EXPECT_TRUE(responseOf(parts).offset_nT.isApprox(responseOf(sum).offset_nT, 1e-15));
}

// Polar form [P 16]

TEST(PolarHardIron, directionsInWords)
{
    EXPECT_NEAR(toPolar({0, 500, 0}).azimuth_rad, kPi / 2, 1e-15) << "to starboard";
    EXPECT_NEAR(toPolar({0, 0, -500}).elevation_rad, kPi / 2, 1e-15) << "upward is positive, and z is down";
    EXPECT_EQ(toPolar({0, 0, -500}).azimuth_rad, 0);
    EXPECT_EQ(toPolar({-0.0, 0.0, 5}).azimuth_rad, 0);
    EXPECT_EQ(toPolar({0, 0, 0}).size_nT, 0);
    EXPECT_EQ(toPolar({0, 0, -0.0}).elevation_rad, 0);
    EXPECT_NEAR(toPolar({-300, 0, 0}).azimuth_rad, kPi, 1e-15);
}

TEST(PolarHardIron, thereAndBack)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int i = 0; i < 1000; ++i) {
        const Eigen::Vector3d p{5000 * unit(random), 5000 * unit(random), 5000 * unit(random)};
        const PolarHardIron polar = toPolar(p);
        EXPECT_NEAR((fromPolar(polar) - p).norm(), 0, 1e-11 * polar.size_nT);
        EXPECT_GE(polar.size_nT, 0);
        EXPECT_LE(std::abs(polar.elevation_rad), kPi / 2);
    }
    // [P 16] written out
    const Eigen::Vector3d p = fromPolar({1000, 0.3, 0.8});
    EXPECT_NEAR(p.x(), 1000 * std::cos(0.3) * std::cos(0.8), 1e-12);
    EXPECT_NEAR(p.y(), 1000 * std::cos(0.3) * std::sin(0.8), 1e-12);
    EXPECT_NEAR(p.z(), -1000 * std::sin(0.3), 1e-12);
}

} // namespace
} // namespace lubberline::test
