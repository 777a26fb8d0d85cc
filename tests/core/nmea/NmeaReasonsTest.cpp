// Logs that tell little or nothing: the true reason is said, and what cannot be told is not.

#include <gmock/gmock.h>

#include <cstdio>
#include <sstream>

#include "core/nmea/NmeaSentence.h"
#include "core/nmea/NmeaSwing.h"

namespace lubberline {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

struct Turn {
    double compassRate_deg_s = 1.0, trackRate_deg_s = 1.0, speed_kt = 6.0;
    const char* date = "201125";
    const char* variation = "15.2,E";
    const char* ofCompass = ",,,"; ///< deviation and variation of HDG
};

Result<NmeaSwing> swingOf(const Turn& turn)
{
    std::string log;
    char text[160];
    for (int second = 0; second < 300; ++second) {
        std::snprintf(text, sizeof text, "HCHDG,%.2f,%s", 0.1 + turn.compassRate_deg_s * second, turn.ofCompass);
        log += makeNmea(text) + "\r\n";
        std::snprintf(text, sizeof text, "GPRMC,09%02d%02d.00,A,4736.0,N,12218.0,W,%.1f,%.1f,%s,%s,A", second / 60, second % 60,
            turn.speed_kt, turn.trackRate_deg_s * second, turn.date, turn.variation);
        log += makeNmea(text) + "\r\n";
    }
    std::istringstream stream(log);
    return readNmeaSwing(stream, "turn.nmea", {});
}

/// A sensor in radians, a card that sticks: no coefficient, and nothing of what its readings share.
TEST(NmeaReasons, aCompassThatKeepsWithinAFewDegreesTellsNothing)
{
    const auto swing = swingOf({.compassRate_deg_s = 0.02});
    ASSERT_TRUE(swing);
    EXPECT_FALSE(toSwing(*swing).sharedErrors.any());
}

TEST(NmeaReasons, whyNothingIsLeftIsSaid)
{
    const auto slow = swingOf({.speed_kt = 0.4});
    ASSERT_TRUE(slow);
    EXPECT_EQ(slow->used, 0u);
    EXPECT_THAT(inEnglish(slow->warnings), Contains(HasSubstr("never moves faster than 0.4 kt")));
    EXPECT_THAT(inEnglish(slow->warnings), Not(Contains(HasSubstr("too uneven"))));
    EXPECT_THAT(inEnglish(swingOf({})->warnings), Not(Contains(HasSubstr("never moves"))));
}

/// A time, a day and a place that are none are told as they are written, and taken from nowhere: the sentence gets its time by its place.
TEST(NmeaReasons, whatIsNoTimeDayOrPlaceIsTold)
{
    const auto read = [](const char* time, const char* place = "4736.0,N,12218.0,W", const char* date = "201125") {
        std::string log;
        char text[160];
        for (int second = 0; second < 180; ++second) {
            std::snprintf(text, sizeof text, "HCHDG,%.2f,,,,", wrap360(0.1 + 2.0 * second));
            log += makeNmea(text) + "\r\n";
            char right[16];
            std::snprintf(right, sizeof right, "09%02d%02d.00", second / 60, second % 60);
            const bool wrong = second == 90;
            std::snprintf(text, sizeof text, "GPRMC,%s,A,%s,6.0,%.1f,%s,15.2,E,A", wrong ? time : right,
                wrong ? place : "4736.0,N,12218.0,W", wrap360(2.0 * second), wrong ? date : "201125");
            log += makeNmea(text) + "\r\n";
        }
        std::istringstream stream(log);
        return readNmeaSwing(stream, "turn.nmea", {});
    };
    const auto right = read("090130.00");
    ASSERT_TRUE(right);
    EXPECT_THAT(inEnglish(right->warnings), Not(Contains(HasSubstr("left out"))));
    for (const char* time : {"240000.00", "096000.00", "090161.00", "-10000.00", "9:01:30", "0901"}) {
        const auto wrong = read(time);
        ASSERT_TRUE(wrong) << time;
        EXPECT_THAT(
            inEnglish(wrong->warnings), Contains(std::string("1 time left out, no time of the day: '") + time + "'; expected hhmmss"));
        ASSERT_EQ(wrong->pairs.size(), right->pairs.size());
        for (std::size_t i = 0; i < right->pairs.size(); ++i)
            EXPECT_NEAR(wrong->pairs[i].magnetic.degrees(), right->pairs[i].magnetic.degrees(), 0.1) << time << " " << i;
    }
    EXPECT_THAT(
        inEnglish(read("090130.00", "9536.0,N,12218.0,W")->warnings), Contains(HasSubstr("place on the Earth: '9536.0,N,12218.0,W'")));
    EXPECT_THAT(inEnglish(read("090130.00", "4760.0,N,12218.0,W")->warnings), Contains(HasSubstr("1 position left out")));
    EXPECT_THAT(inEnglish(read("090130.00", "4736.0,N,12218.0,W", "311125")->warnings),
        Contains(HasSubstr("1 date left out, no day of the calendar: '311125'")));
}

/// An instrument that says that it has no heading (THS, mode V) is not one that is missing.
TEST(NmeaReasons, aTrueHeadingThatIsNotValidIsNamed)
{
    const auto read = [](const char* mode, int valid) {
        std::string log;
        char text[80];
        for (int second = 0; second < 60; ++second) {
            std::snprintf(text, sizeof text, "HCHDG,%d.0,,,,", 10 + second);
            log += makeNmea(text) + "\r\n";
            std::snprintf(text, sizeof text, "GPTHS,%d.0,%s", 25 + second, second < valid ? "A" : mode);
            log += makeNmea(text) + "\r\n";
        }
        std::istringstream stream(log);
        return readNmeaSwing(stream, "ths.nmea", {.reference = NmeaReference::HeadingTrue, .variation = Variation::fromDegrees(15.0)});
    };
    const auto none = read("V", 0), some = read("V", 40);
    ASSERT_FALSE(none);
    EXPECT_THAT(none.error().message.english(), HasSubstr("says so in all 60 of its THS (mode V)"));
    ASSERT_TRUE(some);
    EXPECT_EQ(some->used, 40u);
    EXPECT_THAT(inEnglish(some->warnings), Contains(HasSubstr("20 times the true heading was not valid")));
}

/// A receiver with a fix every other second, or one in three: the turn is seen all the same, and what a delay costs A is stated.
TEST(NmeaReasons, holesInTheReferenceDoNotHideTheTurn)
{
    for (const int every : {2, 3}) {
        std::string log;
        char text[120];
        for (int second = 0; second < 360; ++second) {
            std::snprintf(text, sizeof text, "HCHDG,%d.0,,,,", second);
            log += makeNmea(text) + "\r\n";
            const bool fix = second % every == 0;
            std::snprintf(text, sizeof text, "GPRMC,09%02d%02d.00,%s,4736.0,N,12218.0,W,6.0,%.1f,201125,15.2,E", second / 60, second % 60,
                fix ? "A" : "V", wrap360(second + 17.2));
            log += makeNmea(text) + "\r\n";
        }
        std::istringstream stream(log);
        const auto swing = readNmeaSwing(stream, "holes.nmea", {});
        ASSERT_TRUE(swing) << every;
        EXPECT_EQ(swing->delay.told, DelayTold::OneWay) << every;
        EXPECT_NEAR(swing->delay.A_degPerSecond, -1.0, 0.02) << every;
        EXPECT_GT(swing->delay.clockwise, 100) << every;
        EXPECT_GE(toSwing(*swing).sharedErrors.of_deg[0], 0.99) << every;
    }
}

/// "-15.2,W" may be 15.2° west, written twice, or 15.2° east: neither is taken, and that is said.
TEST(NmeaReasons, aVariationWithASignAndASideIsToldAndNotTaken)
{
    for (const char* written : {"-15.2,W", "-15.2,E", "15.2,", "15.2,X", "abc,E", "215.2,E", "15.2,w"}) {
        const auto swing = swingOf({.variation = written});
        ASSERT_TRUE(swing) << written;
        EXPECT_NE(swing->variationSource, "log") << written;
        EXPECT_THAT(inEnglish(swing->warnings),
            Contains(HasSubstr("300 variations or deviations left out, written without a side as '" + std::string(written) + "'")));
    }
    const auto ofCompass = swingOf({.variation = ",", .ofCompass = "2.0,W,-3,E"});
    ASSERT_TRUE(ofCompass);
    EXPECT_THAT(inEnglish(ofCompass->warnings), Contains(HasSubstr("as '-3,E'")));
    EXPECT_THAT(inEnglish(swingOf({})->warnings), Not(Contains(HasSubstr("without a side"))));
    EXPECT_THAT(inEnglish(swingOf({.variation = ","})->warnings), Not(Contains(HasSubstr("without a side"))));
}

TEST(NmeaReasons, aVariationThatNoModelCanCheckIsSaid)
{
    const auto undated = swingOf({.date = "320125"}); // no day of any month
    ASSERT_TRUE(undated);
    EXPECT_THAT(inEnglish(undated->warnings), Contains(HasSubstr("held against no model")));
    EXPECT_TRUE(toSwing(*undated).sharedErrors.of_deg[0] >= 0.5);
    EXPECT_THAT(inEnglish(swingOf({})->warnings), Not(Contains(HasSubstr("held against no model"))));
}

/// What the log says of its own certainty is what the swing that was made of it says.
TEST(NmeaReasons, aTurnOneWayLeavesAUnsureInTheRecord)
{
    const auto swing = swingOf({});
    ASSERT_TRUE(swing);
    const Swing record = toSwing(*swing);
    EXPECT_GE(record.sharedErrors.of_deg[0], swing->delay.standardError_s * 0.9);
    EXPECT_THAT(record.note, HasSubstr("cannot be told apart"));
}

} // namespace
} // namespace lubberline
