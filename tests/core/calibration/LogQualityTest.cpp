#include "core/calibration/LogQuality.h"
#include "core/calibration/Ellipsoid.h"

#include <gmock/gmock.h>

namespace lubberline::test {
namespace {

using testing::HasSubstr;

/// A sensor that turns slowly, 100 a second, with a little noise of whole figures.
SensorLog turning(int samples)
{
    SensorLog log;
    for (int i = 0; i < samples; ++i) {
        const double turn = 0.002 * i, noise = (i * 7919) % 13 - 6;
        log.time_s.push_back(0.01 * i);
        log.field[0].push_back(std::round(30000 * std::cos(turn)) + noise);
        log.field[1].push_back(std::round(30000 * std::sin(turn)) + (i * 9) % 11 - 5);
        log.field[2].push_back(std::round(20000 * std::cos(3 * turn)) + (i * 8) % 17 - 8);
    }
    return log;
}

std::string said(const LogQuality& quality) { return together(quality.remarks).english(); }

TEST(LogQuality, aGoodLogHasNoFaults)
{
    const auto quality = qualityOf(turning(4000));
    EXPECT_EQ(quality.of(SampleFault::None), 4000);
    EXPECT_NEAR(*quality.rate_hz, 100, 1e-6);
    EXPECT_EQ(said(quality), "");
}

TEST(LogQuality, gapsAreMeasured)
{
    SensorLog log = turning(1000);
    for (std::size_t row = 500; row < log.size(); ++row)
        log.time_s[row] += 3.0;
    const auto quality = qualityOf(log);
    ASSERT_EQ(quality.gaps.size(), 1u);
    EXPECT_EQ(quality.gaps[0].before, 500u);
    EXPECT_NEAR(quality.gaps[0].length_s, 3.01, 1e-9);
    EXPECT_THAT(said(quality), HasSubstr("3.01 s"));
}

TEST(LogQuality, spikesAreFoundAndNothingElse)
{
    SensorLog log = turning(2000);
    log.field[1][700] += 5000;
    log.field[2][1300] -= 800;
    const auto quality = qualityOf(log);
    EXPECT_EQ(quality.of(SampleFault::Spike), 2);
    EXPECT_EQ(quality.faults[700], SampleFault::Spike);
    EXPECT_EQ(quality.faults[1300], SampleFault::Spike);
}

TEST(LogQuality, aStuckAxisIsNamed)
{
    SensorLog log = turning(2000);
    for (std::size_t row = 1000; row < 1200; ++row)
        log.field[1][row] = log.field[1][1000];
    const auto quality = qualityOf(log);
    EXPECT_EQ(quality.of(SampleFault::Stuck), 200);
    EXPECT_THAT(said(quality), HasSubstr("axis y is stuck"));
}

TEST(LogQuality, anAxisThatDiedAtItsLargestFigureIsStuckAndNotCutOff)
{
    SensorLog log = turning(2000);
    for (std::size_t row = 700; row < log.size(); ++row)
        log.field[0][row] = 30010;
    const auto quality = qualityOf(log);
    EXPECT_EQ(quality.of(SampleFault::Clipped), 0);
    EXPECT_EQ(quality.of(SampleFault::Stuck), 1300);
    EXPECT_THAT(said(quality), HasSubstr("axis x is stuck"));
}

TEST(LogQuality, timeThatStandsIsTold)
{
    SensorLog log = turning(200);
    for (double& time : log.time_s)
        time = 7.5;
    const auto quality = qualityOf(log);
    EXPECT_FALSE(quality.rate_hz);
    EXPECT_THAT(said(quality), HasSubstr("time stands at 7.5 s"));
}

TEST(LogQuality, whyFewSamplesCanBeUsed)
{
    SensorLog log = turning(2000);
    EXPECT_TRUE(whyFewUsable(log, qualityOf(log)).empty());
    for (auto& value : log.field[2])
        value = 1234.5;
    const std::string stuck = whyFewUsable(log, qualityOf(log)).english();
    EXPECT_THAT(stuck, HasSubstr("axis z is stuck in 2000 of 2000 samples"));
    const auto result = fitEllipsoid(log, EllipsoidShape::General, {});
    ASSERT_FALSE(result.reasons.empty());
    EXPECT_EQ(result.reasons.front().english(), stuck); // and not only that there are no usable samples
    log = turning(2000);
    for (std::size_t row = 0; row < 1500; ++row)
        log.field[0][row] = kNoValue;
    EXPECT_THAT(whyFewUsable(log, qualityOf(log)).english(), HasSubstr("1500 of 2000 samples have no whole field"));
}

TEST(LogQuality, clippingIsNamed)
{
    SensorLog log = turning(4000);
    for (auto& value : log.field[0])
        value = std::min(value, 28000.0);
    const auto quality = qualityOf(log);
    EXPECT_GT(quality.of(SampleFault::Clipped), 300);
    EXPECT_THAT(said(quality), HasSubstr("axis x is cut off at 28000.0 nT"));
}

TEST(LogQuality, repeatsAreTold)
{
    SensorLog log = turning(2000);
    for (std::size_t row = 1; row < log.size(); row += 2)
        for (auto& axis : log.field)
            axis[row] = axis[row - 1];
    const auto quality = qualityOf(log);
    EXPECT_EQ(quality.of(SampleFault::Repeat), 1000);
    EXPECT_THAT(said(quality), HasSubstr("read faster than it measures"));
}

TEST(LogQuality, missingRows)
{
    SensorLog log = turning(200);
    log.field[2][50] = kNoValue;
    EXPECT_EQ(qualityOf(log).faults[50], SampleFault::Missing);
}

TEST(LogQuality, aPartOfALog)
{
    const SensorLog part = partOf(turning(1000), 2.0, 2.99);
    EXPECT_EQ(part.size(), 100u);
    EXPECT_DOUBLE_EQ(part.time_s.front(), 2.0);
}

} // namespace
} // namespace lubberline::test
