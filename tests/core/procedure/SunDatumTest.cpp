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

/// A guided swing by the sun in which the compass has no deviation, and the clock is so many hours fast.
struct SunSwingRead {
    SwingJob job;
    JobState state;
    SunSwingRead(DatumKind kind, int hoursFast, int stations)
    {
        job.datum = shadowPin();
        job.datum.kind = kind;
        state.datum = job.datum;
        for (int i = 0; i < stations; ++i) {
            const auto minute = std::to_string(10 + 5 * i);
            const UtcTime shown = at(("2026-06-01T09:" + minute + ":00Z").c_str()), truth = shown - std::chrono::hours(hoursFast);
            const double heading = 90.0 * i, bearing = sunAt(kWarsaw, truth).azimuth_deg + 180 - heading;
            StationState station;
            station.station.nominal_deg = heading;
            station.reading = Observation{toMagnetic(headingBySun(sunAt(kWarsaw, shown), bearing, true), Variation::fromDegrees(0)),
                CompassHeading::fromDegrees(heading)};
            state.stations.push_back(station);
            job.events.push_back({"2026-06-01T09:" + minute + ":00Z", job::ReadingTaken{i, {}, 0, 0, {}}});
        }
    }
};

TEST(SunDatum, aGuidedSwingSaysThatTheClockIsAnHourWrong)
{
    for (const DatumKind kind : {DatumKind::ShadowPin, DatumKind::Astrocompass}) {
        EXPECT_TRUE(takesSun(kind));
        for (const int hours : {1, -1}) {
            const SunSwingRead read(kind, hours, 4);
            EXPECT_NE(hourDoubt(read.job, read.state, kWarsaw).english().find(hours > 0 ? "hour fast" : "hour slow"), std::string::npos);
        }
        const SunSwingRead right(kind, 0, 4), early(kind, 1, 3);
        EXPECT_TRUE(hourDoubt(right.job, right.state, kWarsaw).empty());
        EXPECT_TRUE(hourDoubt(early.job, early.state, kWarsaw).empty()) << "three headings tell no A";
    }
    const SunSwingRead other(DatumKind::SightingCompass, 1, 4);
    EXPECT_TRUE(hourDoubt(other.job, other.state, kWarsaw).empty());
}

TEST(SunDatum, anAstrocompassShowsTheHeadingItself)
{
    auto astro = shadowPin();
    astro.kind = DatumKind::Astrocompass;
    const auto time = at("2026-06-01T09:00:00Z");
    const auto heading = sunHeading(astro, {{123}, {}, {}}, kWarsaw, time, Variation::fromDegrees(6));
    ASSERT_TRUE(heading);
    EXPECT_NEAR(heading->heading.magnetic.degrees(), 117, 1e-9);
    EXPECT_GT(heading->heading.uncertainty_deg, 0.3);
    EXPECT_FALSE(sunHeading(astro, {{123}, {}, {}}, kWarsaw, at("2026-06-01T23:00:00Z"), Variation::fromDegrees(6)));
    // Noon at Greenwich's meridian: the hour angle is what the equation of time leaves (+2.2 min on 1 June).
    const SunPosition noon = sunAt({52, 0, 0}, at("2026-06-01T12:00:00Z"));
    EXPECT_NEAR(wrap180(noon.hourAngle_deg), 2.2 / 4, 0.05);
}

} // namespace
} // namespace lubberline
