// Gimbal errors, apparent drift and slaving of a directional gyro: figures that were computed apart.

#include <gtest/gtest.h>

#include <cmath>

#include "core/angle/Angle.h"
#include "core/reference/DirectionalGyro.h"
#include "core/reference/Scenario.h"

namespace lubberline {
namespace {

TEST(DirectionalGyro, largestGimbalError)
{
    for (const auto& [tilt, error] :
        {std::pair{5, 0.10922}, {10, 0.43856}, {15, 0.99312}, {20, 1.78168}, {30, 4.11719}, {45, 9.87928}, {60, 19.47122}}) {
        EXPECT_NEAR(toDegrees(largestGimbalError_rad(toRadians(tilt))), error, 6e-6);
        double largest = 0;
        for (int i = 0; i < 3600; ++i)
            largest = std::max(largest, gimbalError_rad(MagneticHeading::fromDegrees(i / 10.0), {0, toRadians(tilt)}));
        EXPECT_NEAR(toDegrees(largest), error, 1e-3);
    }
    EXPECT_NEAR(toDegrees(toRadians(15) * toRadians(15) / 4), 0.9817, 5e-5); // the book's λ²/4
}

TEST(DirectionalGyro, gimbalErrorAtAnAttitude)
{
    const auto error = [](double heading, double pitch, double roll) {
        return toDegrees(gimbalError_rad(MagneticHeading::fromDegrees(heading), {toRadians(pitch), toRadians(roll)}));
    };
    EXPECT_NEAR(error(45, 0, 15), toDegrees(std::atan(std::cos(toRadians(15)))) - 45, 1e-9); // −0.9930; the peak is beside it
    EXPECT_NEAR(error(45, 15, 0), 45 - toDegrees(std::atan(std::cos(toRadians(15)))), 1e-9);
    EXPECT_NEAR(error(30, 10, 20), -3.8677, 6e-5);
    EXPECT_NEAR(error(300, -5, 30), 4.3722, 6e-5);
    EXPECT_NEAR(toDegrees(gimbalError_rad(MagneticHeading::fromDegrees(75), {toRadians(15), 0}, toRadians(30))), 0.99297, 6e-6);
}

TEST(DirectionalGyro, apparentDrift)
{
    const double knots500 = 500 * 1852 / 3600.0;
    const auto perHour = [](double rate) { return toDegrees(rate) * 3600; };
    for (const auto& [latitude, earth, meridians] : {std::tuple{30.0, 7.521, 4.808}, {52.0, 11.853, 10.659}, {70.0, 14.134, 22.880}}) {
        EXPECT_NEAR(perHour(apparentDrift_rad_s(toRadians(latitude), 0)), -earth, 6e-4);
        EXPECT_NEAR(perHour(apparentDrift_rad_s(toRadians(latitude), knots500)), -earth - meridians, 1.2e-3);
    }
    EXPECT_NEAR(perHour(kEarthRate_rad_s), 15.0411, 6e-5);
}

TEST(DirectionalGyro, slaving)
{
    EXPECT_NEAR(toDegrees(slavingStandoff_rad(147.13, toRadians(0.5) / 3600)), 0.0204, 5e-5);
    EXPECT_NEAR(toDegrees(slavingStandoff_rad(147.13, apparentDrift_rad_s(toRadians(52), 0))), -0.484, 5e-4);
    EXPECT_NEAR(slavingGain(147.13, toRadians(3)), 0.1287, 5e-5);
    EXPECT_NEAR(slavingGain(147.13, 2 * toRadians(3)), 0.0648, 5e-5);
}

} // namespace
} // namespace lubberline
