// The sun's azimuth against NREL's Solar Position Algorithm (Reda and Andreas, Solar Energy 76, 2004, ±0.0003°): its published example,
// its web service, and an independent port's printed answers; and Meeus's example of the sun's place.

#include <gtest/gtest.h>

#include "core/angle/Angle.h"
#include "core/reference/Sun.h"

namespace lubberline {
namespace {

UtcTime at(const char* iso) { return readUtcTime(iso).value(); }

struct Almanac {
    const char* time;
    double latitude, longitude, azimuth, elevation;
};

TEST(Sun, azimuthWithin0_02)
{
    for (const Almanac& row : {Almanac{"2003-10-17T19:30:30Z", 39.742476, -105.1786, 194.340241, 39.88838}, // of the paper
             {"1953-05-29T05:45:00Z", 27.9881, 86.9253, 137.736768, 81.518730}, // of the port, with the sun high
             {"2025-01-08T05:36:30.837Z", 51.48, 0, 98.688085, -21.801371},
             {"2020-01-01T00:00:00Z", 39.743, -105.178, 242.384141, -3.213247}, // of the service
             {"2020-01-01T02:00:00Z", 39.743, -105.178, 259.940156, -24.963418},
             {"2020-01-01T05:00:00Z", 39.743, -105.178, 293.250027, -58.973980}}) {
        const auto sun = sunAt({row.latitude, row.longitude, 0}, at(row.time));
        EXPECT_NEAR(wrap180(sun.azimuth_deg - row.azimuth), 0, 0.02) << row.time;
        EXPECT_NEAR(sun.elevation_deg, row.elevation, 0.02)
            << row.time; // theirs is topocentric (0.0024°), that of the paper refracted, too (0.016°)
    }
}

TEST(Sun, declinationOfMeeusExample)
{
    // Astronomical Algorithms, example 25.b: 1992 October 13.0 TD (59 s before in UT): declination −7.783872°.
    EXPECT_NEAR(sunAt({0, 0, 0}, at("1992-10-12T23:59:01Z")).declination_deg, -7.783872, 0.001);
}

/// Solstices and equinoxes of the Astronomical Almanac: the declination turns, or crosses the equator.
TEST(Sun, seasonsFrom1950To2050)
{
    EXPECT_NEAR(sunAt({0, 0, 0}, at("2000-03-20T07:35:00Z")).declination_deg, 0, 0.001);
    EXPECT_NEAR(sunAt({0, 0, 0}, at("2024-03-20T03:06:00Z")).declination_deg, 0, 0.001);
    EXPECT_NEAR(sunAt({0, 0, 0}, at("2024-09-22T12:44:00Z")).declination_deg, 0, 0.001);
    EXPECT_NEAR(sunAt({0, 0, 0}, at("2000-06-21T01:48:00Z")).declination_deg, 23.438, 0.001);
}

TEST(Sun, rateAndShadow)
{
    const Place warsaw{52.2, 21, 0};
    const auto noon = sunAt(warsaw, at("2026-06-21T10:38:00Z"));
    EXPECT_NEAR(noon.azimuth_deg, 180, 1);
    EXPECT_GT(noon.azimuthRate_deg_min, 0.4); // near noon in summer
    EXPECT_NEAR(noon.shadowRatio, std::tan(toRadians(90 - noon.elevation_deg)), 1e-9);
    // The azimuth moves by its rate.
    const auto later = sunAt(warsaw, at("2026-06-21T10:39:00Z"));
    EXPECT_NEAR(later.azimuth_deg - noon.azimuth_deg, (noon.azimuthRate_deg_min + later.azimuthRate_deg_min) / 2, 1e-4);
    EXPECT_EQ(sunAt(warsaw, at("2026-06-21T23:00:00Z")).shadowRatio, 0);
}

TEST(Sun, whatItCannotTellIsSaid)
{
    const auto doubts = [](const Place& place, const char* time) {
        const auto sun = sunAt(place, at(time));
        return doubtsOf(sun, at(time), sunBudget(place, at(time), {}));
    };
    EXPECT_TRUE(doubts({52, 21, 0}, "2026-06-21T08:00:00Z").warnings.empty());
    const auto night = doubts({52, 21, 0}, "2026-12-21T22:00:00Z");
    EXPECT_TRUE(night.none);
    EXPECT_NE(night.warnings.at(0).english().find("below the horizon"), std::string::npos);
    const auto overhead = doubts({23.4, 0, 0}, "2026-06-21T12:02:00Z");
    EXPECT_FALSE(overhead.none);
    EXPECT_NE(overhead.warnings.at(0).english().find("tells little"), std::string::npos);
    EXPECT_FALSE(doubts({52, 21, 0}, "1900-06-21T08:00:00Z").warnings.empty());
    for (const double pole : {-90.0, 90.0})
        EXPECT_TRUE(std::isfinite(sunBudget({pole, 0, 0}, at("2026-06-21T08:00:00Z"), {}).total_deg()));
}

TEST(Sun, times)
{
    EXPECT_EQ(at("2026-06-21T13:30:00+02:00"), at("2026-06-21T11:30Z"));
    EXPECT_EQ(at("2026-06-21 11:30:00.500Z") - at("2026-06-21T11:30Z"), std::chrono::milliseconds(500));
    EXPECT_NEAR(daysSince2000(at("2000-01-01T12:00Z")), 0, 1e-12);
    for (const char* bad : {"2026-06-21T11:30", "2026-06-21", "2026-06-21T25:00Z", "2026-02-30T10:00Z", "noon", "2026-06-21T11:30:61Z",
             "2026-06-21T11:30Zx", "2026-06-21T11:30+2"})
        EXPECT_FALSE(readUtcTime(bad)) << bad;
    EXPECT_NE(describe(readUtcTime("2026-06-21T11:30").error()).find("offset"), std::string::npos);
}

} // namespace
} // namespace lubberline
