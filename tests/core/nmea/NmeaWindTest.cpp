// Turns in the wind: it is taken out where the tracks tell it, and what it costs is said where they do not.

#include "tests/core/nmea/MadeTurn.h"

namespace lubberline {
namespace {

using namespace test;

TEST(NmeaTurn, windIsTakenOut)
{
    for (const double from : {45.0, 190.0, 270.0})
        for (const double wind : {5.0, 25.0}) {
            const double airspeed = wind > 10.0 ? 100.0 : 60.0;
            const auto what = formatted("%g kt from %g at %g kt", wind, from, airspeed);
            const auto answer = answerOf(logOf({{{1.0, 400.0}}, airspeed, from, wind}));
            ASSERT_TRUE(answer.swing.wind) << what;
            EXPECT_TRUE(answer.swing.wind->takenOut) << what;
            EXPECT_NEAR(answer.swing.wind->speed_kt(), wind, 0.1) << what;
            EXPECT_NEAR(wrap180(answer.swing.wind->from_deg() - from), 0.0, 0.5) << what;
            EXPECT_NEAR(answer.swing.wind->airspeed_kt, airspeed, 0.1) << what;
            expectTruth(answer, 0.1, what);
        }
}

TEST(NmeaTurn, threeLegsTellTheWindToo)
{
    Flight flight{{{0.0, 90.0}, {3.0, 40.0}, {0.0, 90.0}, {3.0, 40.0}, {0.0, 90.0}, {3.0, 40.0}, {0.0, 90.0}}, 90.0, 310.0, 18.0};
    const auto answer = answerOf(logOf(flight));
    ASSERT_TRUE(answer.swing.wind && answer.swing.wind->takenOut);
    EXPECT_NEAR(answer.swing.wind->speed_kt(), 18.0, 0.1);
    EXPECT_NEAR(answer.of(Coefficient::B), -3.0, 0.2);
    EXPECT_NEAR(answer.of(Coefficient::C), 2.0, 0.2);
}

TEST(NmeaTurn, onWheelsTheSpeedIsTheDriversAndItsCostIsSaid)
{
    Flight flight{{{1.0, 400.0}}, 8.0, 90.0, 1.0};
    const auto answer = answerOf(logOf(flight));
    ASSERT_TRUE(answer.swing.wind);
    EXPECT_FALSE(answer.swing.wind->takenOut);
    EXPECT_TRUE(answer.says("B and C are out by up to 7.2"));
    for (const auto which : {Coefficient::B, Coefficient::C})
        EXPECT_LE(std::abs(answer.of(which) - (which == Coefficient::B ? -3.0 : 2.0)), 2.0 * answer.errorOf(which)) << letterOf(which);
    NmeaOptions afloat;
    afloat.wind = NmeaWindChoice::TakeOut;
    expectTruth(answerOf(logOf(flight), afloat), 0.15, "afloat");
    NmeaOptions leave;
    leave.wind = NmeaWindChoice::Leave;
    EXPECT_FALSE(answerOf(logOf(flight), leave).swing.wind);
}

/// Exact check of the project's notes on estimation: wind (8, −5) m/s, airspeed 60 m/s, headings 010, 100, 190, 280.
TEST(NmeaWind, fourTracksGiveWindAndAirspeed)
{
    std::vector<TimedHeading> tracks;
    for (const double heading : {10.0, 100.0, 190.0, 280.0}) {
        const double east = 60.0 * std::sin(toRadians(heading)) + 8.0, north = 60.0 * std::cos(toRadians(heading)) - 5.0;
        tracks.push_back({heading, wrap360(toDegrees(std::atan2(east, north))), std::hypot(east, north)});
    }
    const auto wind = windOf(tracks);
    ASSERT_TRUE(wind);
    EXPECT_NEAR(wind->toward_kt.x(), 8.0, 1e-9);
    EXPECT_NEAR(wind->toward_kt.y(), -5.0, 1e-9);
    EXPECT_NEAR(wind->airspeed_kt, 60.0, 1e-9);
    for (const auto& track : tracks)
        EXPECT_NEAR(headingInWind_deg(*wind, *track.heading_deg, *track.speed_kt), track.seconds, 1e-9);
    tracks.resize(2);
    EXPECT_FALSE(windOf(tracks));
}

TEST(NmeaTurn, aTooShortArcInTheWindIsAsUnsureAsTheWind)
{
    const auto answer = answerOf(logOf({{{1.0, 95.0}}, 80.0, 200.0, 15.0}));
    EXPECT_TRUE(answer.says("the tracks do not tell the wind"));
    EXPECT_LE(std::abs(answer.of(Coefficient::A) - 0.8), 3.0 * answer.errorOf(Coefficient::A));
    EXPECT_GE(answer.errorOf(Coefficient::B), 3.0);
    EXPECT_GE(answer.errorOf(Coefficient::C), 3.0);
}

} // namespace
} // namespace lubberline
