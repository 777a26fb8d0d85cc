// A compass that is far out as a whole is the same compass as one that is mounted right, but for its index: published cases are in
// CompassAtFaultTest; here every figure is held against that of the compass mounted right.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/Number.h"
#include "core/deviation/Correction.h"
#include "core/deviation/Derivation.h"
#include "core/swing/Analysis.h"
#include "core/swing/Card.h"
#include "core/swing/CardRemarks.h"
#include "core/swing/Prediction.h"
#include "core/swing/Removal.h"
#include "core/swing/SwingPlaces.h"

namespace lubberline {
namespace {

constexpr ExactSmith kIron{0.003, 0.06, -0.11, 0.035, -0.02};

/// @param step_deg  of the magnetic headings. @param index_deg  by which it is out: it is in every deviation
std::vector<Observation> readOnTheRound(double index_deg, double step_deg)
{
    std::vector<Observation> readings;
    for (double magnetic_deg = 0; magnetic_deg < 360; magnetic_deg += step_deg) {
        const auto magnetic = MagneticHeading::fromDegrees(magnetic_deg);
        const double scatter_deg = 0.3 * std::sin(7 * toRadians(magnetic_deg) + 1);
        readings.push_back(
            {magnetic, CompassHeading::fromDegrees(magnetic_deg - deviationAt(kIron, magnetic).degrees() - index_deg + scatter_deg)});
    }
    return readings;
}

class FarOut : public testing::TestWithParam<double> {
protected:
    static Analysis analysed(double index_deg, double step_deg) { return *analyse(readOnTheRound(index_deg, step_deg), {}); }
};

TEST_P(FarOut, hasTheCoefficientsOfTheCompassMountedRight)
{
    for (const double step_deg : {15.0, 45.0}) {
        const Analysis right = analysed(0, step_deg), out = analysed(GetParam(), step_deg);
        EXPECT_EQ(right.approximate.index_rad, 0);
        EXPECT_NEAR(wrap180(toDegrees(out.approximate.index_rad) - GetParam()), 0, 1e-9);
        EXPECT_NEAR(wrap180(toDegrees(*out.approximate.of(Coefficient::A) - *right.approximate.of(Coefficient::A)) - GetParam()), 0, 1e-9);
        for (const Coefficient c : {Coefficient::B, Coefficient::C, Coefficient::D, Coefficient::E}) {
            EXPECT_NEAR(*out.approximate.of(c), *right.approximate.of(c), 1e-11) << letterOf(c) << GetParam();
            EXPECT_NEAR(*out.exact.of(c), *right.exact.of(c), 1e-11) << letterOf(c) << GetParam();
        }
        for (const Coefficient c : kCoefficients) {
            EXPECT_NEAR(*out.approximate.interval95(c), *right.approximate.interval95(c), 1e-11) << letterOf(c);
            EXPECT_NEAR(*out.exact.interval95(c), *right.exact.interval95(c), 1e-11) << letterOf(c);
        }
        for (std::size_t i = 0; i < right.readings.size(); ++i) {
            EXPECT_NEAR(out.approximate.residual_rad[i], right.approximate.residual_rad[i], 1e-11) << i;
            const double there_rad = *bandHalfWidth_rad(out.approximate, out.readings[i].compass);
            EXPECT_NEAR(there_rad, *bandHalfWidth_rad(right.approximate, right.readings[i].compass), 1e-11) << i;
        }
    }
}

/// Deviations of +179° and −179° are two degrees apart.
TEST_P(FarOut, hasItsSpreadAndItsSpectrum)
{
    const Analysis right = analysed(0, 15), out = analysed(GetParam(), 15);
    EXPECT_NEAR(out.summary.spread_rad(), right.summary.spread_rad(), 1e-11);
    ASSERT_EQ(out.harmonics.orders.size(), right.harmonics.orders.size());
    for (std::size_t order = 1; order < right.harmonics.orders.size(); ++order)
        EXPECT_NEAR(out.harmonics.orders[order].amplitude_rad(), right.harmonics.orders[order].amplitude_rad(), 1e-11) << order;
    CoefficientSet one;
    one.set(indexOf(Coefficient::B));
    const auto left = removeComponents(out, one), its = removeComponents(right, one);
    ASSERT_TRUE(left && its);
    for (std::size_t order = 1; order < its->harmonics.orders.size(); ++order)
        EXPECT_NEAR(left->harmonics.orders[order].amplitude_rad(), its->harmonics.orders[order].amplitude_rad(), 1e-11) << order;
}

TEST_P(FarOut, hasItsRulesStepsAndDerivations)
{
    const auto right = readOnTheRound(0, 45), out = readOnTheRound(GetParam(), 45);
    const auto mine = pointRules(out), its = pointRules(right);
    ASSERT_TRUE(mine && its);
    EXPECT_EQ(mine->points, 8);
    EXPECT_EQ(mine->argument, its->argument);
    EXPECT_EQ(mine->reading, its->reading);
    EXPECT_NEAR(mine->B_rad, its->B_rad, 1e-12);
    EXPECT_NEAR(mine->C_rad, its->C_rad, 1e-12);
    EXPECT_NEAR(*mine->D_rad, *its->D_rad, 1e-12);
    EXPECT_NEAR(mine->E_rad, its->E_rad, 1e-12);
    EXPECT_NEAR(wrap180(toDegrees(mine->A_rad - its->A_rad) - GetParam()), 0, 1e-9);
    for (const Coefficient c : {Coefficient::B, Coefficient::D})
        EXPECT_NEAR(derivationOf(out, *mine, c)->sum, derivationOf(right, *its, c)->sum, 1e-12) << letterOf(c);
    const auto steps = correctionSteps(out), itsSteps = correctionSteps(right);
    ASSERT_TRUE(steps && itsSteps);
    EXPECT_NEAR(steps->B_rad, itsSteps->B_rad, 1e-12);
    EXPECT_NEAR(steps->C_rad, itsSteps->C_rad, 1e-12);
}

TEST_P(FarOut, leavesWithoutBAndCWhatTheCompassMountedRightLeaves)
{
    CoefficientSet hard;
    hard.set(indexOf(Coefficient::A));
    hard.set(indexOf(Coefficient::B));
    hard.set(indexOf(Coefficient::C));
    const auto right = removeComponents(analysed(0, 15), hard), out = removeComponents(analysed(GetParam(), 15), hard);
    ASSERT_TRUE(right && out);
    for (std::size_t i = 0; i < right->remaining_rad.size(); ++i)
        EXPECT_NEAR(out->remaining_rad[i], right->remaining_rad[i], 1e-11) << i;
}

TEST_P(FarOut, isTheSameCurveByTheHeadingAsRead)
{
    const ApproximateSmith smith{0.1, 0.05, -0.08, 0.02, 0.03, toRadians(GetParam())}, asRead = byHeadingAsRead(smith);
    EXPECT_EQ(asRead.index_rad, 0);
    for (double heading = 0; heading < 360; heading += 30) {
        const auto compass = CompassHeading::fromDegrees(heading);
        EXPECT_NEAR(deviationAt(asRead, compass).degrees(), deviationAt(smith, compass).degrees(), 1e-11);
    }
}

TEST_P(FarOut, hasItsSlips)
{
    auto right = readOnTheRound(0, 30), out = readOnTheRound(GetParam(), 30);
    for (auto* readings : {&right, &out}) {
        for (auto& reading : *readings)
            reading.compass = CompassHeading::fromDegrees(std::round(reading.compass.degrees()));
        (*readings)[5].compass = CompassHeading::fromDegrees((*readings)[5].compass.degrees() + 10);
    }
    const auto its = analyse(right)->slips.slips, mine = analyse(out)->slips.slips;
    ASSERT_EQ(its.size(), 1u);
    ASSERT_EQ(mine.size(), 1u);
    EXPECT_EQ(mine[0].reading, 5u);
    EXPECT_EQ(mine[0].candidates[0].slip, Slip::TenDegrees);
    EXPECT_NEAR(wrap180(mine[0].candidates[0].meant_deg - (out[5].compass.degrees() - 10)), 0, 1e-9);
}

/// While it is swung: nothing is known of it before, then by its last swing.
TEST_P(FarOut, isExpectedToReadOnAsItReadBefore)
{
    const auto readings = readOnTheRound(GetParam(), 45);
    SlipContext context;
    context.earlier = std::span(readings).first(6);
    const auto judge = [&](double off_deg) {
        context.nominal_deg = readings[6].magnetic.degrees();
        return judgeReading({readings[6].magnetic, CompassHeading::fromDegrees(readings[6].compass.degrees() + off_deg)}, context);
    };
    for (const bool known : {false, true}) {
        if (known)
            context.expected = curveAfter(analysed(GetParam(), 45).approximate.smith());
        EXPECT_GT(judge(0).probabilityAsRead, 0.9) << known;
        EXPECT_NEAR(wrap180(judge(0).expected.degrees() - readings[6].compass.degrees()), 0, 2.0) << known;
        EXPECT_TRUE(judge(20).lookAgain()) << known;
    }
}

TEST_P(FarOut, isToldWhereFiveCoefficientsDoNotDescribeIt)
{
    auto readings = readOnTheRound(GetParam(), 15);
    for (auto& reading : readings)
        reading.compass = CompassHeading::fromDegrees(reading.compass.degrees() - 2 * std::sin(3 * reading.magnetic.radians()));
    EXPECT_THAT(inEnglish(analyse(readings)->warnings), testing::Contains(testing::HasSubstr("a third harmonic of")));
}

TEST_P(FarOut, saysWhatItsCoefficientsMean)
{
    const Analysis out = analysed(GetParam(), 15);
    const std::string sign = out.approximate.index_rad > 0 ? "+" : "−"; // of half a turn either
    EXPECT_THAT(inEnglish(out.warnings),
        testing::Contains(testing::HasSubstr("reads " + sign + " " + std::to_string(std::abs(int(GetParam()))) + "° (the index)")));
}

/// Further out than aircraft compasses are, and not far enough to be taken out: what B and C will be is said.
TEST_P(FarOut, isPredictedAndCardedWithItsIndex)
{
    const auto field = MeridianField::fromDip(18700, toRadians(67.5)), there = MeridianField::fromDip(30000, toRadians(20));
    const auto curveOf = [&](const Analysis& analysis) { return *predict(*swingAtPlace(analysis.exact, field, "a base"), there); };
    const Analysis right = analysed(0, 45), out = analysed(GetParam(), 45);
    const Prediction straight = curveOf(right), turned = curveOf(out);
    for (std::size_t i = 0; i < straight.points.size(); ++i) {
        const auto &one = straight.points[i], &other = turned.points[i];
        EXPECT_NEAR(wrap180(other.deviation->degrees() - one.deviation->degrees() - GetParam()), 0, 1e-6) << i;
        EXPECT_NEAR(*other.highest_rad - *other.lowest_rad, *one.highest_rad - *one.lowest_rad, 1e-9) << i;
        EXPECT_NEAR((*other.highest_rad + *other.lowest_rad) / 2, other.deviation->radians(), 1e-9) << i;
    }
    EXPECT_EQ(std::abs(out.summary.largestDeviation_rad),
        out.summary.maxAbsDeviation_rad); // the figure, its sign and its heading are one reading's
    const auto at = std::ranges::find(out.readings, out.summary.maxAbsDeviationAt, &AnalysedReading::magnetic);
    ASSERT_NE(at, out.readings.end());
    EXPECT_EQ(at->deviation.radians(), out.summary.largestDeviation_rad);
    EXPECT_GT(toDegrees(turned.maxAbs_rad), std::abs(GetParam()) - 5.0);
    EXPECT_THAT(inEnglish(turned.warnings), testing::Contains(testing::HasSubstr("index")));
    EXPECT_THAT(inEnglish(straight.warnings), testing::Not(testing::Contains(testing::HasSubstr("index"))));

    const SwingRecord record;
    const auto card = makeCard(out, {});
    EXPECT_THAT(inEnglish(remarksOn(*card, record)), testing::Contains(testing::HasSubstr("OUT AS A WHOLE")));
    EXPECT_THAT(inEnglish(remarksOn(*makeCard(right, {}), record)), testing::Not(testing::Contains(testing::HasSubstr("OUT AS A WHOLE"))));
}

TEST(OutOfPlace, saysWhatBAndCWillBeInTheMountSetRight)
{
    const Analysis right = *analyse(readOnTheRound(0, 15));
    const auto figure = [&](Coefficient c) { return signedFigureText(toDegrees(*right.approximate.of(c)), 1); };
    const std::string words = "B will be about " + figure(Coefficient::B) + "° and C " + figure(Coefficient::C) + "°";
    for (const double off_deg : {-41.0, 20.0, 30.0}) {
        const Analysis out = *analyse(readOnTheRound(off_deg, 15));
        EXPECT_EQ(out.approximate.index_rad, 0);
        EXPECT_THAT(inEnglish(out.warnings), testing::Contains(testing::HasSubstr(words))) << off_deg;
        if (std::abs(off_deg) > 20) { // and they are others now
            EXPECT_GT(std::abs(*out.approximate.of(Coefficient::B) - *right.approximate.of(Coefficient::B)), toRadians(2)) << off_deg;
        }
    }
    EXPECT_THAT(inEnglish(right.warnings), testing::Not(testing::Contains(testing::HasSubstr("in its mount"))));
}

INSTANTIATE_TEST_SUITE_P(By, FarOut, testing::Values(90.0, -90.0, 180.0, 137.0, -61.0));

} // namespace
} // namespace lubberline
