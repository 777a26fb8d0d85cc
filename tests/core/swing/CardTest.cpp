// Correction cards: no card of a compass that folds, rows that nobody read are marked, and a card says how good it is.

#include <gmock/gmock.h>

#include "core/swing/CardRemarks.h"
#include "core/swing/SwingResult.h"

namespace lubberline::test {

namespace {

/// What a compass of these exact coefficients reads, at headings [deg], with what a reader was off by each time.
Swing swingOf(const ExactSmith& smith, const std::vector<double>& headings_deg, double off_deg = 0)
{
    Swing swing;
    for (std::size_t i = 0; i < headings_deg.size(); ++i) {
        Reading reading;
        reading.magnetic = MagneticHeading::fromDegrees(headings_deg[i]);
        const double compass_deg = toCompass(*reading.magnetic, deviationAt(smith, *reading.magnetic)).degrees();
        reading.compass = CompassHeading::fromDegrees(compass_deg + (i % 2 == 0 ? off_deg : -off_deg));
        swing.readings.push_back(reading);
    }
    return swing;
}

std::vector<double> every(double step_deg, double from_deg = 0, double to_deg = 359.99)
{
    std::vector<double> headings_deg;
    for (double heading_deg = from_deg; heading_deg <= to_deg; heading_deg += step_deg)
        headings_deg.push_back(heading_deg);
    return headings_deg;
}

SwingRecord recordOf(Swing swing)
{
    SwingRecord record;
    record.swing = std::move(swing);
    record.compass.resolution_deg = 0.01;
    return record;
}

Analysis resultOfSwing(const Swing& swing) { return resultOf(recordOf(swing)).value(); }

constexpr ExactSmith kUsual{0.01, 0.06, -0.04, 0.02, 0.01};

} // namespace

class FoldedCompass : public testing::TestWithParam<ExactSmith> {};

TEST_P(FoldedCompass, hasNoCardOfAnyKind)
{
    const auto result = resultOf(recordOf(swingOf(GetParam(), every(15))));
    if (!result) { // it runs backwards all round: there is no result, either
        EXPECT_EQ(result.error().code, ErrorCode::InvalidInput);
        return;
    }
    const Analysis& analysis = *result;
    for (const int step_deg : kCardSteps_deg)
        for (const auto source : {CardSource::Fit, CardSource::Readings})
            for (const auto by : {CardBy::Magnetic, CardBy::Compass}) {
                const auto card = makeCard(analysis, {step_deg, source, {}, by});
                ASSERT_FALSE(card) << step_deg;
                EXPECT_EQ(card.error().code, ErrorCode::Numeric);
                EXPECT_THAT(
                    card.error().message.english(), testing::ContainsRegex("from [0-9]{3}° to [0-9]{3}°|on [0-9]{3}° and [0-9]{3}° on"))
                    << step_deg;
            }
}

// Hard iron of 800 nT where H is 700; D of 1.2; D above 1 turns it the other way round; C and D that fold together.
INSTANTIATE_TEST_SUITE_P(Kinds, FoldedCompass,
    testing::Values(ExactSmith{0, 800.0 / 700.0, 0, 0, 0}, ExactSmith{0, 0, 0, 1.2, 0}, ExactSmith{0, 0, 0.7, 0.6, 0}));

TEST(CardRemarks, noBandIsPrintedAsZero)
{
    EXPECT_DOUBLE_EQ(bandInTenths_deg(toRadians(0.02)), 0.1);
    EXPECT_DOUBLE_EQ(bandInTenths_deg(toRadians(1.25)), 1.25);
    EXPECT_EQ(attitudeDecimals(-4.0), 0);
    EXPECT_EQ(attitudeDecimals(4.5), 1);
}

TEST(Card, foldsAreLookedForAfterWhatWasRemoved)
{
    const CoefficientSet onlyB(1u << indexOf(Coefficient::B)), onlyD(1u << indexOf(Coefficient::D));
    const Analysis hard = resultOfSwing(swingOf({0, 1.1, 0, 0.1, 0}, every(15)));
    EXPECT_FALSE(makeCard(hard, {30, CardSource::Fit, {}}));
    EXPECT_TRUE(makeCard(hard, {30, CardSource::Fit, onlyB})); // what is left turns as the aircraft does
    EXPECT_FALSE(makeCard(hard, {30, CardSource::Fit, onlyD}));
    // B and D that fold together only while one opposes the other.
    const Analysis held = resultOfSwing(swingOf({0, 0, 0, 0.9, 0}, every(15)));
    EXPECT_TRUE(makeCard(held, {45, CardSource::Fit, {}}));
}

TEST(Card, twoForWithOneSteerAreRefused)
{
    const auto row = [](double magnetic, double steer) {
        CardRow made;
        made.magnetic = MagneticHeading::fromDegrees(magnetic);
        made.steer = CompassHeading::fromDegrees(steer);
        return made;
    };
    std::vector<CardRow> rows{row(0, 350), row(90, 80), row(180, 190), row(270, 250)};
    EXPECT_TRUE(checkRising(rows, CardBy::Magnetic));
    rows[2] = row(180, 80.4); // 080 twice on paper
    EXPECT_THAT(checkRising(rows, CardBy::Magnetic).error().message.english(), testing::HasSubstr("080° for 090° and 080° for 180°"));
    rows[2] = row(180, 60);
    EXPECT_THAT(checkRising(rows, CardBy::Magnetic).error().message.english(), testing::HasSubstr("080° for 090° and 060° for 180°"));
}

TEST(Card, byCompassIsTheSameCurveTheOtherWayRound)
{
    const Analysis analysis = resultOfSwing(swingOf({0.02, 0.2, -0.15, 0.08, 0.03}, every(15), 0.2));
    for (const int step_deg : kCardSteps_deg) {
        const auto card = makeCard(analysis, {step_deg, CardSource::Fit, {}, CardBy::Compass});
        ASSERT_TRUE(card);
        ASSERT_EQ(card->rows.size(), static_cast<std::size_t>(360 / step_deg));
        for (std::size_t i = 0; i < card->rows.size(); ++i) {
            const auto& row = card->rows[i];
            EXPECT_EQ(row.steer.degrees(), static_cast<double>(step_deg) * static_cast<double>(i));
            const auto back = toCompass(row.magnetic, deviationAt(analysis.exact.smith(), row.magnetic));
            EXPECT_NEAR(wrap180(back.degrees() - row.steer.degrees()), 0, 1e-9);
        }
    }
}

TEST(Card, tellsWhatInterpolationMissesAndWhichCardWouldNot)
{
    const Analysis gentle = resultOfSwing(swingOf(kUsual, every(15), 0.1)),
                   steep = resultOfSwing(swingOf({0, 0, 0, 0.5, 0}, every(10), 0.1));
    EXPECT_LT(makeCard(gentle, {})->betweenRows_rad, toRadians(kBetweenRows_deg));
    EXPECT_EQ(makeCard(gentle, {})->finerStep_deg, 0);
    const auto coarse = makeCard(steep, {});
    EXPECT_GT(toDegrees(coarse->betweenRows_rad), 1.0);
    ASSERT_GT(coarse->finerStep_deg, 0);
    const auto finer = makeCard(steep, {coarse->finerStep_deg});
    EXPECT_NEAR(finer->betweenRows_rad, coarse->finerBetweenRows_rad, 1e-12);
    EXPECT_LT(finer->betweenRows_rad, coarse->betweenRows_rad);
    // The value between rows is the same that the error is of.
    const auto there = betweenRows(steep, *coarse, coarse->betweenRowsAt_deg);
    EXPECT_NEAR(std::abs(wrap180(there->interpolated_deg - *there->curve_deg)), toDegrees(coarse->betweenRows_rad), 1e-9);
    EXPECT_THAT(inEnglish(remarksOn(*coarse, {})), testing::Contains(testing::HasSubstr("interpolating between rows is off")));
}

TEST(Card, rowsThatNobodyReadAreMarkedWhateverTheConditionNumber)
{
    const Swing swing = swingOf(kUsual, every(10, 0, 210), 0.5); // nobody turned past 210
    const Analysis analysis = resultOfSwing(swing);
    const auto gaps = gapsOf(analysis);
    ASSERT_EQ(gaps.size(), 1u);
    EXPECT_NEAR(gaps[0].width_deg, 150, 12);
    // A half of a degree of scatter is several degrees in the middle of such an arc, and less at its ends.
    ASSERT_TRUE(gaps[0].widestBand_rad);
    EXPECT_GT(toDegrees(*gaps[0].widestBand_rad), 2.0);
    EXPECT_LT(*bandHalfWidth_rad(analysis.approximate, gaps[0].from), *gaps[0].widestBand_rad);
    EXPECT_THAT(inEnglish(analysis.warnings),
        testing::Contains(testing::AllOf(testing::HasSubstr("no reading between"), testing::HasSubstr("95 %"))));
    for (const auto source : {CardSource::Fit, CardSource::Readings}) {
        const auto card = makeCard(analysis, {30, source});
        ASSERT_TRUE(card);
        for (const auto& row : card->rows)
            EXPECT_EQ(row.unread, row.magnetic.degrees() > 211) << row.magnetic.degrees();
        EXPECT_GE(*card->rows[9].band_rad, *card->rows[3].band_rad * 2); // 270 against 090
    }
    // A row a degree or two off a reading at the end of an arc was read.
    EXPECT_FALSE(gaps[0].holds(MagneticHeading::fromDegrees(gaps[0].magneticFrom.degrees() + 2)));
    EXPECT_FALSE(gaps[0].holds(MagneticHeading::fromDegrees(gaps[0].magneticTo.degrees() - 2)));
    EXPECT_TRUE(gaps[0].holds(MagneticHeading::fromDegrees(gaps[0].magneticFrom.degrees() + 4)));
    EXPECT_TRUE(gapsOf(resultOfSwing(swingOf({}, every(60)))).empty()); // six evenly spaced headings leave no arc above 60°
    EXPECT_EQ(gapsOf(resultOfSwing(swingOf({}, {0, 60, 121, 180, 240, 300}))).size(), 1u);
    EXPECT_EQ(gapsOf(resultOfSwing(swingOf({}, {0, 90, 180, 270}))).size(), 4u);
}

TEST(Card, itsBandHoldsAsManyReadingsAsItSays)
{
    const Analysis analysis = resultOfSwing(swingOf(kUsual, every(30), 0.5));
    const auto fit = makeCard(analysis, {30}), readings = makeCard(analysis, {30, CardSource::Readings});
    for (std::size_t i = 0; i < fit->rows.size(); ++i) {
        const auto compass = toCompass(fit->rows[i].magnetic, deviationAt(analysis.exact.smith(), fit->rows[i].magnetic));
        EXPECT_NEAR(*fit->rows[i].band_rad, *bandHalfWidth_rad(analysis.approximate, compass), 1e-12);
        EXPECT_GT(*readings->rows[i].band_rad, *fit->rows[i].band_rad); // one reading is less sure than the curve of all
    }
    EXPECT_GE(*fit->widestBand_rad, *fit->rows[0].band_rad);
    EXPECT_NEAR(std::abs(readings->largestReading.deviation.degrees()), toDegrees(analysis.summary.maxAbsDeviation_rad), 1e-9);
}

TEST(Remarks, rowsOverTheLimitSuspectReadingsAndATiltedAircraft)
{
    Swing swing = swingOf({0, 0.2, 0, 0, 0}, every(30), 0.05);
    swing.readings[4].compass = CompassHeading::fromDegrees(swing.readings[4].compass->degrees() + 8);
    for (auto& reading : swing.readings)
        reading.pitch_deg = 11, reading.roll_deg = 0;
    SwingRecord record = recordOf(swing);
    record.limits = shippedLimitsProfiles().front();
    record.limits->maxDeviation_deg = 5;
    const auto card = makeCard(resultOf(record).value(), {});
    ASSERT_TRUE(card);
    EXPECT_TRUE(overLimit(card->rows[3], record.limits));  // 090: 11° where nobody misreads
    EXPECT_FALSE(overLimit(card->rows[0], record.limits)); // 000
    const auto remarks = inEnglish(remarksOn(*card, record));
    for (const char* words : {"OVER THE LIMIT of 5°", "SUSPECT reading used: on 120°", "NOT LEVEL: swung at pitch +11°"})
        EXPECT_THAT(remarks, testing::Contains(testing::HasSubstr(words)));
    EXPECT_FALSE(attitudeOf(record.swing).level);
    for (auto& reading : record.swing.readings)
        reading.pitch_deg.reset(), reading.roll_deg.reset();
    EXPECT_FALSE(attitudeOf(record.swing).level || attitudeOf(record.swing).tilted); // nobody says how it stood
    for (auto& reading : record.swing.readings)
        reading.pitch_deg = reading.roll_deg = 0.4;
    EXPECT_TRUE(attitudeOf(record.swing).level);
}

} // namespace lubberline::test
