// Deviation from winds: ground velocity from positions, and a fleet held against a control group.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/inflight/SimulatedFleets.h"

using namespace lubberline;
using namespace lubberline::test;

namespace {

/// Reports that stand where the aircraft flew, in steps of so many degrees, and without ground speed and track.
void placeAt(WindReport& report, double step_deg, bool ownWind)
{
    // Positions of the leg by integrating its own ground velocity over five minutes from its first report.
    static thread_local double latitude = 50, longitude = 10, last_s = 0;
    const double passed_s = report.time_s - last_s;
    if (!(passed_s > 0 && passed_s < 400))
        latitude = 50, longitude = 10;
    else {
        const Eigen::Vector2d moved = velocityOf(report.track_deg, report.groundSpeed_kt) * passed_s / 3600; // nautical miles
        latitude += moved.y() / 60.059;                                                                      // at 50°, WGS84
        longitude += moved.x() / (60.226 * std::cos(toRadians(latitude)));
    }
    last_s = report.time_s;
    const auto stepped = [step_deg](double value) { return std::round(value / step_deg) * step_deg; };
    report.latitude_deg = stepped(latitude);
    report.longitude_deg = stepped(longitude);
    report.positionStep_deg = step_deg;
    if (!ownWind) {
        const Eigen::Vector2d air = velocityOf(report.track_deg, report.groundSpeed_kt) - velocityOf(report.windFrom_deg, -report.wind_kt);
        report.heading_deg = directionOf_deg(air);
        report.tas_kt = air.norm();
        report.wind_kt = report.windFrom_deg = kMissing;
    }
    report.groundSpeed_kt = report.track_deg = kMissing;
}

TEST(WindStudy, everyBandOfAltitudeIsToldBeforeAndAfterTheCorrection)
{
    SimulatedAircraft aircraft;
    aircraft.flights = 40;
    int count = 0;
    const WindResult result = studyOf({aircraft}, 7, {}, [&](WindReport& report) {
        switch (count++ % 4) {
        case 0: report.altitude_m = 9500; break;
        case 1: report.altitude_m = 10500; break;
        case 2: report.altitude_m = 30000; break; // in the last band
        default: break;                           // not stated: in the totals alone
        }
    });
    ASSERT_EQ(result.altitudes.size(), 3u);
    EXPECT_EQ(result.altitudes[0].from_m, 9000);
    EXPECT_EQ(result.altitudes[1].from_m, 10000);
    EXPECT_EQ(result.altitudes[2].from_m, 15000);
    const auto& one = result.aircraft[0];
    WindSquares before = one.bands.back().before, after = one.bands.back().after;
    for (const WindBand& band : result.altitudes) {
        EXPECT_EQ(band.before.count, 200);
        EXPECT_EQ(band.after.count, 200);
        // e of √5° rms/√2 at 430 kt stands across the track and goes; what the reference is wrong by stays.
        EXPECT_GT(band.before.rmse().transverse_kt, 10);
        EXPECT_LT(band.after.rmse().transverse_kt, 5);
        EXPECT_NEAR(band.after.rmse().longitudinal_kt, band.before.rmse().longitudinal_kt, 0.5);
        before += band.before;
        after += band.after;
    }
    EXPECT_EQ(before.count, one.used);
    EXPECT_NEAR(before.rmse().total_kt, one.before.total_kt, 1e-9);
    EXPECT_NEAR(after.rmse().total_kt, one.after->total_kt, 1e-9);
}

TEST(WindStudy, aTrackFollowsFromPositions)
{
    SimulatedAircraft aircraft;
    aircraft.flights = 40;
    aircraft.legs = 1; // it flies straight on
    const WindResult exact = studyOf({aircraft}, 31);
    for (const double step_deg : {1e-5, 1e-2}) {
        const WindResult result = studyOf({aircraft}, 31, {}, [step_deg](WindReport& report) { placeAt(report, step_deg, true); });
        const auto& one = result.aircraft[0];
        EXPECT_EQ(one.fromPositions, 40 * 19); // the first of a flight has none before it
        EXPECT_TRUE(says(one.warnings, "is that between positions"));
        // σ = step/√6 a component over five minutes: 0.01° make 2.9 kt.
        EXPECT_NEAR(one.positionError_kt, step_deg * 60 / std::sqrt(6.0) * 12, 0.02 * step_deg * 60 * 12);
        // Beside winds of its own the ground velocity hardly matters: it turns both air velocities alike.
        ASSERT_TRUE(one.fitted);
        EXPECT_NEAR(one.fit.fit.value(1), exact.aircraft[0].fit.fit.value(1), 0.15) << step_deg;
    }
    // Of heading and airspeed it is the error itself.
    const auto fine = studyOf({aircraft}, 31, {}, [](WindReport& report) { placeAt(report, 1e-5, false); });
    const auto coarse = studyOf({aircraft}, 31, {}, [](WindReport& report) { placeAt(report, 5e-2, false); });
    ASSERT_TRUE(fine.aircraft[0].fitted && coarse.aircraft[0].fitted);
    EXPECT_GT(coarse.aircraft[0].before.transverse_kt, fine.aircraft[0].before.transverse_kt + 3);
    EXPECT_LT(std::abs(coarse.aircraft[0].fit.fit.value(1) - 2.0), 4 * coarse.aircraft[0].fit.fit.standardError(1));
}

TEST(WindStudy, aControlGroupTellsTheReferencesError)
{
    std::vector<SimulatedAircraft> fleet;
    for (int i = 0; i < 12; ++i) {
        SimulatedAircraft one;
        one.name = (i < 6 ? "L" : "V") + std::to_string(i);
        one.c_deg = i < 6 ? 0 : 0.5;
        one.a_deg = i < 6 ? 0 : 3;
        one.b_deg = 0;
        one.flights = 30;
        fleet.push_back(one);
    }
    SimulatedReference reference;
    reference.biasEast_kt = 4;
    WindOptions options;
    options.control = "laser gyro";
    options.removeCommon = true;
    const WindResult result = studyOf(
        fleet, 41, reference, [](WindReport& report) { report.group = report.aircraft[0] == 'L' ? "laser gyro" : "flux valve"; }, options);
    ASSERT_EQ(result.groups.size(), 2u);
    EXPECT_EQ(result.groups[0].group, "flux valve");
    EXPECT_EQ(result.groups[0].aircraft, 6);
    ASSERT_TRUE(result.control);
    EXPECT_EQ(result.control->aircraft, 6);
    // Flux valves are across the track further off than what the reference itself is; corrected, no more than it.
    const double norm = result.control->before.rmse().transverse_kt;
    EXPECT_GT(result.groups[0].before.rmse().transverse_kt, 2.5 * norm);
    EXPECT_LT(result.groups[0].after.rmse().transverse_kt, 1.15 * norm);
    // What the laser gyros show is the reference's error, and what is left of the others is their deviation alone.
    ASSERT_TRUE(result.common && result.common->takenOut);
    EXPECT_NEAR(result.common->asWind_kt(), 4, 1.5);
    double mean = 0;
    for (const auto& one : result.aircraft)
        if (one.group == "flux valve")
            mean += one.fit.fit.value(1) / 6;
    EXPECT_NEAR(mean, 3, 0.25);
    EXPECT_TRUE(says(result.warnings, "their headings being right"));
    options.control = "nobody";
    EXPECT_TRUE(says(studyOf(fleet, 41, reference, {}, options).warnings, "to hold the others against"));
}

} // namespace
