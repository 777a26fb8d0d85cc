// Turns made from known coefficients, with delays, winds, wrong variations and wrong dates: what comes back lies within what is
// stated of it, and what cannot be told is said.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>
#include <sstream>

#include "core/nmea/NmeaBase.h"
#include "core/nmea/NmeaSwing.h"
#include "core/swing/Analysis.h"
#include "core/swing/Observations.h"

namespace lubberline {
namespace {

const ApproximateSmith kTruth{toRadians(0.8), toRadians(-3.0), toRadians(2.0), toRadians(1.2), toRadians(-0.4)};

struct Leg {
    double rate_deg_s = 0, seconds = 0;
};

/// A flight (or a walk on wheels) that a log is made of.
struct Flight {
    std::vector<Leg> legs{{1.0, 400.0}};
    double airspeed_kt = 6.0, windFrom_deg = 0.0, wind_kt = 0.0;
    double delay_s = 0.0; ///< the track that is sent is so old
    int compassHz = 1;
    bool compassFirst = true;
    double variation_deg = 15.2, variationTold_deg = 15.2;
    double noise_deg = 0.0;
    const char* date = "201125";
    double began_deg = 20.0;
};

/// Magnetic heading at a moment; it turned before the log began, and is steady after it.
double headingAt(const Flight& flight, double seconds)
{
    double heading = flight.began_deg + flight.legs.front().rate_deg_s * std::min(0.0, seconds);
    for (const Leg& leg : flight.legs) {
        heading += leg.rate_deg_s * std::clamp(seconds, 0.0, leg.seconds);
        seconds -= std::max(0.0, std::min(seconds, leg.seconds));
    }
    return heading;
}

std::string formatted(const char* format, auto... values)
{
    char text[160];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

std::string logOf(const Flight& flight)
{
    std::mt19937 random(17);
    std::normal_distribution<double> noise(0.0, 1.0);
    double length_s = 0;
    for (const Leg& leg : flight.legs)
        length_s += leg.seconds;
    std::string log;
    const auto compass = [&](double seconds) {
        const double magnetic_deg = headingAt(flight, seconds);
        double reads_deg = magnetic_deg; // deviations are small: the steps shrink by a factor of ten each
        for (int step = 0; step < 20; ++step)
            reads_deg = magnetic_deg - deviationAt(kTruth, CompassHeading::fromDegrees(reads_deg)).degrees();
        log += makeNmea(formatted("HCHDG,%.1f,,,,", wrap360(std::round(wrap360(reads_deg) * 10) / 10))) + "\r\n";
    };
    const auto track = [&](int second) {
        const double heading = toRadians(headingAt(flight, second - flight.delay_s) + flight.variation_deg);
        const double from = toRadians(flight.windFrom_deg);
        const double east = flight.airspeed_kt * std::sin(heading) - flight.wind_kt * std::sin(from);
        const double north = flight.airspeed_kt * std::cos(heading) - flight.wind_kt * std::cos(from);
        const double made = wrap360(toDegrees(std::atan2(east, north)) + flight.noise_deg * noise(random));
        log += makeNmea(formatted("GPRMC,%02d%02d%02d.00,A,4736.0,N,12218.0,W,%.1f,%.1f,%s,%.1f,%s,A", 9 + second / 3600, second / 60 % 60,
                   second % 60, std::hypot(east, north), made, flight.date, std::abs(flight.variationTold_deg),
                   flight.variationTold_deg < 0 ? "W" : "E"))
            + "\r\n";
    };
    for (int second = 0; second < length_s; ++second) {
        if (flight.compassFirst)
            compass(second);
        track(second);
        for (int part = flight.compassFirst ? 1 : 0; part < flight.compassHz; ++part)
            compass(second + static_cast<double>(part) / flight.compassHz);
    }
    return log;
}

struct Answer {
    NmeaSwing swing;
    Analysis analysis;
    [[nodiscard]] double of(Coefficient which) const { return toDegrees(*analysis.approximate.of(which)); }
    [[nodiscard]] double errorOf(Coefficient which) const { return toDegrees(*analysis.approximate.standardError[indexOf(which)]); }
    [[nodiscard]] bool says(const std::string& words) const
    {
        const auto told = inEnglish(swing.warnings);
        return std::any_of(told.begin(), told.end(), [&](const auto& one) { return one.find(words) != std::string::npos; });
    }
};

Answer answerOf(const std::string& log, NmeaOptions options = {})
{
    options.today = "2026-11-26";
    std::istringstream stream(log);
    auto swing = readNmeaSwing(stream, "turn.nmea", options);
    EXPECT_TRUE(swing) << (swing ? "" : swing.error().message.english());
    const Swing record = toSwing(*swing);
    auto analysis = analyse(observationsOf(record), {.shared = record.sharedErrors});
    EXPECT_TRUE(analysis);
    return {std::move(swing.value()), std::move(analysis.value())};
}

/// Figures of a tenth of a degree that are met again and again at the same fraction are out by half of it.
void expectTruth(const Answer& answer, double tolerance_deg, const std::string& what)
{
    const std::array truth{0.8, -3.0, 2.0, 1.2, -0.4};
    for (const auto which : {Coefficient::B, Coefficient::C, Coefficient::D, Coefficient::E})
        EXPECT_NEAR(answer.of(which), truth[indexOf(which)], tolerance_deg) << letterOf(which) << ' ' << what;
    for (const auto which : kCoefficients)
        EXPECT_LE(std::abs(answer.of(which) - truth[indexOf(which)]), 2.0 * answer.errorOf(which) + 0.05) << letterOf(which) << ' ' << what;
}

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

TEST(NmeaTurn, theVariationIsHeldAgainstTheModel)
{
    Flight flight;
    EXPECT_FALSE(answerOf(logOf(flight)).says("apart, and A with them")); // WMM2025 says 14.97° E there
    flight.variationTold_deg = 0.0;
    const auto zero = answerOf(logOf(flight));
    EXPECT_TRUE(zero.says("15.0° apart"));
    EXPECT_GE(zero.errorOf(Coefficient::A), 14.9);
    NmeaOptions model;
    model.variation = VariationOfModel{};
    EXPECT_NEAR(answerOf(logOf(flight), model).of(Coefficient::A), 0.8 + 0.23, 0.05);
    flight.variationTold_deg = -15.2; // E and W mixed up
    EXPECT_TRUE(answerOf(logOf(flight)).says("30.2° apart"));
}

TEST(NmeaTurn, oneZeroBesideARightVariationIsNotTaken)
{
    std::string log;
    for (int i = 0; i < 360; i += 5)
        log += makeNmea(formatted("HCHDG,%d.0,0.0,E,0.0,E", i)) + "\n"
            + makeNmea(formatted("GPRMC,09%02d%02d,A,4736.0,N,12218.0,W,6.0,%.1f,201125,15.2,E,A", i / 60, i % 60, wrap360(i + 15.2)))
            + "\n";
    const auto answer = answerOf(log);
    EXPECT_NEAR(answer.swing.variation->degrees(), 15.2, 1e-9);
    EXPECT_TRUE(answer.says("HCHDG 0.0°, GPRMC +15.2°"));
}

TEST(NmeaTurn, datesThatCannotBeAreDoubtedAloud)
{
    Flight flight;
    const auto dated = [&](const char* date) {
        flight.date = date;
        NmeaOptions stated;
        stated.variation = Variation::fromDegrees(15.2);
        return answerOf(logOf(flight), stated);
    };
    EXPECT_FALSE(dated("201125").says("dated"));
    EXPECT_FALSE(dated("271126").says("dated")); // somewhere it is tomorrow already
    EXPECT_TRUE(dated("060406").says(
        "dated 2006-04-06: a receiver that missed the turn of the GPS week count (1024 weeks) writes so for 2025-11-20"));
    EXPECT_TRUE(dated("210806").says("writes so for 2026-04-06"));
    EXPECT_TRUE(dated("060199").says("writes so for 2018-08-22")); // two turns would be beyond today
    EXPECT_TRUE(dated("060180").says("1980-01-06, a day on which the GPS week count began"));
    EXPECT_TRUE(dated("070419").says("2019-04-07, a day on which the GPS week count began"));
    EXPECT_TRUE(dated("010531").says("dated 2031-05-01, and today is 2026-11-26"));
    NmeaOptions right;
    right.date = "2025-11-20";
    flight.date = "060406";
    const auto answer = answerOf(logOf(flight), right);
    EXPECT_EQ(answer.swing.date, Date("2025-11-20"));
    EXPECT_FALSE(answer.says("week count"));
}

TEST(NmeaTurn, whatIsKnownOfTheVariationWidensA)
{
    NmeaOptions storm;
    storm.variation = Variation::fromDegrees(15.2);
    const Flight both{{{1.0, 400.0}, {-1.0, 400.0}}};
    const double calm = answerOf(logOf(both), storm).errorOf(Coefficient::A);
    EXPECT_LT(calm, 0.05);
    storm.variationError_deg = 1.5;
    const auto answer = answerOf(logOf(both), storm);
    EXPECT_NEAR(answer.errorOf(Coefficient::A), 1.5, 0.01);
    EXPECT_NEAR(answer.errorOf(Coefficient::B), answerOf(logOf(both)).errorOf(Coefficient::B), 1e-9); // A alone
}

TEST(NmeaTurn, aBaseWhoseSurveyIsNotTheModelsWidensA)
{
    Site base;
    base.name = "rose";
    base.latitude_deg = 47.61;
    base.longitude_deg = -122.29;
    for (const double declination : {16.9, 17.0, 17.1})
        base.survey.push_back({0.0, 0.0, 1.0, declination, {}});
    NmeaOptions model;
    model.variation = VariationOfModel{};
    auto answer = answerOf(logOf({{{1.0, 400.0}, {-1.0, 400.0}}}), model);
    const double before = answer.errorOf(Coefficient::A);
    NmeaSwing far = answer.swing;
    base.latitude_deg = 48.6;
    holdAgainstBases(far, model, {&base, 1});
    EXPECT_EQ(far.doubts.size(), answer.swing.doubts.size());
    base.latitude_deg = 47.61;
    holdAgainstBases(answer.swing, model, {&base, 1});
    EXPECT_TRUE(answer.says("the survey of rose has the declination +17.0°"));
    const auto widened = analyse(observationsOf(toSwing(answer.swing)), {.shared = toSwing(answer.swing).sharedErrors});
    EXPECT_NEAR(toDegrees(*widened->approximate.standardError[indexOf(Coefficient::A)]), std::hypot(before, 2.03),
        0.01); // WMM2025 says 14.97° there
}

TEST(NmeaTurn, aTooShortArcInTheWindIsAsUnsureAsTheWind)
{
    const auto answer = answerOf(logOf({{{1.0, 95.0}}, 80.0, 200.0, 15.0}));
    EXPECT_TRUE(answer.says("the tracks do not tell the wind"));
    EXPECT_LE(std::abs(answer.of(Coefficient::A) - 0.8), 3.0 * answer.errorOf(Coefficient::A));
    EXPECT_GE(answer.errorOf(Coefficient::B), 3.0);
    EXPECT_GE(answer.errorOf(Coefficient::C), 3.0);
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

TEST(NmeaTurn, receiversThatMakeItUpAreTold)
{
    const auto ending = [](const std::string& log, const char* mode) {
        std::string other;
        std::istringstream lines(log);
        for (std::string line; std::getline(lines, line);)
            other += (line.find("RMC") == std::string::npos ? line : makeNmea(line.substr(1, line.find('*') - 2) + mode)) + "\n";
        return other;
    };
    EXPECT_TRUE(answerOf(ending(logOf({}), "E")).says("400 estimated tracks or headings (mode E, dead reckoning)"));
    EXPECT_TRUE(answerOf(ending(logOf({}), "S")).says("simulator (mode S)"));
    std::string own;
    for (int i = 0; i < 360; i += 5)
        own += makeNmea(formatted("GPRMC,09%02d%02d,A,4736.0,N,12218.0,W,6.0,%.1f,201125,15.2,E,A", i / 60, i % 60, wrap360(i + 15.2)))
            + "\n" + makeNmea(formatted("HCHDG,%d.0,2.5,W,,", i)) + "\n";
    EXPECT_TRUE(answerOf(own).says("72 HDG sentences with a deviation of their own (up to −2.5°"));
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
