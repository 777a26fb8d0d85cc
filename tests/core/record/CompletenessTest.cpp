// What keeps a swing from being completed.

#include <gtest/gtest.h>

#include "core/record/Completeness.h"

namespace lubberline {
namespace {

Swing ofCardinals(Date date)
{
    Swing swing;
    swing.date = date;
    for (const double heading : {0.0, 90.0, 180.0, 270.0}) {
        Reading reading;
        reading.magnetic = MagneticHeading::fromDegrees(heading);
        reading.compass = CompassHeading::fromDegrees(heading + 1.0);
        swing.readings.push_back(reading);
    }
    return swing;
}

TEST(Completeness, aSwingIsOfADayThatWas)
{
    EXPECT_TRUE(missingIn(ofCardinals("2026-11-26"), "2026-11-26").empty());
    EXPECT_TRUE(missingIn(ofCardinals("2026-11-27"), "2026-11-26").empty()); // dates are UTC: in the east it is tomorrow already
    EXPECT_TRUE(missingIn(ofCardinals("2027-01-01"), "2026-12-31").empty());
    EXPECT_FALSE(missingIn(ofCardinals("2026-11-28"), "2026-11-26").empty());
    EXPECT_EQ(missingIn(ofCardinals("2031-05-01"), "2026-11-26").english(),
        "its date 2031-05-01 is still to come (today is 2026-11-26); expected the day on which it was swung");
    EXPECT_FALSE(missingIn(ofCardinals(""), "2026-11-26").empty());
}

/// What a receiver without a fix, one that missed the turn of its week count, a computer and a spreadsheet write.
TEST(Completeness, aDayOfAClockThatDoesNotKnowTheDateIsDoubted)
{
    for (const Date date :
        {Date("1980-01-06"), Date("1999-08-22"), Date("2019-04-07"), Date("1970-01-01"), Date("1899-12-30"), Date("1904-01-01")})
        EXPECT_NE(missingIn(ofCardinals(date), "2026-11-28").english().find("do not know the day"), std::string::npos) << date.text();
    for (const Date date : {Date("1980-01-07"), Date("1999-08-23"), Date("2019-04-06"), Date("2012-05-04"), Date("1943-06-01")})
        EXPECT_TRUE(missingIn(ofCardinals(date), "2026-11-28").empty()) << date.text();
    EXPECT_TRUE(missingIn(ofCardinals("2019-04-07"), "2019-04-07").empty()); // on that day it is right
    // 1024 weeks before today, of a draft that is some days old, and in the east tomorrow.
    EXPECT_EQ(missingIn(ofCardinals("2007-04-14"), "2026-11-28").english(),
        "its date 2007-04-14 is what a receiver that missed the turn of the GPS week count (1024 weeks) writes for 2026-11-28; expected the day "
        "on which it was swung");
    EXPECT_FALSE(missingIn(ofCardinals("2007-04-10"), "2026-11-28").empty());
    EXPECT_FALSE(missingIn(ofCardinals("2007-04-15"), "2026-11-28").empty());
    EXPECT_FALSE(missingIn(ofCardinals("1987-08-29"), "2026-11-28").empty()); // twice
    EXPECT_TRUE(missingIn(ofCardinals("2007-04-16"), "2026-11-28").empty());
    EXPECT_TRUE(missingIn(ofCardinals("2007-04-01"), "2026-11-28").empty());
}

TEST(Completeness, fourReadingsThatCount)
{
    Swing swing = ofCardinals("2026-11-26");
    swing.readings.back().compass.reset();
    EXPECT_EQ(missingIn(swing, "2026-11-26").english(), "reading 4 has no compass heading; fill it in or exclude it with a reason");
    swing.readings.pop_back();
    EXPECT_NE(missingIn(swing, "2026-11-26").english().find("expected at least 4"), std::string::npos);
}

} // namespace
} // namespace lubberline
