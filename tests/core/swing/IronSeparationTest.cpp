// Hard iron told from vertical soft iron by simulated swings, and what is not told.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "core/deviation/SmithFit.h"
#include "core/sensor/PoissonSmith.h"
#include "core/sensor/SensorReading.h"
#include "core/swing/IronSeparation.h"
#include "core/swing/SwingPlaces.h"

namespace lubberline {
namespace {

const MeridianField kWarsaw = MeridianField::fromDip(18700, toRadians(67.5));
const MeridianField kSingapore = MeridianField::fromDip(41000, toRadians(-15));
const MeridianField kPerth = MeridianField::fromDip(23500, toRadians(-66));

SwingAtPlace exactSwing(const SensorModel& model, const MeridianField& field, const char* label)
{
    const auto smith = smithOf(model, field);
    EXPECT_TRUE(smith);
    return {smith->exact, {}, field, label};
}

SensorModel someIron()
{
    SensorModel model;
    model.softIron << 0.02, 0.01, 0.03, 0.02, -0.02, -0.015, 0, 0, 0;
    model.hardIron_nT = {900, -600, 0};
    return model;
}

TEST(IronSeparation, exactSwingsGiveTheIronBack)
{
    const auto model = someIron(); // a + e = 0: lambda is 1
    const std::vector swings{exactSwing(model, kWarsaw, "Warsaw"), exactSwing(model, kSingapore, "Singapore")};
    const auto separation = separateIron(swings);
    ASSERT_TRUE(separation);
    EXPECT_NEAR(separation->c.value, 0.03, 1e-12);
    EXPECT_NEAR(separation->f.value, -0.015, 1e-12);
    EXPECT_NEAR(separation->P_nT.value, 900, 1e-8);
    EXPECT_NEAR(separation->Q_nT.value, -600, 1e-8);
    EXPECT_NEAR(separation->A.value, 0.005, 1e-12); // (d − b)/2
    const auto again = smithOf(modelOf(*separation), kPerth);
    EXPECT_NEAR(again->exact.B, smithOf(model, kPerth)->exact.B, 1e-12); // a third place
}

/// How often what is told of simulated swings holds.
struct Honesty {
    int cases = 0, withinThree = 0, withinOne = 0, contradictions = 0;
    double shareOfThree() const { return static_cast<double>(withinThree) / cases; }
    double shareOfOne() const { return static_cast<double>(withinOne) / cases; }
    void count(const Estimate& estimate, double truth)
    {
        ++cases;
        withinThree += std::abs(estimate.value - truth) <= 3 * estimate.standardError;
        withinOne += std::abs(estimate.value - truth) <= estimate.standardError;
    }
};

SensorModel randomIron(std::mt19937_64& random)
{
    std::normal_distribution<double> normal;
    SensorModel model;
    model.softIron << 0.02 * normal(random), 0.01 * normal(random), 0.03 * normal(random), 0.01 * normal(random), 0.02 * normal(random),
        0.03 * normal(random), 0, 0, 0;
    model.hardIron_nT = {1000 * normal(random), 1000 * normal(random), 0};
    return model;
}

/// Swings read with 0.2° to 0.5° of noise, with the errors that their own fits state, against the iron that made them.
Honesty honestyOf(int headings, std::span<const MeridianField> places, int rounds)
{
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    Honesty honesty;
    for (int round = 0; round < rounds; ++round) {
        const SensorModel model = randomIron(random);
        const double noise_deg = 0.2 + 0.3 * (round % 4) / 3;
        std::vector<SwingAtPlace> swings;
        for (const auto& field : places) {
            std::vector<Observation> readings;
            for (int i = 0; i < headings; ++i) {
                const auto magnetic = MagneticHeading::fromDegrees(360.0 * i / headings);
                const auto reading = readSensor(model, field, {magnetic, 0, 0});
                readings.push_back({magnetic, CompassHeading::fromDegrees(reading.compass->degrees() + noise_deg * normal(random))});
            }
            swings.push_back(*swingAtPlace(*fitExact(readings), field, "a base"));
        }
        const auto separation = separateIron(swings);
        EXPECT_TRUE(separation);
        const double lambda = 1 + (model.softIron(0, 0) + model.softIron(1, 1)) / 2;
        honesty.count(separation->c, model.softIron(0, 2) / lambda);
        honesty.count(separation->f, model.softIron(1, 2) / lambda);
        honesty.count(separation->P_nT, model.hardIron_nT.x() / lambda);
        honesty.count(separation->Q_nT, model.hardIron_nT.y() / lambda);
        honesty.contradictions += !separation->warnings.empty();
    }
    return honesty;
}

/// A fit of eight readings has three degrees of freedom: its own errors are rough, and yet what is concluded must hold.
TEST(IronSeparation, standardErrorsAreHonest)
{
    const std::array places{kWarsaw, kSingapore};
    const Honesty eight = honestyOf(8, places, 2000);
    EXPECT_GE(eight.shareOfThree(), 0.95);
    EXPECT_NEAR(eight.shareOfOne(), 0.68, 0.04);
    const Honesty many = honestyOf(24, places, 500);
    EXPECT_GE(many.shareOfThree(), 0.98);
    EXPECT_NEAR(many.shareOfOne(), 0.68, 0.04);
    EXPECT_GE(honestyOf(6, places, 1000).shareOfThree(), 0.95); // one degree of freedom: wide, but true
}

TEST(IronSeparation, swingsThatAgreeAreSeldomSaidToContradict)
{
    const std::array places{kWarsaw, kSingapore, kPerth};
    const Honesty honesty = honestyOf(8, places, 1000);
    EXPECT_GE(honesty.shareOfThree(), 0.95);
    EXPECT_LT(honesty.contradictions, 50);
}

TEST(IronSeparation, errorsOfFewReadingsAreWidened)
{
    EXPECT_EQ(widening(0), 1.0);
    EXPECT_NEAR(widening(1), 12.706 / 3, 1e-3); // Student's table, 95 % two-sided
    EXPECT_NEAR(widening(3), 1.197, 1e-3);      // and 68.27 %
    EXPECT_NEAR(widening(1000), 1.0, 1e-3);
    auto swings = std::vector{exactSwing(someIron(), kWarsaw, "Warsaw"), exactSwing(someIron(), kSingapore, "Singapore")};
    for (auto& swing : swings)
        swing.standardError = {0.003, 0.003, 0.003, 0.003, 0.003};
    const auto known = separateIron(swings);
    for (auto& swing : swings)
        swing.degreesOfFreedom = 3;
    const auto few = separateIron(swings);
    EXPECT_NEAR(few->c.standardError / known->c.standardError, widening(3), 1e-12);
    EXPECT_NEAR(few->P_nT.standardError / known->P_nT.standardError, widening(3), 1e-12);
    EXPECT_DOUBLE_EQ(few->c.value, known->c.value);
}

TEST(IronSeparation, placesThatAreAlikeOrEqual)
{
    const auto model = someIron();
    const auto near = MeridianField::fromDip(18900, toRadians(67.2));
    const auto alike = separateIron(std::vector{exactSwing(model, kWarsaw, "Warsaw"), exactSwing(model, near, "Lodz")});
    ASSERT_TRUE(alike);
    EXPECT_GT(alike->conditionNumber, kAlikePlaces);
    ASSERT_FALSE(alike->warnings.empty());
    EXPECT_NE(alike->warnings[0].english().find("Warsaw, Lodz"), std::string::npos);
    const auto equal = separateIron(std::vector{exactSwing(model, kWarsaw, "Warsaw 2025"), exactSwing(model, kWarsaw, "Warsaw 2026")});
    ASSERT_FALSE(equal);
    EXPECT_EQ(equal.error().code, ErrorCode::Numeric);
    EXPECT_NE(equal.error().message.english().find("Warsaw 2025, Warsaw 2026"), std::string::npos);
    EXPECT_FALSE(separateIron(std::vector{exactSwing(model, kWarsaw, "Warsaw")}));
    const auto level = separateIron(std::vector{exactSwing(model, {30000, 0}, "Quito"), exactSwing(model, {38000, 0}, "Lagos")});
    ASSERT_FALSE(level);
    EXPECT_NE(level.error().message.english().find("Quito, Lagos"), std::string::npos);
    auto unknown = exactSwing(model, kSingapore, "nowhere");
    unknown.field = {0, 1000};
    EXPECT_FALSE(separateIron(std::vector{exactSwing(model, kWarsaw, "Warsaw"), unknown}));
}

/// A swing read ten thousand times as well as the other does not make their places alike.
TEST(IronSeparation, likenessIsOfThePlacesNotOfTheReadings)
{
    std::vector swings{exactSwing(someIron(), kWarsaw, "Warsaw"), exactSwing(someIron(), kSingapore, "Singapore")};
    swings[0].standardError = {0.01, 0.01, 0.01, 0.01, 0.01};
    swings[1].standardError = {1e-6, 1e-6, 1e-6, 1e-6, 1e-6};
    const auto separation = separateIron(swings);
    ASSERT_TRUE(separation);
    EXPECT_TRUE(separation->warnings.empty());
    EXPECT_LT(separation->conditionNumber, 10);
    EXPECT_NEAR(separation->P_nT.value, 900, 1e-6);
    std::swap(swings[0], swings[1]);
    EXPECT_NEAR(separateIron(swings)->P_nT.standardError, separation->P_nT.standardError, 1e-9);
}

/// Where no swing knows its errors, their scatter tells them; with two swings there is none, and that is said.
TEST(IronSeparation, scatterTellsTheErrorsThatNoSwingKnows)
{
    std::vector swings{exactSwing(someIron(), kWarsaw, "Warsaw"), exactSwing(someIron(), kSingapore, "Singapore")};
    const auto two = separateIron(swings);
    EXPECT_EQ(two->c.standardError, 0);
    ASSERT_EQ(two->warnings.size(), 1u);
    EXPECT_NE(two->warnings[0].english().find("no errors can be stated"), std::string::npos);
    swings.push_back(exactSwing(someIron(), kPerth, "Perth"));
    swings[2].exact.B += 0.01;
    const auto three = separateIron(swings);
    EXPECT_GT(three->c.standardError, 0);
    EXPECT_GT(3 * three->P_nT.standardError, std::abs(three->P_nT.value - 900));
    EXPECT_NEAR(three->f.standardError, 0, 1e-9); // C agrees
}

TEST(IronSeparation, swingsThatContradictEachOtherAreSaidTo)
{
    const auto model = someIron();
    std::vector swings{
        exactSwing(model, kWarsaw, "Warsaw"), exactSwing(model, kSingapore, "Singapore"), exactSwing(model, kPerth, "Perth")};
    for (auto& swing : swings)
        swing.standardError = {0.003, 0.003, 0.003, 0.003, 0.003};
    EXPECT_TRUE(separateIron(swings)->warnings.empty());
    swings[1].exact.B += 0.05;
    const auto separation = separateIron(swings);
    EXPECT_GT(separation->chiSquare, 20);
    EXPECT_EQ(separation->degreesOfFreedom, 2);
    ASSERT_EQ(separation->warnings.size(), 1u);
    EXPECT_NE(separation->warnings[0].english().find("contradict"), std::string::npos);
}

TEST(IronSeparation, whatOneSwingTellsAndWhatNot)
{
    const auto swing = exactSwing(someIron(), kWarsaw, "Warsaw");
    const auto known = [](const std::vector<Knowledge>& list) {
        return std::count_if(list.begin(), list.end(), [](const auto& each) { return each.known; });
    };
    const auto alone = whatSwingsTell(swing, {});
    EXPECT_EQ(known(alone), 5);
    EXPECT_EQ(alone.size(), 11u);
    const auto both = whatSwingsTell(swing, *separateIron(std::vector{swing, exactSwing(someIron(), kSingapore, "Singapore")}));
    EXPECT_EQ(known(both), 7);
}

TEST(ModelOfASwing, hasTheSwingsCoefficients)
{
    const auto swing = exactSwing(someIron(), kPerth, "Perth"); // dip negative: the signs must hold there, too
    for (const auto origin : {Origin::HardIron, Origin::VerticalSoftIron}) {
        const auto model = modelOf(swing.exact, kPerth, origin);
        ASSERT_TRUE(model);
        const auto smith = smithOf(*model, kPerth);
        ASSERT_TRUE(smith);
        EXPECT_NEAR(smith->lambda, 1.0, 1e-15);
        EXPECT_NEAR(smith->exact.A, swing.exact.A, 1e-15);
        EXPECT_NEAR(smith->exact.B, swing.exact.B, 1e-15);
        EXPECT_NEAR(smith->exact.C, swing.exact.C, 1e-15);
        EXPECT_NEAR(smith->exact.D, swing.exact.D, 1e-15);
        EXPECT_NEAR(smith->exact.E, swing.exact.E, 1e-15);
    }
    EXPECT_FALSE(modelOf(swing.exact, {30000, 0}, Origin::VerticalSoftIron));
    EXPECT_TRUE(modelOf(swing.exact, {30000, 0}, Origin::HardIron));
}

} // namespace
} // namespace lubberline
