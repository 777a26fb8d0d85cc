// Two compasses read together: which moved, by how they change and by a datum; and what their readings cannot tell.

#include <gtest/gtest.h>

#include <algorithm>

#include "core/angle/Angle.h"
#include "tests/core/check/SimulatedCompass.h"

namespace lubberline {
namespace {

/// Ten yearly swings that read the same, or wander with this step.
CompassBelief compassOf(double step_deg, CompassKind kind = CompassKind::DirectReading)
{
    std::vector<PastSwing> history;
    for (int i = 0; i < 10; ++i) {
        const double at = i % 2 == 0 ? step_deg : -step_deg;
        history.push_back({2015.0 + i, {at / 2, at, -at, 0, 0}, {0.15, 0.2, 0.2, 0.2, 0.2}, false});
    }
    PlausibleChange plausible = plausibleFor(kind);
    plausible.jumpsPerYear = 0.02;
    return beliefOf(history, 2024.5, plausible);
}

/// What both read on eight headings after their B changed by so much.
std::vector<PairReading> readingsOf(const CompassBelief& one, const CompassBelief& two, double firstB_deg, double secondB_deg, bool datum)
{
    const auto compass = [](const CompassBelief& belief, double change_deg, double magnetic_deg) {
        double heading = magnetic_deg;
        for (int i = 0; i < 50; ++i)
            heading = magnetic_deg - deviationAt(belief.card, CompassHeading::fromDegrees(heading)).degrees()
                - change_deg * std::sin(toRadians(heading));
        return CompassHeading::fromDegrees(heading);
    };
    std::vector<PairReading> pairs;
    for (int heading = 0; heading < 360; heading += 45) {
        PairReading pair{compass(one, firstB_deg, heading), compass(two, secondB_deg, heading), {}};
        if (datum && heading == 90)
            pair.datum = MagneticHeading::fromDegrees(heading);
        pairs.push_back(pair);
    }
    return pairs;
}

TEST(TwoCompasses, theUnsteadyOneIsNamed)
{
    const auto steady = compassOf(0.05), unsteady = compassOf(2.0);
    const auto verdict = compareCompasses(steady, unsteady, readingsOf(steady, unsteady, 0, 4.5, false), {});
    ASSERT_TRUE(verdict);
    ASSERT_TRUE(verdict->named) << inWords(*verdict).english();
    EXPECT_EQ(*verdict->named, Moved::Second);
    EXPECT_LT(verdict->errorProbability, 0.2);
    // m1 − m2 = −x Δ1 + x Δ2.
    EXPECT_NEAR(verdict->difference_deg[1], 4.5, 0.3);
    const auto other = compareCompasses(unsteady, steady, readingsOf(unsteady, steady, 4.5, 0, false), {});
    EXPECT_EQ(*other->named, Moved::First);
    EXPECT_NEAR(other->probability[1], verdict->probability[2], 0.05);
    EXPECT_NEAR(other->difference_deg[1], -4.5, 0.3);
}

TEST(TwoCompasses, equalsAreNotToldApartButByADatum)
{
    const auto one = compassOf(0.3), two = compassOf(0.3);
    const auto without = compareCompasses(one, two, readingsOf(one, two, 6, 0, false), {});
    ASSERT_TRUE(without);
    EXPECT_FALSE(without->named);
    EXPECT_NEAR(without->probability[1], without->probability[2], 0.1);
    EXPECT_NE(inWords(*without).english().find("not told which"), std::string::npos);
    const auto with = compareCompasses(one, two, readingsOf(one, two, 6, 0, true), {});
    ASSERT_TRUE(with->named);
    EXPECT_EQ(*with->named, Moved::First);
    EXPECT_EQ(with->withDatum, 1u);
}

TEST(TwoCompasses, whatIsWantedNextIsWhatIsNotThereYet)
{
    PairVerdict verdict;
    EXPECT_NE(inWords(verdict).english().find("once beside a datum"), std::string::npos);
    verdict.withDatum = 2;
    EXPECT_NE(inWords(verdict).english().find("more headings beside the datum"), std::string::npos);
}

TEST(TwoCompasses, whatMovedMakesASwingDue)
{
    const auto steady = compassOf(0.05), unsteady = compassOf(2.0);
    const auto moved = compareCompasses(steady, unsteady, readingsOf(steady, unsteady, 0, 4.5, false), {});
    const std::string why = whySwing(*moved, "standby", "main").english();
    EXPECT_NE(why.find("beside standby, the compass main no longer holds"), std::string::npos) << why;
    const auto one = compassOf(0.3), two = compassOf(0.3);
    const auto notTold = compareCompasses(one, two, readingsOf(one, two, 6, 0, false), {});
    EXPECT_NE(whySwing(*notTold, "standby", "main").english().find("not told which"), std::string::npos);
    EXPECT_TRUE(whySwing(*compareCompasses(one, two, readingsOf(one, two, 0, 0, true), {}), "standby", "main").empty());
}

TEST(TwoCompasses, movedTogetherIsNotTold)
{
    const auto one = compassOf(0.3), two = compassOf(0.3);
    const auto verdict = compareCompasses(one, two, readingsOf(one, two, 6, 6, false), {});
    ASSERT_TRUE(verdict);
    EXPECT_NEAR(verdict->rms_deg, 0, 0.1);
    ASSERT_FALSE(verdict->warnings.empty());
    EXPECT_NE(verdict->warnings[0].english().find("not told apart from the datum"), std::string::npos);
    // The verdict itself says what it does not tell.
    ASSERT_EQ(verdict->named, Moved::Neither);
    EXPECT_NE(inWords(*verdict).english().find("whether both moved alike is not told without a datum"), std::string::npos);
    const auto with = compareCompasses(one, two, readingsOf(one, two, 6, 6, true), {});
    EXPECT_GT(with->probability[3], verdict->probability[3]);
    EXPECT_FALSE(compareCompasses(one, two, {}, {}));
}

TEST(TwoCompasses, aLogIsNoSurerThanItsHeadings)
{
    const auto one = compassOf(0.3), two = compassOf(0.3);
    const auto pairs = readingsOf(one, two, 4, 0, false);
    std::vector<PairReading> log;
    for (const auto& pair : pairs)
        log.insert(log.end(), 50, pair);
    const auto few = compareCompasses(one, two, pairs, {}), many = compareCompasses(one, two, log, {});
    EXPECT_EQ(many->readings, 400u);
    EXPECT_EQ(many->headings, few->headings);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(many->probability[i], few->probability[i], 1e-9);
    const auto said = [](const PairVerdict& verdict, const char* words) {
        return std::any_of(verdict.warnings.begin(), verdict.warnings.end(),
            [words](const Message& warning) { return warning.english().find(words) != std::string::npos; });
    };
    EXPECT_TRUE(said(*many, "400 pairs were read on 8 different headings"));
    EXPECT_FALSE(said(*few, "different headings"));
    EXPECT_FALSE(said(*many, "contradict"));
    auto twice = pairs;
    twice.push_back({twice[2].first, CompassHeading::fromDegrees(twice[2].second.degrees() + 9), {}});
    EXPECT_TRUE(said(*compareCompasses(one, two, twice, {}), "contradict each other by 9.0°"));
}

TEST(TwoCompasses, aDatumThatIsOutIsDoubtedBeforeBothCompasses)
{
    const auto one = compassOf(0.05), two = compassOf(0.05);
    const auto beside = [&](double datum_deg, double firstB_deg, double secondB_deg) {
        auto pairs = readingsOf(one, two, firstB_deg, secondB_deg, false);
        for (std::size_t i = 0; i < pairs.size(); ++i)
            pairs[i].datum = MagneticHeading::fromDegrees(45.0 * static_cast<double>(i) + datum_deg);
        return compareCompasses(one, two, pairs, {});
    };
    const auto out = beside(5, 0, 0);
    ASSERT_TRUE(out && out->datumOut_deg) << inWords(*out).english();
    EXPECT_NEAR(*out->datumOut_deg, 5, 0.05);
    EXPECT_NE(inWords(*out).english().find("+5.0° alike"), std::string::npos) << inWords(*out).english();
    EXPECT_NE(whySwing(*out, "main", "standby").english().find("+5.0° alike"), std::string::npos);
    EXPECT_NEAR(*beside(-5, 0, 0)->datumOut_deg, -5, 0.05);
    EXPECT_FALSE(beside(0, 0, 0)->datumOut_deg); // all is well
    EXPECT_FALSE(beside(0, 6, 6)->datumOut_deg); // a B of both is no datum's
    EXPECT_FALSE(beside(0, 0, 6)->datumOut_deg); // one of them moved
}

} // namespace
} // namespace lubberline
