#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/swing/Analysis.h"
#include "core/swing/ReadingError.h"

namespace lubberline {
namespace {

/// The check swing of worksheet example Q1: whole degrees that lie on a curve with D and E alone within 0.03°.
Analysis worksheet()
{
    std::vector<Observation> readings;
    for (const auto& [magnetic, compass] :
        {std::pair{317, 316}, {0, 358}, {47, 42}, {93, 89}, {135, 134}, {179, 177}, {225, 220}, {273, 269}})
        readings.push_back({MagneticHeading::fromDegrees(magnetic), CompassHeading::fromDegrees(compass)});
    return analyse(readings).value();
}

TEST(ReadingError, isThatOfAUniformDivision)
{
    EXPECT_NEAR(toDegrees(readingError_rad(1)), 1 / std::sqrt(12.0), 1e-12);
    EXPECT_NEAR(toDegrees(readingError_rad(3, 4)), 5 / std::sqrt(12.0), 1e-12);
    EXPECT_EQ(readingError_rad(0), 0.0);
}

/// On eight even headings A has the variance σ²/8, B…E σ²/4: with whole degrees 0.289/√8 = 0.102° and 0.144°.
TEST(ReadingError, aFitIsNoSurerThanItsReadings)
{
    Analysis analysis = worksheet();
    const double before = *analysis.approximate.standardError[0], sigma = *analysis.approximate.sigma_rad;
    EXPECT_LT(toDegrees(before), 0.02);
    widenTo(analysis.approximate, readingError_rad(1));
    EXPECT_NEAR(toDegrees(*analysis.approximate.standardError[0]), 1 / std::sqrt(12.0 * 8), 0.003);
    EXPECT_NEAR(toDegrees(*analysis.approximate.standardError[1]), 1 / std::sqrt(12.0 * 4), 0.006);
    EXPECT_NEAR(std::sqrt(analysis.approximate.covariance(0, 0)), *analysis.approximate.standardError[0], 1e-12);
    EXPECT_EQ(*analysis.approximate.sigma_rad, sigma); // the scatter is what it is
    EXPECT_EQ(analysis.readings[0].studentised, worksheet().readings[0].studentised);
    EXPECT_GT(*bandHalfWidth_rad(analysis.approximate, CompassHeading::fromDegrees(10)),
        *bandHalfWidth_rad(worksheet().approximate, CompassHeading::fromDegrees(10)));
}

TEST(ReadingError, aLargerScatterStands)
{
    Analysis analysis = worksheet();
    const Analysis before = analysis;
    widenTo(analysis.approximate, *before.approximate.sigma_rad * 0.5);
    EXPECT_EQ(analysis.approximate.covariance, before.approximate.covariance);
    EXPECT_EQ(analysis.approximate.standardError, before.approximate.standardError);
}

/// Three degrees of freedom: Student's 97.5 % point is 3.182 (any table). Where the scatter is below the reading error the error is known,
/// not estimated, and the interval is the normal 1.960 of it, as long as that is the longer one.
TEST(ReadingError, anIntervalIsStudentsAndNeverShorterThanTheReadingLeaves)
{
    Analysis analysis = worksheet();
    const double byScatter = *analysis.approximate.interval95(Coefficient::A);
    EXPECT_NEAR(byScatter / *analysis.approximate.standardError[0], 3.182446, 1e-5);
    widenTo(analysis.approximate, readingError_rad(1));
    EXPECT_NEAR(*analysis.approximate.interval95(Coefficient::A) / *analysis.approximate.standardError[0], 1.959964, 1e-6);
    EXPECT_GT(*analysis.approximate.interval95(Coefficient::A), byScatter);
}

/// Half a degree of the datum is in A whatever the readings say, and in no other coefficient; the band of the curve has it everywhere.
TEST(ReadingError, whatAllReadingsShareIsInNoScatter)
{
    const Analysis before = worksheet();
    std::vector<Observation> readings;
    for (const auto& one : before.readings)
        readings.push_back({one.magnetic, one.compass});
    AnalysisOptions options;
    options.shared.of_deg = {0.5, 0, 0.25, 0, 0};
    const Analysis after = analyse(readings, options).value();
    const auto widened = [&](std::size_t i, double by_deg) { return std::hypot(toDegrees(*before.approximate.standardError[i]), by_deg); };
    EXPECT_NEAR(toDegrees(*after.approximate.standardError[0]), widened(0, 0.5), 1e-12);
    EXPECT_NEAR(toDegrees(*after.approximate.standardError[2]), widened(2, 0.25), 1e-12);
    EXPECT_EQ(after.approximate.standardError[1], before.approximate.standardError[1]);
    EXPECT_NEAR(std::sqrt(after.exact.covariance(0, 0)), *after.exact.standardError[0], 1e-12);
    EXPECT_EQ(after.approximate.value, before.approximate.value);
    // What is stated is not multiplied by Student's factor of the few readings: 3.182 of the scatter's, 1.960 of the datum's half degree.
    EXPECT_NEAR(toDegrees(*after.approximate.interval95(Coefficient::A)),
        std::hypot(3.182446 * toDegrees(*before.approximate.standardError[0]), 1.959964 * 0.5), 1e-5);
    EXPECT_EQ(after.approximate.interval95(Coefficient::B), before.approximate.interval95(Coefficient::B));
    const auto band = [](const Analysis& of, double heading) {
        return toDegrees(*bandHalfWidth_rad(of.approximate, CompassHeading::fromDegrees(heading)));
    };
    EXPECT_NEAR(band(after, 90), std::hypot(band(before, 90), 1.959964 * 0.5), 1e-5);
    EXPECT_NEAR(band(after, 180), std::hypot(band(before, 180), 1.959964 * std::hypot(0.5, 0.25)), 1e-5);
    const auto told = inEnglish(after.warnings);
    EXPECT_TRUE(std::any_of(told.begin(), told.end(), [](const auto& one) { return one.find("A 0.50°, C 0.25°") != std::string::npos; }));
}

} // namespace
} // namespace lubberline
