// The sun as a datum: shadow pins, nights, and clocks that are an hour wrong.

#include <gtest/gtest.h>

#include "core/procedure/SunDatum.h"

namespace lubberline {
namespace {

const Place kWarsaw{52, 21, 0};
UtcTime at(const char* iso) { return readUtcTime(iso).value(); }

DatumInstrument shadowPin()
{
    DatumInstrument pin;
    pin.name = "shadow pin";
    pin.kind = DatumKind::ShadowPin;
    pin.resolution_deg = 0.5;
    return pin;
}

TEST(SunDatum, theShadowAheadMeansAwayFromTheSun)
{
    const auto time = at("2026-06-01T09:00:00Z");
    const double azimuth = sunAt(kWarsaw, time).azimuth_deg;
    EXPECT_TRUE(needsSun(DatumKind::ShadowPin));
    EXPECT_FALSE(needsSun(DatumKind::Runway));
    const auto ahead = sunHeading(shadowPin(), {{0}, {}, {}}, kWarsaw, time, Variation::fromDegrees(6));
    ASSERT_TRUE(ahead);
    EXPECT_NEAR(ahead->heading.magnetic.degrees(), wrap360(azimuth + 180 - 6), 1e-9);
    EXPECT_GT(ahead->heading.uncertainty_deg, 0.3); // plumb and pointing beside the division
    // The shadow off the starboard wing: the nose is 90° less.
    const auto wing = sunHeading(shadowPin(), {{90, 90.4}, {}, {}}, kWarsaw, time, Variation::fromDegrees(6));
    EXPECT_NEAR(wrap180(wing->heading.magnetic.degrees() - ahead->heading.magnetic.degrees()), -90.2, 1e-9);
    EXPECT_NEAR(headingBySun(sunAt(kWarsaw, time), 30, false).degrees(), azimuth - 30, 1e-9);
    EXPECT_FALSE(sunHeading(shadowPin(), {{0}, {}, {}}, kWarsaw, time, {}));
    EXPECT_FALSE(sunHeading(shadowPin(), {{}, {}, {}}, kWarsaw, time, Variation::fromDegrees(6)));
    const auto night = sunHeading(shadowPin(), {{0}, {}, {}}, kWarsaw, at("2026-06-01T23:00:00Z"), Variation::fromDegrees(6));
    ASSERT_FALSE(night);
    EXPECT_NE(describe(night.error()).find("below the horizon"), std::string::npos);
}

TEST(SunDatum, anHourWrongShowsInA)
{
    const std::vector<UtcTime> times{at("2026-06-01T09:00:00Z"), at("2026-06-01T09:20:00Z")};
    const double hour = hourInA_deg(kWarsaw, times);
    EXPECT_GT(hour, 10);
    EXPECT_LT(hour, 30);
    EXPECT_NE(hourDoubt(kWarsaw, times, hour + 0.5).english().find("hour fast"), std::string::npos);
    EXPECT_NE(hourDoubt(kWarsaw, times, hourInA_deg(kWarsaw, times, -1)).english().find("hour slow"), std::string::npos);
    EXPECT_TRUE(hourDoubt(kWarsaw, times, 1).empty());
    EXPECT_TRUE(hourDoubt(kWarsaw, {}, 15).empty());
}

} // namespace
} // namespace lubberline
