// A compass that is stuck, mirrored, or out as a whole is named before any coefficient; what fits no five coefficients is said.

#include <gmock/gmock.h>

#include <cmath>
#include <functional>

#include "core/swing/Analysis.h"

namespace lubberline {
namespace {

using testing::Contains;
using testing::HasSubstr;

std::vector<Observation> around(int count, const std::function<double(double psi_deg)>& compass_deg)
{
    std::vector<Observation> readings;
    for (int i = 0; i < count; ++i) {
        const double psi = 360.0 * i / count;
        readings.push_back({MagneticHeading::fromDegrees(psi), CompassHeading::fromDegrees(compass_deg(psi))});
    }
    return readings;
}

TEST(CompassAtFault, aStuckCompassIsNamedWithItsFigure)
{
    for (const int count : {4, 8, 36}) {
        const auto stuck = analyse(around(count, [](double) { return 123.0; }));
        ASSERT_FALSE(stuck);
        EXPECT_THAT(stuck.error().message.english(), HasSubstr("reads 123 on all headings"));
    }
    EXPECT_FALSE(analyse(around(12, [](double psi) { return 359.5 + (psi > 180 ? 1.0 : 0.0); }))); // about north, to and fro by a degree
}

TEST(CompassAtFault, aMirroredCompassIsNamed)
{
    for (const double zero : {0.0, 90.0, 200.0}) {
        const auto mirrored = analyse(around(8, [zero](double psi) { return zero - psi + 3 * std::sin(toRadians(psi)); }));
        ASSERT_FALSE(mirrored);
        EXPECT_THAT(mirrored.error().message.english(), HasSubstr("backwards"));
    }
    // A deviation of half a right angle is none.
    EXPECT_TRUE(analyse(around(24, [](double psi) { return psi - 40 * std::sin(toRadians(psi)); })));
}

/// Index 170° E with B 15°: A is 170°, B what it is on a compass that is mounted right.
TEST(CompassAtFault, aLargeIndexIsOneLargeA)
{
    for (const double index : {170.0, 180.0, 90.0, -95.0}) {
        ApproximateSmith smith;
        smith.A_rad = toRadians(index);
        std::vector<Observation> readings;
        for (int i = 0; i < 24; ++i) { // on even compass headings, so that the approximate formula is exact
            const double z = 15.0 * i;
            readings.push_back({MagneticHeading::fromDegrees(z + index + 15 * std::sin(toRadians(z)) + 2 * std::cos(toRadians(2 * z))),
                CompassHeading::fromDegrees(z)});
        }
        const auto analysis = analyse(readings);
        ASSERT_TRUE(analysis);
        EXPECT_NEAR(wrap180(toDegrees(*analysis->approximate.value[0]) - index), 0, 1e-9);
        EXPECT_NEAR(toDegrees(*analysis->approximate.value[1]), 15, 1e-9);
        EXPECT_NEAR(toDegrees(*analysis->approximate.value[4]), 2, 1e-9);
        EXPECT_LT(toDegrees(analysis->exact.rms_rad), 1.0);
        EXPECT_NEAR(wrap180(toDegrees(analysis->exact.index_rad) - index), 0, 1.0);
        EXPECT_THAT(inEnglish(analysis->warnings).front(), HasSubstr("taken out as its index"));
        EXPECT_TRUE(analysis->slips.slips.empty());
        const auto there = readings[3];
        EXPECT_NEAR(
            wrap180(deviationAt(analysis->exact, there.magnetic).degrees() - deviationOf(there.magnetic, there.compass).degrees()), 0, 2.0);
    }
}

TEST(LackOfFit, aThirdHarmonicIsSaid)
{
    std::vector<Observation> readings;
    for (int i = 0; i < 24; ++i) {
        const double z = 15.0 * i, off = i % 3 == 0 ? 0.1 : -0.05;
        readings.push_back({MagneticHeading::fromDegrees(z + 3 * std::sin(toRadians(z)) + 1.5 * std::sin(toRadians(3 * z)) + off),
            CompassHeading::fromDegrees(z)});
    }
    EXPECT_THAT(inEnglish(analyse(readings)->warnings), Contains(HasSubstr("third harmonic of 1.5")));
}

TEST(LackOfFit, aBumpIsSaid)
{
    const auto bump = around(36, [](double psi) { return psi + 19 * std::exp(-std::pow((psi - 270) / 30, 2)); });
    EXPECT_THAT(inEnglish(analyse(bump)->warnings), Contains(HasSubstr("five coefficients do not describe")));
}

TEST(LackOfFit, readingsThatScatterAsTheyShouldAreLeftAlone)
{
    const auto rounded = around(12, [](double psi) { return std::round(psi - 4 * std::sin(toRadians(psi)) + 0.4 * std::sin(17 * psi)); });
    EXPECT_THAT(inEnglish(analyse(rounded)->warnings), Not(Contains(HasSubstr("five coefficients"))));
}

} // namespace
} // namespace lubberline
