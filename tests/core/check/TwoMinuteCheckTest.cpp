// The two-minute check on simulated compasses whose truth is known: its error probabilities hold, its headings tell more than evenly spaced
// ones, and what it cannot know is said.

#include <gtest/gtest.h>

#include <algorithm>

#include "core/angle/Angle.h"
#include "core/check/CheckHeadings.h"
#include "core/check/History.h"
#include "tests/core/check/SimulatedCompass.h"

namespace lubberline {
namespace {

std::vector<PastSwing> quietHistory(int swings)
{
    std::vector<PastSwing> history;
    for (int i = 0; i < swings; ++i)
        history.push_back({2015.0 + i, {0.5, 2, -3, 0.5, 0}, {0.2, 0.3, 0.3, 0.3, 0.3}, false});
    return history;
}

Observation readAt(const CompassBelief& belief, double compass_deg, double more_deg)
{
    const auto compass = CompassHeading::fromDegrees(compass_deg);
    return {MagneticHeading::fromDegrees(compass_deg + deviationAt(belief.card, compass).degrees() + more_deg), compass};
}

TEST(CompassBelief, learnsFromTheHistory)
{
    const auto quiet = beliefOf(quietHistory(10), 2025, {});
    auto lively = quietHistory(10);
    for (std::size_t i = 0; i < lively.size(); ++i)
        lively[i].value_deg[2] = i % 2 == 0 ? -3.0 : 0.0; // its C jumps to and fro
    const auto wandering = beliefOf(lively, 2025, {});
    EXPECT_LT(quiet.walk_deg_year[2], PlausibleChange{}.walk_deg_year[2]);
    EXPECT_GT(wandering.walk_deg_year[2], 2 * quiet.walk_deg_year[2]);
    EXPECT_NEAR(wandering.walk_deg_year[1], quiet.walk_deg_year[1], 0.1);
    EXPECT_NEAR(quiet.jumpProbability, 1 - std::exp(-0.05), 1e-9);
    // A correction is no change of its own.
    for (auto& swing : lively)
        swing.afterCorrection = true;
    EXPECT_LT(beliefOf(lively, 2025, {}).walk_deg_year[2], wandering.walk_deg_year[2] / 1.5);
    EXPECT_NEAR(toDegrees(quiet.card.B_rad), 2, 1e-12);
    EXPECT_FALSE(beliefOf({}, 2025, {}).hasHistory);
    EXPECT_FALSE(beliefOf(quietHistory(3), 2010, {}).hasHistory); // all of them are later
}

TEST(TwoMinuteCheck, agreementAndDisagreement)
{
    const auto belief = beliefOf(quietHistory(10), 2025, {});
    const auto headings = headingsFor(belief, 3, {}).compass_deg;
    std::vector<Observation> agree, apart;
    for (const double heading : headings) {
        agree.push_back(readAt(belief, heading, 0.3));
        apart.push_back(readAt(belief, heading, 6));
    }
    const auto holds = verdictOf(belief, agree, {});
    ASSERT_TRUE(holds);
    EXPECT_TRUE(holds->holds);
    EXPECT_LT(holds->errorProbability, 0.05);
    EXPECT_LT(holds->errorProbability, holds->before);
    EXPECT_NEAR(holds->largestRead_deg, 0.3, 1e-9);
    EXPECT_TRUE(holds->warnings.empty());
    const auto swing = verdictOf(belief, apart, {});
    EXPECT_FALSE(swing->holds);
    EXPECT_LT(swing->errorProbability, 0.01);
    EXPECT_FALSE(verdictOf(belief, {}, {}));
    // Over a limit it does not hold, whatever the card says.
    CheckOptions limited;
    limited.limit_deg = 2;
    EXPECT_FALSE(verdictOf(belief, agree, limited)->holds);
}

TEST(TwoMinuteCheck, aHeadingThatIsReadTwiceIsOneReading)
{
    const auto belief = beliefOf(quietHistory(3), 2025, {});
    const auto once = verdictOf(belief, std::vector{readAt(belief, 0, 2), readAt(belief, 90, 2)}, {});
    const auto twice
        = verdictOf(belief, std::vector{readAt(belief, 0, 1.5), readAt(belief, 90, 2), readAt(belief, 0, 2.5), readAt(belief, 90, 2)}, {});
    ASSERT_TRUE(once && twice);
    EXPECT_NEAR(twice->errorProbability, once->errorProbability, 1e-9);
    EXPECT_NEAR(twice->reachable, once->reachable, 1e-9);
    EXPECT_EQ(twice->differences_deg.size(), 4u);
    EXPECT_EQ(twice->warnings.size(), once->warnings.size() + 2);
    const auto said = [](const CheckVerdict& verdict, const char* words) {
        return std::any_of(verdict.warnings.begin(), verdict.warnings.end(),
            [words](const Message& one) { return one.english().find(words) != std::string::npos; });
    };
    EXPECT_TRUE(said(*twice, "90° was read 2 times: it counts as one reading, the mean"));
    EXPECT_FALSE(said(*once, "was read"));
    // Across north, too; and what contradicts itself is no mean of two good readings.
    const auto apart = verdictOf(belief, std::vector{readAt(belief, 359, 0), readAt(belief, 2, 8)}, {});
    EXPECT_TRUE(said(*apart, "the readings on 359° contradict each other by 8.0°"));
}

TEST(TwoMinuteCheck, withoutHistoryItSaysWhatItCannotKnow)
{
    const auto belief = beliefOf({}, 2025, {});
    const auto verdict = verdictOf(belief, std::vector{readAt(belief, 0, 0), readAt(belief, 90, 0)}, {});
    ASSERT_TRUE(verdict);
    EXPECT_FALSE(verdict->holds);
    ASSERT_EQ(verdict->warnings.size(), 2u);
    EXPECT_NE(verdict->warnings[0].english().find("no swing on record"), std::string::npos);
    EXPECT_NE(verdict->warnings[1].english().find("too few"), std::string::npos);
}

TEST(TwoMinuteCheck, oneHeadingAndTheOtherSideAreSaid)
{
    const auto belief = beliefOf(quietHistory(10), 2025, {});
    const auto says = [](const CheckVerdict& verdict, const char* words) {
        const auto warnings = inEnglish(verdict.warnings);
        return std::any_of(warnings.begin(), warnings.end(), [&](const auto& one) { return one.find(words) != std::string::npos; });
    };
    EXPECT_TRUE(says(*verdictOf(belief, std::vector{readAt(belief, 0, 0.2)}, {}), "on one heading only"));
    const std::vector both{readAt(belief, 0, 0.2), readAt(belief, 120, -0.3)};
    EXPECT_FALSE(says(*verdictOf(belief, both, {}), "on one heading only"));
    EXPECT_FALSE(says(*verdictOf(belief, both, {}), "other side"));
    EXPECT_TRUE(says(*verdictOf(belief, std::vector{readAt(belief, 0, 180), readAt(belief, 120, 179)}, {}), "other side"));
}

TEST(CheckHeadings, looksWhereThisCompassWanders)
{
    auto history = quietHistory(10);
    for (std::size_t i = 0; i < history.size(); ++i)
        history[i].value_deg[2] = i % 2 == 0 ? -4.0 : 0.0;
    PlausibleChange plausible;
    plausible.jumpsPerYear = 0;
    const auto chosen = headingsFor(beliefOf(history, 2025, plausible), 2, {});
    ASSERT_EQ(chosen.compass_deg.size(), 2u);
    for (const double heading : chosen.compass_deg) // C is cos: north and south tell it
        EXPECT_GT(std::abs(std::cos(toRadians(heading))), 0.85) << heading;
    EXPECT_LT(chosen.left_deg, chosen.before_deg);
    auto eastWest = quietHistory(10);
    for (std::size_t i = 0; i < eastWest.size(); ++i)
        eastWest[i].value_deg[1] = i % 2 == 0 ? 3.0 : 1.4;
    const auto ofEastWest = headingsFor(beliefOf(eastWest, 2026, {}), 2, {});
    EXPECT_NEAR(std::abs(std::sin(toRadians(ofEastWest.compass_deg[0]))), 1, 0.05);
    EXPECT_LT(ofEastWest.left_deg, 0.6 * ofEastWest.leftEven_deg); // north and south tell nothing of B
    for (const auto& of : {quietHistory(10), eastWest})
        for (const int count : {1, 2, 3, 4, 5, 7, 8, 12, 24}) {
            const auto any = headingsFor(beliefOf(of, 2025, {}), count, {});
            EXPECT_EQ(any.compass_deg.size(), static_cast<std::size_t>(count));
            EXPECT_LE(any.left_deg, any.leftEven_deg + 1e-6) << count;
            EXPECT_TRUE(std::is_sorted(any.compass_deg.begin(), any.compass_deg.end()));
        }
}

/// A few of what a program of its own does for 2,000.
TEST(TwoMinuteCheck, errorProbabilitiesHold)
{
    CheckRandom random(42);
    const CheckOptions options;
    double stated = 0, spread = 0, wrong = 0;
    for (int i = 0; i < 50; ++i) {
        const auto compass = test::simulateCompass(6, {}, options, random);
        std::vector<Observation> readings;
        for (const double heading : {30.0, 150.0, 270.0})
            readings.push_back(compass.read(heading, options.readingError_deg, random));
        const double fault = chanceOfFault(compass.belief, readings, options), error = std::min(fault, 1 - fault);
        stated += error;
        spread += error * (1 - error);
        wrong += compass.fault == (fault < 0.5);
    }
    EXPECT_NEAR(wrong, stated, 3 * std::sqrt(spread));
}

/// What is left open after two readings, p(1 − p) of the chance p of a fault (where chances hold, the Brier score that is expected), with the
/// same errors of reading here and there. Of 2,000 compasses a program of its own finds 0.0821 against 0.0909 for two (the difference ± 0.0013), and
/// 0.0676 against 0.0723 for three (± 0.0009).
TEST(CheckHeadings, leaveLessOpenThanEvenlySpacedOnes)
{
    CheckRandom random(44);
    const CheckOptions options;
    double chosen = 0, even = 0;
    for (int i = 0; i < 150; ++i) {
        const auto compass = test::simulateCompass(10, {}, options, random);
        const auto open = [&](const std::vector<double>& headings) {
            CheckRandom errors(1000 + i);
            std::vector<Observation> readings;
            for (const double heading : headings)
                readings.push_back(compass.read(heading, options.readingError_deg, errors));
            const double fault = chanceOfFault(compass.belief, readings, options);
            return fault * (1 - fault);
        };
        chosen += open(headingsFor(compass.belief, 2, options).compass_deg);
        even += open(evenHeadings(2));
    }
    EXPECT_LT(chosen, 0.95 * even);
}

TEST(History, outOfRecordedSwings)
{
    SwingRecord record;
    EXPECT_FALSE(pastSwing(record));
    record.swing.date = "2024-07-01";
    record.compass.resolution_deg = 1;
    for (int heading = 0; heading < 360; heading += 45) {
        Reading reading;
        const double deviation = 1 + 2 * std::sin(toRadians(heading));
        reading.compass = CompassHeading::fromDegrees(heading);
        reading.magnetic = MagneticHeading::fromDegrees(heading + deviation);
        record.swing.readings.push_back(reading);
    }
    auto later = record;
    later.swing.date = "2025-07-01";
    later.swing.stage = SwingStage::AsLeft;
    const auto history = historyOf(std::vector{later, SwingRecord(), record});
    ASSERT_EQ(history.size(), 2u);
    EXPECT_NEAR(history[0].year, 2024.5, 0.01);
    EXPECT_NEAR(*history[0].value_deg[0], 1, 1e-9);
    EXPECT_NEAR(*history[0].value_deg[1], 2, 1e-9);
    EXPECT_GT(history[0].standardError_deg[0], 0.05); // that of its division
    EXPECT_FALSE(history[0].afterCorrection);
    EXPECT_TRUE(history[1].afterCorrection);
}

} // namespace
} // namespace lubberline
