// The chain from the Earth's field to the compass heading, held against a second implementation (Chain.h), at any attitude.

#include <gtest/gtest.h>

#include "tests/core/sensor/Chain.h"

namespace lubberline::test {
namespace {

/// Of two headings [deg].
double apart_deg(long double a_rad, double b_deg)
{
    return static_cast<double>(std::abs(std::remainder(a_rad * 180 / std::numbers::pi_v<long double> - b_deg, 360.0L)));
}

struct Worst {
    double heading_deg = 0;
    int compared = 0;
};

/// Random attitudes over the full ranges of the paper, each with a model and a field of its own.
Worst worstOf(int attitudes, double softIron, double constant_nT, double turned_rad)
{
    std::mt19937 random(20261123);
    std::uniform_real_distribution<double> unit(-1, 1);
    Worst worst;
    for (int i = 0; i < attitudes; ++i) {
        const SensorModel model = randomModel(random, softIron, constant_nT, turned_rad);
        const double horizontal_nT = 15000 + 14000 * unit(random), dip_deg = 85 * unit(random);
        const MeridianField field = dipField(horizontal_nT, dip_deg);
        const Attitude attitude{MagneticHeading::fromDegrees(180 + 180 * unit(random)), kPi / 2 * unit(random), kPi * unit(random)};
        const SensorReading reading = readSensor(model, field, attitude);
        const ChainReading second = chainReading(model, field, attitude.heading.radians(), attitude.pitch_rad, attitude.roll_rad);
        EXPECT_NEAR(reading.horizontal_nT, static_cast<double>(second.horizontal_nT), 1e-9 * static_cast<double>(second.total_nT));
        // Where little is left of the field, a double's own rounding is more than 1e-9 degrees.
        if (second.horizontal_nT < 1e-4L * second.total_nT)
            continue;
        ++worst.compared;
        if (!reading.compass) {
            ADD_FAILURE() << "no heading, although " << static_cast<double>(second.horizontal_nT) << " nT are left";
            continue;
        }
        worst.heading_deg = std::max(worst.heading_deg, apart_deg(second.compass_rad, reading.compass->degrees()));
        EXPECT_EQ(*reading.deviation, deviationOf(attitude.heading, *reading.compass));
    }
    return worst;
}

TEST(Chain, theWholeChainAtRandomAttitudes)
{
    const Worst worst = worstOf(20'000, 0.2, 4000, 0.2);
    EXPECT_GE(worst.compared, 19'900);
    EXPECT_LT(worst.heading_deg, 1e-9);
}

TEST(Chain, ironStrongerThanTheEarthAndAMountTurnedRound)
{
    const Worst worst = worstOf(5'000, 1.5, 60'000, kPi);
    EXPECT_GE(worst.compared, 4'900);
    EXPECT_LT(worst.heading_deg, 1e-9);
}

TEST(Chain, withoutIronTheCompassIsRightAtAnyAttitude)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int i = 0; i < 2000; ++i) {
        const Attitude attitude{MagneticHeading::fromDegrees(180 + 180 * unit(random)), kPi / 2 * unit(random), kPi * unit(random)};
        const auto reading = readSensor(SensorModel{}, dipField(18500, 67), attitude);
        ASSERT_TRUE(reading.deviation);
        EXPECT_NEAR(reading.deviation->degrees(), 0, 1e-11);
        EXPECT_NEAR(reading.horizontal_nT, 18500, 1e-7);
    }
}

TEST(Chain, wholeTurnsChangeNothing)
{
    std::mt19937 random(2);
    const SensorModel model = randomModel(random);
    const MeridianField field = dipField(18500, 67);
    const Attitude once{MagneticHeading::fromDegrees(77), 0.3, -0.7};
    const Attitude turned{MagneticHeading::fromDegrees(77 + 720), 0.3 + 2 * kPi, -0.7 - 2 * kPi};
    EXPECT_NEAR(readSensor(model, field, once).deviation->radians(), readSensor(model, field, turned).deviation->radians(), 1e-14);
}

TEST(Chain, theLevelFormulaIsTheGeneralOneLevel)
{
    std::mt19937 random(3);
    for (int i = 0; i < 200; ++i) {
        const SensorModel model = randomModel(random);
        const auto reading = readLevel(model, dipField(18500, 67), 1.8 * i);
        // [P 19]
        const double compass_rad = std::atan2(-reading.field_nT.y(), reading.field_nT.x());
        EXPECT_LT(apart_deg(compass_rad, reading.compass->degrees()), 1e-12);
    }
}

TEST(Chain, theFieldKeepsItsSizeInEveryAttitude)
{
    const MeridianField field = dipField(18500, 67);
    const double total_nT = std::hypot(field.horizontal_nT, field.down_nT);
    for (int i = 0; i < 100; ++i) {
        const Attitude attitude{MagneticHeading::fromDegrees(37.0 * i), 0.031 * (i - 50), 0.063 * (i - 50)};
        EXPECT_NEAR(fieldInBody(field, attitude).norm(), total_nT, 1e-9 * total_nT);
    }
}

TEST(Chain, axesAsTheWordsSay)
{
    const MeridianField field{20000, 40000};
    const auto inBody = [&](double heading_deg, double pitch_deg, double roll_deg) {
        return fieldInBody(field, {MagneticHeading::fromDegrees(heading_deg), toRadians(pitch_deg), toRadians(roll_deg)});
    };
    EXPECT_TRUE(inBody(0, 0, 0).isApprox(Eigen::Vector3d(20000, 0, 40000), 1e-15));
    EXPECT_TRUE(inBody(90, 0, 0).isApprox(Eigen::Vector3d(0, -20000, 40000), 1e-15)) << "nose east: north is to port";
    EXPECT_TRUE(inBody(0, 90, 0).isApprox(Eigen::Vector3d(-40000, 0, 20000), 1e-15)) << "nose up: the floor looks north, the tail down";
    EXPECT_TRUE(inBody(0, 0, 90).isApprox(Eigen::Vector3d(20000, 40000, 0), 1e-15)) << "starboard wing down: what is down is to starboard";
}

} // namespace
} // namespace lubberline::test
