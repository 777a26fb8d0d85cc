// What the headings cannot tell is said and left empty; what is read wrong is marked, never dropped.

#include <gmock/gmock.h>

#include "core/deviation/Correction.h"
#include "core/swing/Analysis.h"
#include "core/swing/Card.h"
#include "core/swing/Removal.h"

namespace lubberline::test {

namespace {

Observation at(double magnetic_deg, double deviation_deg)
{
    const auto magnetic = MagneticHeading::fromDegrees(magnetic_deg);
    return {magnetic, toCompass(magnetic, Deviation::fromDegrees(deviation_deg))};
}

std::vector<Observation> around(int points, double wrongAt = -1, double wrongBy = 0)
{
    std::vector<Observation> readings;
    for (int i = 0; i < points; ++i) {
        const double psi = 360.0 * i / points;
        // Read to whole degrees, as a card is.
        const double delta = std::round(1 + 4 * std::sin(toRadians(psi)) - 2 * std::cos(toRadians(psi)) + std::sin(toRadians(2 * psi)));
        readings.push_back(at(psi, delta + (psi == wrongAt ? wrongBy : 0)));
    }
    return readings;
}

} // namespace

TEST(Knowledge, threeHeadingsTellAandBandC)
{
    const auto three = *analyse(around(3));
    EXPECT_EQ(three.approximate.parameters, 3);
    EXPECT_FALSE(three.approximate.of(Coefficient::D));
    EXPECT_FALSE(three.exact.of(Coefficient::E));
    EXPECT_TRUE(three.approximate.of(Coefficient::C));
    EXPECT_FALSE(three.warnings.empty());
    EXPECT_FALSE(three.approximate.standardError[0]); // no degrees of freedom and no reading error: nothing is known of it
    EXPECT_FALSE(bandHalfWidth_rad(three.approximate, {}));
}

TEST(Knowledge, fourCardinalsTellAllButD)
{
    const auto cardinals = *analyse(around(4), {.readingError_rad = toRadians(0.3)});
    EXPECT_EQ(cardinals.approximate.parameters, 4);
    EXPECT_FALSE(cardinals.approximate.of(Coefficient::D));
    EXPECT_FALSE(cardinals.exact.of(Coefficient::D));
    EXPECT_NEAR(toDegrees(*cardinals.approximate.of(Coefficient::A)), 1, 0.1);
    EXPECT_NEAR(toDegrees(*cardinals.approximate.of(Coefficient::B)), 4, 0.2);
    EXPECT_NEAR(toDegrees(*cardinals.approximate.of(Coefficient::C)), -2, 0.2);
    // A is the mean of four readings of 0.3°; no scatter was seen, so that there is no interval.
    EXPECT_NEAR(toDegrees(*cardinals.approximate.standardError[0]), 0.15, 0.01);
    EXPECT_FALSE(cardinals.approximate.interval95(Coefficient::A));
    EXPECT_THAT(inEnglish(cardinals.warnings), testing::Contains(testing::HasSubstr("D cannot be told: on the cardinal")));
}

/// Evans, Elementary Manual for the Deviation of the Compass: NE +24°10', SE +6°, SW −10°30', NW −19°30' (compass headings); printed
/// B +21°16'; A, C and D follow from the same four.
TEST(Knowledge, fourIntercardinalsTellAllButE)
{
    std::vector<Observation> readings;
    for (const auto& [compass, deviation] : {std::pair{45.0, 24 + 10 / 60.0}, {135.0, 6.0}, {225.0, -10.5}, {315.0, -19.5}})
        readings.push_back({MagneticHeading::fromDegrees(compass + deviation), CompassHeading::fromDegrees(compass)});
    const auto analysis = *analyse(readings);
    EXPECT_EQ(analysis.approximate.parameters, 4);
    EXPECT_FALSE(analysis.approximate.of(Coefficient::E));
    EXPECT_NEAR(toDegrees(*analysis.approximate.of(Coefficient::A)), 1 / 24.0, 1e-9);
    EXPECT_NEAR(toDegrees(*analysis.approximate.of(Coefficient::B)), 21 + 16 / 60.0, 0.01);
    EXPECT_NEAR(toDegrees(*analysis.approximate.of(Coefficient::C)), 3 + 14 / 60.0, 0.01);
    EXPECT_NEAR(toDegrees(*analysis.approximate.of(Coefficient::D)), 6 + 47.5 / 60.0, 0.01);
    EXPECT_THAT(inEnglish(analysis.warnings), testing::Contains(testing::HasSubstr("E cannot be told: on the intercardinal")));
}

TEST(Knowledge, whyAHeadingIsMissingIsTheTrueReason)
{
    std::vector<Observation> arc;
    for (int i = 0; i < 8; ++i)
        arc.push_back(at(20.0 * i, 2 + 0.1 * (i % 2)));
    const auto analysis = *analyse(arc);
    EXPECT_FALSE(analysis.approximate.of(Coefficient::D));
    EXPECT_THAT(inEnglish(analysis.warnings), testing::Contains(testing::HasSubstr("the headings stand on one side")));
    EXPECT_THAT(inEnglish(analysis.warnings), testing::Not(testing::Contains(testing::HasSubstr("need five"))));
}

/// Set on the cardinals by the datum, a compass that deviates reads beside them: the approximate formula tells what the exact one does.
TEST(Knowledge, cardinalsOfTheDatumTellEWhereTheCompassReadsBesideThem)
{
    std::vector<Observation> cardinals;
    for (const auto& [magnetic, deviation] : {std::pair{0.0, 5.0}, {90.0, -5.0}, {180.0, -3.0}, {270.0, 7.0}})
        cardinals.push_back(at(magnetic, deviation));
    const auto analysis = *analyse(cardinals);
    for (const SmithFitReport* fit :
        {static_cast<const SmithFitReport*>(&analysis.approximate), static_cast<const SmithFitReport*>(&analysis.exact)}) {
        EXPECT_FALSE(fit->of(Coefficient::D));
        EXPECT_TRUE(fit->of(Coefficient::E));
    }
}

TEST(Knowledge, readingsOnTwoOppositeHeadingsStandOnNoSide)
{
    std::vector<Observation> line;
    for (const double heading : {0.0, 180.0, 1.0, 181.0, 359.0, 179.0})
        line.push_back(at(heading, 2));
    EXPECT_THAT(inEnglish(analyse(line)->warnings), testing::Contains(testing::HasSubstr("there are readings on 2 headings")));
}

TEST(Knowledge, headingsOnOneSideTellLessOrNothing)
{
    std::vector<Observation> quarter, narrow;
    for (int i = 0; i < 8; ++i) {
        quarter.push_back(at(90.0 * i / 7, 2));
        narrow.push_back(at(40.0 * i / 7, 2));
    }
    EXPECT_EQ(analyse(quarter)->approximate.parameters, 3);
    const auto nothing = *analyse(narrow);
    EXPECT_EQ(nothing.approximate.parameters, 0);
    for (const auto& reading : nothing.readings) {
        EXPECT_FALSE(reading.residualApproximate_rad);
        EXPECT_FALSE(reading.suspect);
    }
    EXPECT_THAT(inEnglish(nothing.warnings), testing::Contains(testing::HasSubstr("no reading between")));
    EXPECT_EQ(makeCard(nothing, {}).error().code, ErrorCode::Numeric);
    EXPECT_EQ(removeComponents(nothing, CoefficientSet{1}).error().code, ErrorCode::Numeric);
}

TEST(Knowledge, tooFewReadingsAreAnErrorWithNumbers)
{
    const std::vector<Observation> two{at(0, 1), at(90, 2)};
    EXPECT_THAT(analyse(two).error().message.english(), testing::AllOf(testing::HasSubstr("2"), testing::HasSubstr("3")));
    const std::vector<Observation> same(5, at(45, 1));
    EXPECT_EQ(analyse(same).error().code, ErrorCode::InvalidInput);
    EXPECT_FALSE(analyse({}));
}

TEST(Knowledge, northIsOneHeading)
{
    auto readings = around(8);
    const auto first = *analyse(readings);
    readings[0].magnetic = MagneticHeading::fromDegrees(360);
    EXPECT_EQ(analyse(readings)->approximate.value, first.approximate.value);
    EXPECT_EQ(deviationOf(MagneticHeading::fromDegrees(359), CompassHeading::fromDegrees(3)).degrees(), -4.0); // worksheet Q1
}

TEST(Suspicion, fallsOnTheMisreadFigureOnly)
{
    for (const int points : {12, 24}) {
        const auto analysis = *analyse(around(points, 90, 10));
        int suspects = 0;
        for (const auto& reading : analysis.readings) {
            suspects += reading.suspect;
            EXPECT_TRUE(std::isfinite(*reading.studentised));
        }
        EXPECT_EQ(suspects, 1) << points;
        EXPECT_TRUE(analysis.readings[static_cast<std::size_t>(points / 4)].suspect);
        EXPECT_EQ(analysis.readings.size(), static_cast<std::size_t>(points)); // nothing was dropped
    }
    for (const int points : {8, 12, 24, 32}) {
        const auto analysis = *analyse(around(points));
        for (const auto& reading : analysis.readings)
            EXPECT_FALSE(reading.suspect);
    }
}

TEST(Knowledge, aCardSteersForBackThroughTheCompass)
{
    const auto analysis = *analyse(around(24));
    for (const int step : {30, 45}) {
        const auto card = makeCard(analysis, {step, CardSource::Fit, {}});
        ASSERT_TRUE(card);
        EXPECT_EQ(card->rows.size(), static_cast<std::size_t>(360 / step));
        for (const auto& row : card->rows) // who steers the card's figure flies FOR
            EXPECT_NEAR(wrap180(magneticHeadingFor(analysis.exact.smith(), row.steer)->degrees() - row.magnetic.degrees()), 0, 1e-9);
    }
    EXPECT_EQ(makeCard(analysis, {40, CardSource::Fit, {}}).error().code, ErrorCode::InvalidInput);
    CardRow north;
    north.steer = CompassHeading::fromDegrees(359.5);
    EXPECT_EQ(north.steerRounded_deg(), 0);
}

TEST(Removal, ofAllThatWasPutInLeavesTheRounding)
{
    std::vector<Observation> readings;
    const ApproximateSmith smith{0.02, 0.1, -0.05, 0.03, 0.01};
    for (int i = 0; i < 16; ++i) {
        const auto z = CompassHeading::fromDegrees(22.5 * i);
        readings.push_back({toMagnetic(z, deviationAt(smith, z)), z});
    }
    const auto analysis = *analyse(readings);
    EXPECT_LT(removeComponents(analysis, CoefficientSet{0b11111})->maxAbs_rad, 1e-12);
    const auto hard = *removeComponents(analysis, CoefficientSet{0b00110}); // B and C
    for (std::size_t i = 0; i < readings.size(); ++i)
        EXPECT_NEAR(hard.remaining_rad[i], deviationAt({0.02, 0, 0, 0.03, 0.01}, readings[i].compass).radians(), 1e-12);
}

TEST(Judgement, holdsReadingsAgainstTheProfile)
{
    const auto summary = analyse(around(8))->summary;
    EXPECT_EQ(judge(summary, {}).verdict, Verdict::NotKnown);
    LimitsProfile limits;
    EXPECT_EQ(judge(summary, limits).verdict, Verdict::NotKnown);
    limits.maxDeviation_deg = toDegrees(summary.maxAbsDeviation_rad); // exactly at the limit is within it
    EXPECT_EQ(judge(summary, limits).verdict, Verdict::InLimits);
    limits.maxSpread_deg = 5.0;
    EXPECT_EQ(judge(summary, limits).verdict, Verdict::OutOfLimits);
}

} // namespace lubberline::test
