// Kayton and Fried's examples and problems 9.1 to 9.6, recomputed to 1e-4 and as they are printed, and the tilted compass.

#include <gtest/gtest.h>

#include "core/angle/Angle.h"
#include "core/reference/DirectionalGyro.h"
#include "core/reference/LevellingLoop.h"
#include "core/reference/TiltedCompass.h"
#include "core/reference/VerticalFormulas.h"
#include "core/sensor/Attitude.h"

namespace lubberline {
namespace {

constexpr double kFoot = 0.3048, kBookGravity = 32.2 * kFoot;

TEST(KaytonProblems, tiltOfTheApparentVertical)
{
    EXPECT_NEAR(toDegrees(apparentTilt_rad(20, -10, 32.2)), 42.016, 42.016e-4); // 9.2
    EXPECT_NEAR(toDegrees(apparentTilt_rad(20, -10, 32.2)), 42, 0.5);
    EXPECT_NEAR(toDegrees(apparentTilt_rad(5, 0, 1)), 78.69, 0.005); // 5 g level, the book's 79
    EXPECT_NEAR(toDegrees(apparentTilt_rad(5, 0, 1)), 79, 0.5);
}

TEST(KaytonProblems, examplesAt1000FeetASecondAnd70Degrees)
{
    const double V = 1000 * kFoot, latitude = toRadians(70);
    EXPECT_NEAR(toDegrees(constantLatitudeTilt_rad(V, latitude, kBookGravity)), 0.2336, 0.2336e-3); // printed 0.20: wrong
    EXPECT_NEAR(toDegrees(constantLatitudeTilt_rad(V, toRadians(67), kBookGravity)), 0.20, 0.005);  // what it belongs to
    EXPECT_NEAR(coriolis_m_s2(V, latitude) / kFoot, 0.13705, 0.13705e-4);
    EXPECT_NEAR(toDegrees(coriolis_m_s2(V, latitude) / kBookGravity), 0.24386, 0.24386e-4);
    EXPECT_NEAR(toDegrees(coriolis_m_s2(V, latitude) / kBookGravity), 0.24, 0.005);
    EXPECT_NEAR(toDegrees(turnRateErrorTilt_rad(V, toRadians(1) / 3600, kBookGravity)), 0.0086266, 0.0086266e-4);
    EXPECT_NEAR(toDegrees(transportRate_rad_s(V)) * 3600, 9.857, 0.001);
}

TEST(KaytonProblems, axialStabilityAndGain)
{
    const double x = axialShift_cm(toRadians(0.25) / 3600, 1e7, 500); // 9.1
    EXPECT_NEAR(x, 2.472e-5, 2.472e-8);
    EXPECT_NEAR(x, 2.5e-5, 0.05e-5);
    EXPECT_NEAR(torquePerTilt(1e7, 60), 166667, 17);                                           // 9.3
    EXPECT_NEAR(torquePerTilt(1e7, 60) / (0.5 * kDegreesPerRadian * 5000), 1.1636, 1.1636e-4); // printed 1.12: wrong
}

TEST(KaytonProblems, criticallyDampedLevelling) // 9.4
{
    const double amplitude_deg = toDegrees(2 / 32.2), frequency = 2 * kPi / 15;
    EXPECT_NEAR(amplitude_deg, 3.55874, 3.6e-4);
    VerticalGyro loop;
    loop.loop = LoopKind::Damped;
    loop.tau2_s = 0.16666 * 60;
    loop.tau1_s = 0.66662 * 60;
    EXPECT_NEAR(characterOf(loop).damping, 1, 1e-3);
    EXPECT_NEAR(amplitude_deg * gainAt(loop, frequency), 0.05, 0.05 * 1e-3);
    loop.tau2_s = 0.165 * 60; // as printed: over what was asked for
    loop.tau1_s = 0.66 * 60;
    EXPECT_NEAR(amplitude_deg * gainAt(loop, frequency), 0.05099, 1e-5);
    EXPECT_NEAR(0.16666, 0.165, 0.165 * 0.02);
}

TEST(KaytonProblems, slavedToATiltedMagnetometer) // 9.5
{
    const double read_deg = toDegrees(2 / 32.2) * std::tan(toRadians(60)), frequency = 2 * kPi / 15;
    EXPECT_NEAR(read_deg, 6.16393, 6.2e-4);
    EXPECT_NEAR(read_deg * slavingGain(147.13, frequency), 0.1, 1e-5);
    EXPECT_NEAR(147.13 / 60, 2.45, 0.005);
}

struct Tilted {
    double heading, pitch, roll, dip, exact, small;
};

TEST(TiltedCompass, exactAndSmall) // 9.6, whose printed sign is deviation's
{
    for (const Tilted& one : {Tilted{0, 0, 5, 67, -11.6031, -11.7793}, {180, 0, 5, 67, 11.6031, 11.7793}, {90, 5, 0, 67, 11.6031, 11.7793},
             {45, 3, -4, 60, 8.3955, 8.5732}, {0, 0, 15, 60, -24.1461, -25.9808}, {0, 0, 15, 67, -31.3723, -35.3378}}) {
        const auto heading = MagneticHeading::fromDegrees(one.heading);
        const SensorTilt tilt{toRadians(one.pitch), toRadians(one.roll)};
        EXPECT_NEAR(toDegrees(tiltError_rad(heading, tilt, toRadians(one.dip))), one.exact, 6e-5);
        EXPECT_NEAR(toDegrees(smallTiltError_rad(heading, tilt, toRadians(one.dip))), one.small, 6e-5);
    }
}

TEST(TiltedCompass, headingAndDipComeBack)
{
    const Eigen::Vector3d field
        = rotation(toRadians(-25), toRadians(12), toRadians(123)) * Eigen::Vector3d(std::cos(toRadians(67)), 0, std::sin(toRadians(67)));
    const auto back = headingAndDipOf(field, {toRadians(12), toRadians(-25)});
    EXPECT_NEAR(back.heading.degrees(), 123, 1e-9);
    EXPECT_NEAR(toDegrees(back.dip_rad), 67, 1e-9);
}

TEST(TiltedCompass, thePilotsRules)
{
    const double dip = toRadians(67);
    const SensorTilt accelerated = hangingTilt(0.1 * kGravity_m_s2, 0, 0);
    for (const auto& [heading, error] : {std::pair{0.0, 0.0}, {90.0, -13.193}, {180.0, 0.0}, {270.0, 13.193}})
        EXPECT_NEAR(toDegrees(tiltError_rad(MagneticHeading::fromDegrees(heading), accelerated, dip)), error, 6e-4);
    const double speed = 120 * 1852 / 3600.0; // rate one to the right
    const SensorTilt turning = hangingTilt(0, speed * toRadians(3), 0);
    EXPECT_NEAR(toDegrees(turning.roll_rad), 18.243, 6e-4);
    for (const auto& [heading, error] : {std::pair{0.0, -36.408}, {45.0, -50.325}, {90.0, 0.0}, {135.0, 50.325}, {180.0, 36.408},
             {225.0, 18.351}, {270.0, 0.0}, {315.0, -18.351}})
        EXPECT_NEAR(toDegrees(tiltError_rad(MagneticHeading::fromDegrees(heading), turning, dip)), error, 6e-4) << heading;
}

} // namespace
} // namespace lubberline
