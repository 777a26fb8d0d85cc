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

/// Another source's figures, the years between: XEphem's libastro 3.7 (VSOP87, apparent, topocentric, without refraction).
TEST(Sun, azimuthWithin0_02From1950To2050)
{
    for (const Almanac& row : {Almanac{"1950-07-08T14:00:00Z", -19.387, -7.027, 332.0718, 43.0202},
             {"1955-06-04T22:05:00Z", 46.197, -154.479, 173.6730, 66.1216}, {"1960-02-04T20:09:00Z", -36.551, -92.001, 303.3692, 58.8517},
             {"1965-07-06T11:42:00Z", -13.49, 0.492, 8.0138, 53.4674}, {"1970-05-21T00:24:00Z", 14.955, -106.787, 287.3840, 14.1513},
             {"1975-03-03T14:05:00Z", -41.501, -22.94, 350.7867, 55.0992}, {"1985-01-06T23:56:00Z", 21.23, -166.958, 193.8407, 45.1731},
             {"1990-05-09T09:41:00Z", 59.325, 42.082, 191.6848, 47.5833}, {"2000-07-03T22:16:00Z", 69.216, 109.199, 74.3232, 18.5715},
             {"2005-05-14T10:44:00Z", 61.251, 116.638, 286.5236, 12.3204}, {"2015-09-07T19:15:00Z", -66.052, -145.306, 36.9935, 13.3756},
             {"2030-10-26T13:36:00Z", -50.075, -92.196, 78.0282, 26.0843}, {"2035-06-22T19:41:00Z", 3.654, -122.783, 20.7891, 68.7478},
             {"2045-06-11T18:19:00Z", 69.623, -71.034, 209.5980, 41.4138}, {"2050-10-15T14:07:00Z", -43.225, -43.213, 13.6217, 54.8138}}) {
        const auto sun = sunAt({row.latitude, row.longitude, 0}, at(row.time));
        EXPECT_NEAR(wrap180(sun.azimuth_deg - row.azimuth), 0, 0.006) << row.time;
        EXPECT_NEAR(sun.elevation_deg, row.elevation, 0.006) << row.time;
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
    EXPECT_NE(doubts({90, 0, 0}, "2026-06-21T08:00:00Z").warnings.at(0).english().find("tells little"), std::string::npos);
    // At the pole a kilometre is any meridian: 360°/√12.
    const auto ofPosition = [](double latitude_deg, double km) {
        SunSighting sighting;
        sighting.position_km = km;
        return sunShares({latitude_deg, 0, 0}, at("2026-06-21T12:00:00Z"), sighting).position_deg;
    };
    for (const double pole : {-90.0, 90.0})
        EXPECT_NEAR(ofPosition(pole, 1), 103.9, 0.5) << pole;
    EXPECT_NEAR(ofPosition(89.9, 1), toDegrees(1 / (0.1 * 111.2)), 0.1); // a kilometre across at 11 km from the pole
    EXPECT_NEAR(ofPosition(89.99, 5), 103.9, 0.5);
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
