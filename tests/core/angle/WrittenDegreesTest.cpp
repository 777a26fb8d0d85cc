// Degrees as they are written come back the same.

#include <gtest/gtest.h>

#include <random>

#include "core/angle/Angle.h"
#include "core/angle/WrittenDegrees.h"

namespace lubberline::test {

TEST(WrittenDegrees, shortFiguresStayShort)
{
    for (const double angle_deg : {0.0, 1.5, -2.5, 30.0, 0.1, 0.7, 12.345678, 90.0, -180.0, 1e-9})
        EXPECT_EQ(writtenDegrees(toRadians(angle_deg)), angle_deg);
}

TEST(WrittenDegrees, whatWasReadOnceIsWrittenTheSame)
{
    std::mt19937 random(32);
    std::uniform_real_distribution<double> unit(-kPi, kPi);
    for (int i = 0; i < 100'000; ++i) {
        const double angle_rad = unit(random), written_deg = writtenDegrees(angle_rad);
        EXPECT_EQ(writtenDegrees(toRadians(written_deg)), written_deg);
        EXPECT_NEAR(toRadians(written_deg), angle_rad, 1e-15);
    }
}

} // namespace lubberline::test
