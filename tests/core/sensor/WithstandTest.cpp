// Fields, attitudes and iron at which formulas break: a clear answer or a clear refusal, never NaN.

#include <gtest/gtest.h>

#include "core/sensor/PoissonSmith.h"
#include "tests/core/sensor/Chain.h"

namespace lubberline::test {
namespace {

void expectFinite(const SensorReading& reading)
{
    EXPECT_TRUE(reading.field_nT.allFinite());
    EXPECT_TRUE(std::isfinite(reading.horizontal_nT));
    EXPECT_EQ(reading.compass.has_value(), reading.deviation.has_value());
    if (reading.compass) {
        EXPECT_TRUE(reading.compass->degrees() >= 0 && reading.compass->degrees() < 360) << reading.compass->degrees();
        EXPECT_TRUE(std::abs(reading.deviation->degrees()) <= 180);
    }
}

SensorModel hardIron(double P, double Q, double R)
{
    SensorModel model;
    model.hardIron_nT = {P, Q, R};
    return model;
}

TEST(Withstand, noFieldAtAll)
{
    const auto reading = readLevel(SensorModel{}, {0, 0}, 30);
    expectFinite(reading);
    EXPECT_FALSE(reading.compass);
    EXPECT_EQ(reading.horizontal_nT, 0);
}

TEST(Withstand, atAMagneticPole)
{
    for (const double down_nT : {56000.0, -56000.0})
        for (int heading_deg = 0; heading_deg < 360; heading_deg += 15)
            for (const double pitch_deg : {-90.0, -30.0, 0.0, 90.0})
                for (const double roll_deg : {-180.0, -45.0, 0.0, 90.0}) {
                    const Attitude attitude{MagneticHeading::fromDegrees(heading_deg), toRadians(pitch_deg), toRadians(roll_deg)};
                    const auto reading = readSensor(SensorModel{}, {0, down_nT}, attitude);
                    expectFinite(reading);
                    EXPECT_FALSE(reading.compass) << "dip of 90°: nothing is left for a compass";
                }
    // With hard iron the compass points along the iron on every heading.
    for (int heading_deg = 0; heading_deg < 360; heading_deg += 15)
        EXPECT_NEAR(readLevel(hardIron(1000, 0, 0), {0, 56000}, heading_deg).deviation->degrees(), wrap180(heading_deg), 1e-12);
}

TEST(Withstand, theIronCancelsTheField)
{
    const MeridianField field{20000, 40000};
    const SensorModel model = hardIron(-20000, 0, 0);
    EXPECT_FALSE(readLevel(model, field, 0).compass);
    EXPECT_TRUE(readLevel(model, field, 1e-6).compass) << "beside it the compass still points";
    EXPECT_TRUE(readLevel(model, field, 180).compass);
}

TEST(Withstand, straightUpAndStraightDown)
{
    std::mt19937 random(21);
    for (const double pitch_deg : {90.0, -90.0})
        for (int i = 0; i < 200; ++i) {
            const Attitude attitude{MagneticHeading::fromDegrees(1.8 * i), toRadians(pitch_deg), toRadians(1.7 * i - 170)};
            const auto plain = readSensor(SensorModel{}, dipField(18500, 67), attitude);
            expectFinite(plain);
            EXPECT_NEAR(plain.deviation->degrees(), 0, 1e-11) << "heading and roll turn about one axis, but each keeps its meaning";
            expectFinite(readSensor(randomModel(random), dipField(18500, 67), attitude));
        }
}

TEST(Withstand, singularIron)
{
    SensorModel shield; // 1 + S = 0: a sensor in a perfect shield
    shield.softIron = -Eigen::Matrix3d::Identity();
    const auto reading = readLevel(shield, dipField(18500, 67), 50);
    expectFinite(reading);
    EXPECT_FALSE(reading.compass);
    const auto noLambda = smithOf(shield, dipField(18500, 67));
    ASSERT_FALSE(noLambda);
    EXPECT_EQ(noLambda.error().code, ErrorCode::Numeric);
    EXPECT_NE(noLambda.error().message.english().find("λ"), std::string::npos);

    SensorModel flat; // singular only fore and aft: what is left points across
    flat.softIron(0, 0) = -1;
    expectFinite(readLevel(flat, dipField(18500, 67), 50));
    EXPECT_FALSE(readLevel(flat, dipField(18500, 67), 0).compass);
    const auto smith = smithOf(flat, dipField(18500, 67));
    ASSERT_TRUE(smith);
    EXPECT_EQ(smith->lambda, 0.5);
    EXPECT_EQ(smith->exact.D, -1);
    EXPECT_FALSE(smith->approximate);
    EXPECT_NE(smith->whyNoApproximate.english().find("coefficient D"), std::string::npos) << smith->whyNoApproximate.english();
}

TEST(Withstand, ironThatTurnsTheCompassRound)
{
    SensorModel model;
    model.softIron(0, 0) = model.softIron(1, 1) = -1.5;
    const auto smith = smithOf(model, dipField(18500, 67));
    ASSERT_FALSE(smith);
    EXPECT_EQ(smith.error().code, ErrorCode::Numeric);
    EXPECT_NE(smith.error().message.english().find("λ = -0.5"), std::string::npos) << smith.error().message.english();
    // The chain itself still says what the compass does: it points south.
    EXPECT_NEAR(std::abs(readLevel(model, dipField(18500, 67), 50).deviation->degrees()), 180, 1e-12);
}

TEST(Withstand, coefficientsOfOneAndMore)
{
    const auto refusal = [](const SensorModel& model) {
        const auto smith = smithOf(model, {20000, 40000});
        return smith && !smith->approximate ? smith->whyNoApproximate.english() : std::string();
    };
    EXPECT_NE(refusal(hardIron(20000, 0, 0)).find("coefficient B"), std::string::npos) << "just 1: a right angle";
    EXPECT_NE(refusal(hardIron(0, -30000, 0)).find("coefficient C"), std::string::npos);
    SensorModel model;
    model.softIron(1, 0) = 2.5;
    EXPECT_NE(refusal(model).find("coefficient A"), std::string::npos);
    model.softIron << 0, 1.5, 0, 1.5, 0, 0, 0, 0, 0;
    EXPECT_NE(refusal(model).find("coefficient E"), std::string::npos);
    model.softIron << 3, 0, 0, 0, -3.5, 0, 0, 0, 0; // 𝔇 of 4.33 would make the divisors of B and C vanish or turn
    EXPECT_NE(refusal(model).find("coefficient D"), std::string::npos) << refusal(model);
    EXPECT_EQ(refusal(hardIron(19999, 0, 0)), "");
}

TEST(Withstand, noHorizontalField)
{
    for (const auto& field : {MeridianField{0, 56000}, MeridianField{0, 0}, MeridianField{0, -56000}}) {
        const auto smith = smithOf(hardIron(100, 0, 0), field);
        ASSERT_FALSE(smith);
        EXPECT_EQ(smith.error().code, ErrorCode::Numeric);
        EXPECT_NE(smith.error().message.english().find("H is 0"), std::string::npos);
    }
    const auto smith = smithOf(hardIron(100, 0, 0), {1e-320, 56000});
    ASSERT_FALSE(smith) << "tan I is beyond all numbers";
    EXPECT_EQ(smith.error().code, ErrorCode::Numeric);
}

TEST(Withstand, notANumberInIsNoHeadingOut)
{
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(readLevel(hardIron(nan, 0, 0), dipField(18500, 67), 10).compass);
    EXPECT_FALSE(readLevel(hardIron(infinite, 0, 0), dipField(18500, 67), 10).compass);
    EXPECT_FALSE(smithOf(hardIron(nan, 0, 0), dipField(18500, 67)));
    EXPECT_FALSE(smithOf(SensorModel{}, {nan, 0}));
}

TEST(Withstand, everyCornerAtOnce)
{
    const double corners_deg[] = {-180, -90, 0, 90, 180};
    for (const double heading_deg : corners_deg)
        for (const double pitch_deg : {-90.0, 0.0, 90.0})
            for (const double roll_deg : corners_deg)
                for (const auto& field :
                    {MeridianField{0, 0}, MeridianField{0, 60000}, MeridianField{40000, 0}, MeridianField{1e-300, 1e-300}})
                    for (const double singular : {-2.0, -1.0, 0.0, 1e9}) {
                        SensorModel model = hardIron(singular, 0, -singular);
                        model.softIron.setConstant(singular);
                        expectFinite(readSensor(
                            model, field, {MagneticHeading::fromDegrees(heading_deg), toRadians(pitch_deg), toRadians(roll_deg)}));
                    }
}

} // namespace
} // namespace lubberline::test
