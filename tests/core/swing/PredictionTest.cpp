// What a compass will read at another base.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/sensor/PoissonSmith.h"
#include "core/sensor/SensorReading.h"
#include "core/swing/Prediction.h"

namespace lubberline {
namespace {

const MeridianField kWarsaw = MeridianField::fromDip(18700, toRadians(67.5));
const MeridianField kPerth = MeridianField::fromDip(23500, toRadians(-66));

SwingAtPlace swingOf(const SensorModel& model, const MeridianField& field)
{
    const auto smith = smithOf(model, field);
    EXPECT_TRUE(smith);
    return {smith->exact, {}, field, "a base"};
}

TEST(Prediction, fromAModelIsTheSimulatedSwingThere)
{
    SensorModel model;
    model.softIron << 0.04, 0.01, 0.03, 0.02, -0.01, -0.015, 0.02, 0, 0.05;
    model.hardIron_nT = {900, -600, 300};
    const auto prediction = predict(model, kPerth, 36);
    ASSERT_TRUE(prediction);
    ASSERT_EQ(prediction->points.size(), 36u);
    for (const auto& point : prediction->points) {
        EXPECT_NEAR(point.deviation->degrees(), readSensor(model, kPerth, {point.magnetic, 0, 0}).deviation->degrees(), 1e-9);
        EXPECT_NEAR(deviationAt(*prediction->exact, point.magnetic).degrees(), point.deviation->degrees(), 1e-9);
        EXPECT_EQ(*point.lowest_rad, *point.highest_rad);
    }
}

/// By hand: B = 0.1 with H 20,000 nT and dip 60° N, moved to H 40,000 nT and dip 30° S. All hard iron: 0.1 · 20,000/40,000 =
/// 0.05; all vertical soft iron: 0.1 · tan(−30°)/tan 60° = −1/30. On east δ = B nearly: between +2.86° and −1.91°.
TEST(Prediction, southOfTheMagneticEquatorSoftIronTurnsItsSign)
{
    SwingAtPlace swing;
    swing.exact.B = 0.1;
    swing.field = MeridianField::fromDip(20000, toRadians(60));
    const auto prediction = predict(swing, MeridianField::fromDip(40000, toRadians(-30)), 72);
    ASSERT_TRUE(prediction);
    const auto& east = prediction->points[18];
    EXPECT_DOUBLE_EQ(east.magnetic.degrees(), 90.0);
    EXPECT_NEAR(toDegrees(*east.highest_rad), toDegrees(std::atan(0.05)), 1e-9);
    EXPECT_NEAR(toDegrees(*east.lowest_rad), toDegrees(std::atan(-1.0 / 30)), 1e-9);
    EXPECT_NEAR(east.deviation->degrees(), toDegrees(std::atan((0.05 - 1.0 / 30) / 2)), 1e-9);
}

TEST(Prediction, theTruthLiesInTheBandOfOneSwing)
{
    std::mt19937_64 random(9);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> share(0, 1);
    for (int round = 0; round < 300; ++round) {
        // Iron whose B and C are shares of both kinds of the same sign: what the two extremes enclose; the rest at random.
        const double b = 0.1 * normal(random), c = 0.1 * normal(random), sb = share(random), sc = share(random);
        const double tanI = kWarsaw.down_nT / kWarsaw.horizontal_nT;
        SensorModel model;
        model.softIron << 0.03 * normal(random), 0.02 * normal(random), 0, 0.02 * normal(random), 0.03 * normal(random), 0, 0, 0, 0;
        model.softIron(0, 2) = sb * b / tanI;
        model.softIron(1, 2) = sc * c / tanI;
        model.hardIron_nT = {(1 - sb) * b * kWarsaw.horizontal_nT, (1 - sc) * c * kWarsaw.horizontal_nT, 0};
        const auto there = MeridianField::fromDip(25000 + 8000 * share(random), toRadians(-70 + 140 * share(random)));
        const auto prediction = predict(swingOf(model, kWarsaw), there, 36);
        ASSERT_TRUE(prediction);
        for (const auto& point : prediction->points) {
            const double truth = readSensor(model, there, {point.magnetic, 0, 0}).deviation->radians();
            const double off = std::remainder(truth - point.deviation->radians(), 2 * kPi);
            EXPECT_GE(point.deviation->radians() + off, *point.lowest_rad - 1e-9);
            EXPECT_LE(point.deviation->radians() + off, *point.highest_rad + 1e-9);
        }
    }
}

/// Hard iron that cancels vertical soft iron at home: no single swing can know, and the basis says so.
TEST(Prediction, ironThatOpposesItselfLiesBeyondTheBandAndThatIsSaid)
{
    SensorModel model;
    model.softIron(0, 2) = 0.04;
    model.hardIron_nT.x() = -0.04 * kWarsaw.down_nT + 100;
    const auto prediction = predict(swingOf(model, kWarsaw), kPerth, 8);
    ASSERT_TRUE(prediction);
    EXPECT_LT(readSensor(model, kPerth, {MagneticHeading::fromDegrees(90), 0, 0}).deviation->radians(), *prediction->points[2].lowest_rad);
    EXPECT_NE(prediction->basis.english().find("oppose each other"), std::string::npos);
}

/// The band of a swing where it was made: two standard errors of the curve by the derivative of [P 3], here held against
/// differences.
TEST(Prediction, theBandHoldsTwoStandardErrorsOfTheCurve)
{
    SwingAtPlace swing;
    swing.exact = {0.02, 0.3, -0.25, 0.1, -0.05}; // large: small angles do not do
    swing.field = kWarsaw;
    constexpr double kError = 1e-4;
    for (double ExactSmith::*const part : {&ExactSmith::A, &ExactSmith::B, &ExactSmith::C, &ExactSmith::D, &ExactSmith::E}) {
        swing.standardError = {};
        swing.standardError.*part = kError;
        const auto prediction = predict(swing, kWarsaw, 36);
        ExactSmith more = swing.exact, less = swing.exact;
        more.*part += kError;
        less.*part -= kError;
        for (const auto& point : prediction->points) {
            const double change = std::abs(deviationAt(more, point.magnetic).radians() - deviationAt(less, point.magnetic).radians());
            EXPECT_NEAR((*point.highest_rad - *point.lowest_rad) / 2, change, 1e-9);
        }
    }
}

TEST(Prediction, atHomeItIsTheSwingAgain)
{
    SensorModel model;
    model.hardIron_nT = {1500, 700, 0};
    auto swing = swingOf(model, kWarsaw);
    swing.standardError = {0.001, 0.002, 0.002, 0.001, 0.001};
    const auto prediction = predict(swing, kWarsaw, 8);
    ASSERT_TRUE(prediction);
    for (const auto& point : prediction->points) {
        EXPECT_NEAR(point.deviation->degrees(), deviationAt(swing.exact, point.magnetic).degrees(), 1e-12);
        EXPECT_GT(*point.highest_rad - *point.lowest_rad, 2 * 2 * 0.001); // its own errors remain
    }
}

TEST(Prediction, verdictsAndTheRule)
{
    LimitsProfile limits;
    limits.maxDeviation_deg = 10;
    SwingAtPlace swing;
    swing.exact.B = 0.1;
    swing.field = MeridianField::fromDip(20000, toRadians(60));
    const auto verdict
        = [&](double H, double dip_deg) { return judge(*predict(swing, MeridianField::fromDip(H, toRadians(dip_deg))), limits); };
    EXPECT_EQ(verdict(20000, 60), PredictedVerdict::InLimits);       // 5.7°
    EXPECT_EQ(verdict(20000, 75), PredictedVerdict::MayLeaveLimits); // soft iron: 0.1 · 3.73/1.73 = 12.2°; middle 9.0°
    EXPECT_EQ(verdict(8000, 75), PredictedVerdict::OutOfLimits);
    EXPECT_EQ(judge(*predict(swing, swing.field), {}), PredictedVerdict::NoLimit);
    const auto here = *predict(swing, swing.field);
    EXPECT_FALSE(swingAgainAfterMove(here, here, limits).needed);
    EXPECT_TRUE(swingAgainAfterMove(here, *predict(swing, MeridianField::fromDip(8000, toRadians(75))), limits).needed);
    const auto far = swingAgainAfterMove(here, *predict(swing, MeridianField::fromDip(38000, toRadians(-20))), {});
    EXPECT_TRUE(far.needed); // from +5.7° to −0.8° on east: no limit is set, but the card is wrong
    EXPECT_NE(far.reason.english().find("changes by up to"), std::string::npos);
}

TEST(Prediction, edges)
{
    SwingAtPlace swing;
    swing.exact.B = 0.1;
    swing.field = {30000, 0};
    const auto fromTheEquator = predict(swing, kWarsaw);
    ASSERT_TRUE(fromTheEquator);
    ASSERT_FALSE(fromTheEquator->warnings.empty());
    for (const auto& point : fromTheEquator->points)
        EXPECT_TRUE(std::isfinite(*point.lowest_rad) && std::isfinite(*point.highest_rad));
    swing.field = MeridianField::fromDip(30000, toRadians(2));
    EXPECT_FALSE(predict(swing, kWarsaw)->warnings.empty()); // vertical soft iron hardly showed
    EXPECT_FALSE(predict(swing, {1500, 56000}));             // blackout
    EXPECT_FALSE(predict(swing, {0, 56000}));
    EXPECT_TRUE(predict(swing, MeridianField::fromDip(5000, toRadians(84)))->warnings.size() >= 1); // caution
    swing.field = {0, 0};
    EXPECT_FALSE(predict(swing, kWarsaw));
    SensorModel cancels;
    cancels.hardIron_nT = {-kWarsaw.horizontal_nT, 0, 0}; // on north nothing is left
    const auto prediction = predict(cancels, kWarsaw, 8);
    ASSERT_TRUE(prediction);
    EXPECT_FALSE(prediction->points[0].deviation);
    EXPECT_EQ(judge(*prediction, LimitsProfile{{}, {}, {}, {}, {}, {}, 10.0, {}}), PredictedVerdict::OutOfLimits);
}

TEST(Prediction, fromTwoPlacesTheBandIsNarrow)
{
    SensorModel model;
    model.softIron(0, 2) = 0.03;
    model.softIron(1, 2) = -0.02;
    model.hardIron_nT = {1000, 500, 0};
    auto a = swingOf(model, kWarsaw), b = swingOf(model, MeridianField::fromDip(41000, toRadians(-15)));
    a.standardError = b.standardError = {0.002, 0.002, 0.002, 0.002, 0.002};
    const auto prediction = predict(*separateIron(std::vector{a, b}), kPerth, 36), one = predict(a, kPerth, 36);
    ASSERT_TRUE(prediction);
    double widest = 0, widestOfOne = 0;
    for (std::size_t i = 0; i < 36; ++i) {
        const auto& point = prediction->points[i];
        const double truth = readSensor(model, kPerth, {point.magnetic, 0, 0}).deviation->radians();
        EXPECT_NEAR(point.deviation->radians(), truth, 1e-9);
        widest = std::max(widest, *point.highest_rad - *point.lowest_rad);
        widestOfOne = std::max(widestOfOne, *one->points[i].highest_rad - *one->points[i].lowest_rad);
    }
    EXPECT_LT(widest, widestOfOne / 3);
}

} // namespace
} // namespace lubberline
