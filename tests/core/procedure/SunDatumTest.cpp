// The sun as a datum: shadow pins, nights, and clocks that are an hour wrong.

#include <gtest/gtest.h>

#include <cmath>

#include "core/earth/FieldModel.h"
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
    EXPECT_NE(sunDoubt(kWarsaw, times, hour + 0.5).english().find("hour fast"), std::string::npos);
    EXPECT_NE(sunDoubt(kWarsaw, times, hourInA_deg(kWarsaw, times, -1)).english().find("hour slow"), std::string::npos);
    EXPECT_TRUE(sunDoubt(kWarsaw, times, 1).empty());
    EXPECT_TRUE(sunDoubt(kWarsaw, {}, 15).empty());
    // A shadow lies opposite the sun; and 21 west for 21 east is some three hours of sun.
    EXPECT_NE(sunDoubt(kWarsaw, times, -178).english().find("those of its shadow"), std::string::npos);
    Place west = kWarsaw;
    west.longitude_deg = -kWarsaw.longitude_deg;
    double wrong_deg = 0;
    for (const UtcTime time : times)
        wrong_deg += (sunAt(west, time).azimuth_deg - sunAt(kWarsaw, time).azimuth_deg) / 2;
    EXPECT_NE(sunDoubt(west, times, wrong_deg + 1).english().find("a longitude of the other sign"), std::string::npos);
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
            EXPECT_NE(sunDoubt(read.job, read.state, kWarsaw).english().find(hours > 0 ? "hour fast" : "hour slow"), std::string::npos);
        }
        const SunSwingRead right(kind, 0, 4), early(kind, 1, 3);
        EXPECT_TRUE(sunDoubt(right.job, right.state, kWarsaw).empty());
        EXPECT_TRUE(sunDoubt(early.job, early.state, kWarsaw).empty()) << "three headings tell no A";
    }
    const SunSwingRead other(DatumKind::SightingCompass, 1, 4);
    EXPECT_TRUE(sunDoubt(other.job, other.state, kWarsaw).empty());
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

/// Eight headings of a swing by the sun, a reading every two minutes.
std::vector<TakenHeading> takenAllRound()
{
    std::vector<TakenHeading> taken;
    for (int i = 0; i < 8; ++i)
        taken.push_back({TrueHeading::fromDegrees(45.0 * i), CompassHeading::fromDegrees(45.0 * i),
            at("2026-06-01T09:00:00Z") + std::chrono::minutes(2 * i)});
    return taken;
}

TEST(SunDatum, whatAllHeadingsShareIsInTheCoefficients)
{
    const auto taken = takenAllRound();
    const auto middle = sunAt(kWarsaw, at("2026-06-01T09:07:00Z"));
    // The clock turns every heading alike: 30 s of it are half of what a minute is worth, and in A alone.
    const auto clock = sharedBySun(kWarsaw, taken, {30, 0, 0, 0.25}, 0).of_deg;
    EXPECT_NEAR(clock[0], middle.azimuthRate_deg_min / 2, 0.01);
    for (int c = 1; c < 5; ++c)
        EXPECT_LT(clock[static_cast<std::size_t>(c)], 0.01);
    // The model's variation, too, and squares add.
    const auto both = sharedBySun(kWarsaw, taken, {30, 0, 0, 0.25}, 0.36).of_deg;
    EXPECT_NEAR(both[0], std::hypot(clock[0], 0.36), 2e-4);
    // A pin that leans by 1° turns a heading by up to tan(elevation): once a turn, so B and C, and A not at all.
    const auto lean = sharedBySun(kWarsaw, taken, {0, 0, 1, 0.25}, 0).of_deg;
    const double turned = std::tan(toRadians(middle.elevation_deg));
    EXPECT_NEAR(lean[1], turned, 0.03);
    EXPECT_NEAR(lean[2], turned, 0.03);
    for (const std::size_t c : {0u, 3u, 4u})
        EXPECT_LT(lean[c], 0.04);
    // Without the sun and of magnetic headings there is nothing to share; two headings tell no coefficient.
    auto others = taken;
    for (TakenHeading& one : others)
        one.bySun.reset(), one.fromTrue = false;
    EXPECT_FALSE(sharedBySun(kWarsaw, others, {30, 1, 1, 0.25}, 0.36).any());
    EXPECT_FALSE(sharedBySun(kWarsaw, std::span(taken).first(2), {30, 1, 1, 0.25}, 0.36).any());
}

TEST(SunDatum, aGuidedSwingKeepsWhatTheSunLeavesOpen)
{
    SwingJob job;
    job.datum = shadowPin();
    Swing swing;
    swing.date = Date("2026-06-01");
    swing.variation_deg = 0; // not the model's
    for (int i = 0; i < 8; ++i) {
        const std::string time = "2026-06-01T09:0" + std::to_string(i) + ":00Z";
        job.events.push_back({time, job::ReadingTaken{i, {}, 0, 0, {}}});
        Reading reading;
        reading.magnetic = MagneticHeading::fromDegrees(45.0 * i);
        reading.compass = CompassHeading::fromDegrees(45.0 * i);
        reading.timeUtc = time;
        swing.readings.push_back(reading);
    }
    const SharedErrors stated = sharedErrorsOf(job, swing, kWarsaw);
    EXPECT_LT(stated.of_deg[0], 0.05);
    EXPECT_GT(stated.of_deg[1], 0.25); // plumb 0.25° with the sun beyond 45°
    const auto model = defaultFieldModel(yearOf(swing.date));
    swing.variation_deg = model->evaluate(kWarsaw, yearOf(swing.date))->field.variation().degrees();
    const SharedErrors ofModel = sharedErrorsOf(job, swing, kWarsaw);
    EXPECT_GT(ofModel.of_deg[0], 0.3);
    EXPECT_LT(ofModel.of_deg[0], 0.5);
    // From the fourth reading on by a sighting compass: half of it is the sun's.
    auto sighting = shadowPin();
    sighting.kind = DatumKind::SightingCompass;
    job.events.insert(job.events.begin() + 4, {"2026-06-01T09:03:30Z", job::DatumChanged{sighting}});
    const SharedErrors mixed = sharedErrorsOf(job, swing, kWarsaw);
    EXPECT_GT(mixed.of_deg[0], 0.1);
    EXPECT_LT(mixed.of_deg[0], ofModel.of_deg[0]);
    job.datum = sighting;
    EXPECT_FALSE(sharedErrorsOf(job, swing, kWarsaw).any());
}

/// Eight readings all around, four minutes apart, by an instrument of that kind.
std::pair<SwingJob, Swing> carriedBy(DatumKind kind, double figure_deg)
{
    std::pair<SwingJob, Swing> made;
    auto& [job, swing] = made;
    job.datum = shadowPin();
    job.datum.kind = kind;
    job.datum.givesTrue = false;
    for (int i = 0; i < 8; ++i) {
        const std::string time = "2026-06-01T09:" + std::to_string(10 + 4 * i) + ":00Z";
        job.events.push_back({time, job::ReadingTaken{i, {{figure_deg}, {}, {}}, 0, 0, {}}});
        Reading reading;
        reading.magnetic = MagneticHeading::fromDegrees(45.0 * i);
        reading.compass = CompassHeading::fromDegrees(45.0 * i);
        reading.timeUtc = time;
        swing.readings.push_back(reading);
    }
    return made;
}

TEST(DatumErrors, aRunwayIsNoSurerThanItsPublishedDirection)
{
    const auto [job, swing] = carriedBy(DatumKind::Runway, 273);
    const auto surveyed = sharedErrorsOf(job, swing, {}).of_deg;
    EXPECT_NEAR(surveyed[0], 0.1, 1e-9);
    for (const std::size_t c : {1u, 2u, 3u, 4u})
        EXPECT_NEAR(surveyed[c], 0, 1e-9);
    const auto [designated, byDesignator] = carriedBy(DatumKind::Runway, 270);
    EXPECT_NEAR(sharedErrorsOf(designated, byDesignator, {}).of_deg[0], 3, 1e-9);
    auto trueOne = job;
    trueOne.datum.givesTrue = true; // with the variation's error, where that is the model's
    Swing atWarsaw = swing;
    atWarsaw.date = Date("2026-06-01");
    atWarsaw.variation_deg
        = defaultFieldModel(yearOf(atWarsaw.date))->evaluate(kWarsaw, yearOf(atWarsaw.date))->field.variation().degrees();
    EXPECT_GT(sharedErrorsOf(trueOne, atWarsaw, kWarsaw).of_deg[0], 0.3);
    EXPECT_NEAR(sharedErrorsOf(job, atWarsaw, kWarsaw).of_deg[0], 0.1, 1e-9);
    const auto [rose, byRose] = carriedBy(DatumKind::RoseLine, 270);
    EXPECT_FALSE(sharedErrorsOf(rose, byRose, {}).any());
}

TEST(DatumErrors, aTransferGyroDriftsSinceItWasSet)
{
    auto [job, swing] = carriedBy(DatumKind::TransferGyro, 273);
    const double A = sharedErrorsOf(job, swing, {}).of_deg[0];
    // Set ten minutes before the first; the readings lie 0 … 28 min after it: 0.5°/h over 24 min, and 0.05° of the setting.
    EXPECT_NEAR(A, std::hypot(0.5 * 24 / 60, 0.05), 0.01);
    // Set anew after the fourth: it has drifted for less.
    job.events.insert(job.events.begin() + 4, {"2026-06-01T09:24:00Z", job::DatumChanged{job.datum}});
    EXPECT_NEAR(sharedErrorsOf(job, swing, {}).of_deg[0], std::hypot(0.5 * 16 / 60, 0.05), 0.01);
}

} // namespace
} // namespace lubberline
