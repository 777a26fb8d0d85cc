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
