#include "core/swing/SwingResult.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/swing/Observations.h"

namespace lubberline {
namespace {

Swing swingReading(const std::vector<std::pair<double, double>>& pairs)
{
    Swing swing;
    for (const auto& [magnetic, compass] : pairs) {
        Reading reading;
        reading.magnetic = MagneticHeading::fromDegrees(magnetic);
        reading.compass = CompassHeading::fromDegrees(compass);
        swing.readings.push_back(reading);
    }
    return swing;
}

const std::vector<std::pair<double, double>> kWithoutDeviation{
    {0, 0}, {45, 45}, {90, 90}, {135, 135}, {180, 180}, {225, 225}, {270, 270}, {315, 315}};

TEST(SwingResult, noScatterAtAllIsNoCertainty)
{
    SwingRecord record;
    record.swing = swingReading(kWithoutDeviation);
    const auto result = resultOf(record);
    ASSERT_TRUE(result);
    // 1/√12 of a degree a reading; A is the mean of eight of them, B and C a half of the sum of eight sines squared.
    EXPECT_NEAR(toDegrees(*result->approximate.standardError[0]), std::sqrt(1.0 / 12 / 8), 1e-6);
    EXPECT_NEAR(toDegrees(*result->approximate.standardError[1]), std::sqrt(1.0 / 12 / 4), 1e-6);
    EXPECT_GT(*result->exact.standardError[0], 0);
}

/// As they are kept: the curve of a compass that is far out is told again from its coefficients alone, to the degree that its index is told to.
TEST(SwingResult, keptCoefficientsGiveTheCurveBack)
{
    for (const double out_deg : {0.0, -3.2, 44.0, 90.0, -137.0, 179.6}) {
        SwingRecord record;
        auto pairs = kWithoutDeviation;
        for (auto& [magnetic, compass] : pairs)
            compass = wrap360(magnetic - out_deg - 6.0 * std::sin(toRadians(magnetic)) - 2.0 * std::cos(toRadians(2.0 * magnetic)));
        record.swing = swingReading(pairs);
        const auto fit = fitApproximate(observationsOf(record.swing));
        ASSERT_TRUE(fit);
        std::array<std::optional<double>, kCoefficientCount> kept;
        for (std::size_t i = 0; i < kept.size(); ++i)
            kept[i] = toDegrees(*fit->value[i]);
        const auto told = smithOfKept(kept);
        ASSERT_TRUE(told);
        EXPECT_NEAR(toDegrees(told->index_rad), toDegrees(fit->index_rad), 2.0) << out_deg; // A of these eight is not their middle
        for (const auto& [magnetic, compass] : pairs) {
            const auto heading = CompassHeading::fromDegrees(compass);
            const double off_deg = deviationAt(*told, heading).degrees() - deviationAt(fit->smith(), heading).degrees();
            EXPECT_NEAR(wrap180(off_deg), 0.0, 0.5) << out_deg << ' ' << magnetic;
        }
        kept[3].reset();
        EXPECT_FALSE(smithOfKept(kept)) << out_deg;
    }
}

/// A card graduated in fives and read to its marks: 5°/√12 a reading, and no reading is blamed for the step of the card.
TEST(SwingResult, aCompassReadToItsMarksIsAsSureAsThose)
{
    SwingRecord record;
    record.swing = swingReading({{0, 5}, {45, 45}, {90, 85}, {135, 130}, {180, 175}, {225, 225}, {270, 275}, {315, 325}});
    const auto result = resultOf(record);
    ASSERT_TRUE(result);
    EXPECT_GE(toDegrees(*result->approximate.standardError[0]), 5.0 / std::sqrt(12.0 * 8) - 1e-9);
    EXPECT_TRUE(result->slips.slips.empty());
    const auto told = [](const Analysis& of) {
        const auto warnings = inEnglish(of.warnings);
        return std::any_of(
            warnings.begin(), warnings.end(), [](const auto& one) { return one.find("a multiple of 5°") != std::string::npos; });
    };
    EXPECT_TRUE(told(*result));
    record.swing.readings[2].compass = CompassHeading::fromDegrees(86); // one figure between the marks: it was read to degrees
    EXPECT_FALSE(told(resultOf(record).value()));
    // Turned until the compass stood on what was asked, one of them slipped: it was read as finely as it can be.
    record.swing = swingReading({{1, 0}, {44, 45}, {88.4, 90}, {134, 145}, {180, 180}, {226, 225}, {272, 270}, {316.5, 315}});
    EXPECT_FALSE(told(resultOf(record).value()));
}

/// A table pasted twice: a list of eight is as sure as eight readings, not as sixteen.
TEST(SwingResult, aListThatIsThereTwiceCountsOnce)
{
    const std::vector<std::pair<double, double>> once{
        {0, 2}, {45, 44}, {90, 86}, {135, 133}, {180, 178}, {225, 227}, {270, 275}, {315, 318}};
    auto twice = once;
    twice.insert(twice.end(), once.begin(), once.end());
    SwingRecord record;
    record.swing = swingReading(once);
    const Analysis one = resultOf(record).value();
    record.swing = swingReading(twice);
    const Analysis two = resultOf(record).value();
    for (const Coefficient c : kCoefficients) {
        EXPECT_NEAR(*two.approximate.interval95(c), *one.approximate.interval95(c), 1e-12);
        EXPECT_NEAR(*two.exact.interval95(c), *one.exact.interval95(c), 1e-12);
    }
    EXPECT_EQ(two.approximate.degreesOfFreedom, 3);
    const auto warnings = inEnglish(two.warnings);
    EXPECT_TRUE(
        std::any_of(warnings.begin(), warnings.end(), [](const auto& words) { return words.find("every reading is there 2 times") == 0; }));
    twice.back().second = 317; // a second round of its own
    record.swing = swingReading(twice);
    EXPECT_EQ(resultOf(record)->approximate.degreesOfFreedom, 11);
}

TEST(SwingResult, theDatumOfAGuidedSwingAddsItsDivision)
{
    SwingRecord record;
    record.swing = swingReading(kWithoutDeviation);
    SwingJob job;
    job.datum.resolution_deg = 1.0;
    const auto alone = resultOf(record), both = resultOf(record, &job);
    ASSERT_TRUE(alone && both);
    EXPECT_NEAR(*both->approximate.standardError[0] / *alone->approximate.standardError[0], std::sqrt(2.0), 1e-9);
}

TEST(SwingResult, whatScattersMoreStaysAsItIs)
{
    SwingRecord record;
    auto pairs = kWithoutDeviation;
    for (std::size_t i = 0; i < pairs.size(); ++i)
        pairs[i].second = wrap360(pairs[i].second + (i % 3 == 0 ? 2.0 : -1.0));
    record.swing = swingReading(pairs);
    record.compass.resolution_deg = 0.01;
    const auto fine = resultOf(record);
    record.compass.resolution_deg = 1.0;
    const auto whole = resultOf(record);
    ASSERT_TRUE(fine && whole);
    EXPECT_EQ(*fine->approximate.standardError[0], *whole->approximate.standardError[0]);
}

TEST(SwingResult, aFilesDivisionIsThatOfItsFigures)
{
    EXPECT_EQ(divisionOf_deg(swingReading({{0, 1}, {90.25, 93}})), 1.0); // of the compass, not of the datum
    EXPECT_EQ(divisionOf_deg(swingReading({{0, 1}, {90, 93.5}})), 0.5);
    EXPECT_EQ(divisionOf_deg(swingReading({{0, 359.9}, {90, 93.3}})), 0.1);
    EXPECT_EQ(divisionOf_deg(swingReading({{0, 1.0123456}, {90, 93.5}})), 0.1); // computed, or sent
    EXPECT_EQ(divisionOf_deg({}), 1.0);
}

TEST(SwingResult, whatIsKeptBesideASwingIsOfItsResult)
{
    Swing swing = swingReading({{0, 2}, {40, 45}, {90, 94}, {130, 131}, {180, 179}, {225, 220}, {270, 263}, {315, 312}});
    const auto readings = observationsOf(swing);
    const auto analysis = analyse(readings);
    const auto outline = outlineOf(readings);
    ASSERT_TRUE(analysis && outline);
    EXPECT_EQ(outline->approximate_rad, analysis->approximate.value);
    EXPECT_EQ(outline->summary.maxAbsDeviation_rad, analysis->summary.maxAbsDeviation_rad);
    EXPECT_EQ(outline->summary.spread_rad(), analysis->summary.spread_rad());
    swing.readings.resize(2);
    EXPECT_EQ(outlineOf(observationsOf(swing)).error().message, analyse(observationsOf(swing)).error().message);
}

TEST(SwingResult, anAnalysisThatIsNotWantedAnyMoreEnds)
{
    std::vector<Observation> log;
    for (int i = 0; i < 3000; ++i)
        log.push_back({MagneticHeading::fromDegrees(0.37 * i), CompassHeading::fromDegrees(0.37 * i + 3 * std::sin(0.1 * i))});
    int asked = 0;
    double last = 0;
    const auto whole = analyse(log, {}, [&](double fraction) {
        EXPECT_GE(fraction, last);
        last = fraction;
        ++asked;
        return true;
    });
    ASSERT_TRUE(whole);
    EXPECT_GT(asked, 20);
    for (const int until : {1, asked / 2, asked}) {
        int told = 0;
        const auto ended = analyse(log, {}, [&](double) { return ++told < until; });
        ASSERT_FALSE(ended);
        EXPECT_EQ(ended.error().code, ErrorCode::Cancelled);
    }
}

TEST(SwingResult, afterACompensationOnlyDAndEAreAsBefore)
{
    const ApproximateSmith last{toRadians(91), 0.12, -0.07, 0.03, -0.02, toRadians(90)};
    Swing swing;
    swing.stage = SwingStage::AsLeft;
    const auto after = expectedAfter(last, SwingKind::Check, SwingStage::AsLeft, swing);
    EXPECT_EQ(after.mean.B_rad, last.B_rad);
    for (const auto& compensated : {expectedAfter(last, SwingKind::Check, SwingStage::AsFound, swing),
             expectedAfter(last, SwingKind::Correction, SwingStage::AsLeft, swing)}) {
        EXPECT_EQ(compensated.mean.B_rad, 0.0);
        EXPECT_EQ(compensated.mean.index_rad, 0.0);
        EXPECT_EQ(compensated.standardDeviation.B_rad, anyCurve().standardDeviation.B_rad);
        EXPECT_EQ(compensated.mean.D_rad, last.D_rad);
        EXPECT_EQ(compensated.standardDeviation.D_rad, after.standardDeviation.D_rad);
    }
}

} // namespace
} // namespace lubberline
