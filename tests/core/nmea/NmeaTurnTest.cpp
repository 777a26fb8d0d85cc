// Turns made from known coefficients, with delays: what comes back lies within what is stated of it, and what cannot be told is said.

#include "tests/core/nmea/MadeTurn.h"

namespace lubberline {
namespace {

using namespace test;

TEST(NmeaTurn, aOneWayTurnTellsThatDelayAndAStayTogether)
{
    for (const double rate : {1.0, -3.0, 0.5})
        for (const double delay : {0.0, 1.5})
            for (const bool compassFirst : {true, false}) {
                const int hz = compassFirst ? 1 : 10;
                const auto what = formatted("%g deg/s, %g s, %d Hz, %d", rate, delay, hz, compassFirst);
                const auto answer = answerOf(logOf({{{rate, 400.0 / std::abs(rate)}}, 6.0, 0.0, 0.0, delay, hz, compassFirst}));
                EXPECT_FALSE(answer.swing.delay.seconds) << what;
                EXPECT_EQ(answer.swing.delay.told, DelayTold::OneWay) << what;
                EXPECT_NEAR(answer.swing.delay.A_degPerSecond, -rate, 0.02) << what;
                EXPECT_NEAR(answer.of(Coefficient::A), 0.8 - rate * delay, 0.1 * std::abs(rate) + 0.02) << what;
                EXPECT_GE(answer.errorOf(Coefficient::A), std::abs(rate) * 0.99) << what;
                EXPECT_TRUE(answer.says("cannot be told apart")) << what;
                expectTruth(answer, 0.05, what);
            }
}

TEST(NmeaTurn, aTurnBothWaysTellsTheDelay)
{
    for (const double rate : {0.5, -2.0})
        for (const double delay : {-0.6, 0.7, 2.5})
            for (const bool compassFirst : {true, false}) {
                const int hz = compassFirst ? 10 : 1;
                const auto what = formatted("%g deg/s, %g s, %d Hz, %d", rate, delay, hz, compassFirst);
                const double round_s = 400.0 / std::abs(rate);
                const auto answer = answerOf(logOf({{{rate, round_s}, {-rate, round_s}}, 6.0, 0.0, 0.0, delay, hz, compassFirst}));
                ASSERT_TRUE(answer.swing.delay.seconds) << what;
                EXPECT_EQ(answer.swing.delay.told, DelayTold::BothWays) << what;
                EXPECT_NEAR(*answer.swing.delay.seconds, delay, 0.1) << what; // ten headings a second are placed to a tenth
                EXPECT_NEAR(answer.of(Coefficient::A), 0.8, 0.03) << what;
                EXPECT_LT(answer.swing.directions->largestDifference_deg, 0.4) << what;
                expectTruth(answer, 0.05, what);
            }
}

TEST(NmeaTurn, unevenTracksLeaveTheDelayAsUnsureAsTheyAre)
{
    int within = 0;
    for (const double delay : {-0.5, 0.0, 0.4, 0.9, 1.3, 2.0}) {
        Flight flight{{{1.5, 300.0}, {-1.5, 300.0}}, 6.0, 0.0, 0.0, delay};
        flight.noise_deg = 1.0;
        const auto answer = answerOf(logOf(flight));
        ASSERT_TRUE(answer.swing.delay.seconds) << delay;
        within += std::abs(*answer.swing.delay.seconds - delay) <= 2.0 * answer.swing.delay.standardError_s;
        EXPECT_NEAR(*answer.swing.delay.seconds, delay, 0.3);
        EXPECT_NEAR(answer.of(Coefficient::A), 0.8, 0.2);
    }
    EXPECT_GE(within, 5);
}

TEST(NmeaTurn, aChangingRateTellsTheDelay)
{
    Flight flight;
    flight.legs.clear();
    for (int i = 0; i < 40; ++i)
        flight.legs.push_back({i % 2 ? 0.4 : 2.0, 15.0});
    flight.delay_s = 1.2;
    const auto answer = answerOf(logOf(flight));
    ASSERT_TRUE(answer.swing.delay.seconds);
    EXPECT_EQ(answer.swing.delay.told, DelayTold::VaryingRate);
    EXPECT_NEAR(*answer.swing.delay.seconds, 1.2, 0.1);
    expectTruth(answer, 0.05, "two rates");
    EXPECT_NEAR(answer.of(Coefficient::A), 0.8, 0.1);
}

TEST(NmeaTurn, steadyHeadingsNeedNoDelay)
{
    Flight flight;
    flight.legs.clear();
    for (int i = 0; i < 12; ++i) {
        flight.legs.push_back({0.0, 60.0});
        flight.legs.push_back({6.0, 5.0}); // left out: too fast
    }
    flight.delay_s = 0.3;
    const auto answer = answerOf(logOf(flight));
    EXPECT_EQ(answer.swing.delay.told, DelayTold::NoTurn);
    EXPECT_LT(std::abs(answer.swing.delay.A_degPerSecond), 0.1);
    expectTruth(answer, 0.1, "legs");
}

/// A log without any time counts its own steps; the delay is told in them.
TEST(NmeaTurn, withoutTimesTheTurnIsTakenAsADegreeASecond)
{
    const auto timeless = [](const Flight& flight) {
        std::string log;
        std::istringstream lines(logOf(flight));
        for (std::string line; std::getline(lines, line);) {
            const auto found = nmeaSentences(line).front().sentence;
            log += (found.type == "RMC" ? makeNmea("GPVTG," + found.fields[7] + ",T,,M," + found.fields[6] + ",N,,K") : line) + "\n";
        }
        return log;
    };
    NmeaOptions stated;
    stated.variation = Variation::fromDegrees(15.2);
    const auto one = answerOf(timeless({}), stated);
    EXPECT_TRUE(one.says("the log tells no time"));
    EXPECT_GE(one.errorOf(Coefficient::A), 1.0);
    const auto both = answerOf(timeless({{{2.0, 200.0}, {-2.0, 200.0}}, 6.0, 0.0, 0.0, 1.5}), stated);
    EXPECT_NEAR(both.of(Coefficient::A), 0.8, 0.05);
    ASSERT_TRUE(both.swing.delay.seconds);
    EXPECT_NEAR(*both.swing.delay.seconds / both.swing.step_s, 1.5, 0.1);
    EXPECT_NE(toSwing(both.swing).note.find("older than the heading beside it"), std::string::npos);
    const auto early = answerOf(timeless({{{2.0, 200.0}, {-2.0, 200.0}}, 6.0, 0.0, 0.0, -1.5}), stated);
    ASSERT_TRUE(early.swing.delay.seconds);
    EXPECT_LT(*early.swing.delay.seconds, -1.0);
    EXPECT_EQ(toSwing(early.swing).note.find("the reference is \u2212"), std::string::npos); // newer, not older by less than nothing
    EXPECT_NE(toSwing(early.swing).note.find("s newer than the heading beside it"), std::string::npos);
}

TEST(NmeaTurn, readingsCarryTheirTimesInOrder)
{
    const Swing swing = toSwing(answerOf(logOf({{{2.0, 60.0}}, 6.0, 0.0, 0.0, 0.0, 10})).swing);
    ASSERT_GT(swing.readings.size(), 500u);
    EXPECT_EQ(swing.readings.front().timeUtc, "2025-11-20T09:00:00.000Z");
    for (std::size_t i = 1; i < swing.readings.size(); ++i)
        EXPECT_LT(swing.readings[i - 1].timeUtc, swing.readings[i].timeUtc);
}

} // namespace
} // namespace lubberline
