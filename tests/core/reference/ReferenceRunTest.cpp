// Scenarios as a whole: shares, slaving, the aircraft's own deviation, cut-offs and limits, cards in liquid, and scenarios of nothing.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "core/angle/Angle.h"
#include "core/reference/DirectionalGyro.h"
#include "core/reference/ReferenceRun.h"
#include "core/sensor/SensorReading.h"

namespace lubberline {
namespace {

const LongSeries<double>& shareOf(const ReferenceRun& run, ErrorSource source)
{
    for (const auto& share : run.shares)
        if (share.source == source)
            return share.error_rad;
    ADD_FAILURE() << "no such share";
    return run.headingError_rad;
}

SensorModel someIron()
{
    SensorModel model;
    model.hardIron_nT = {800, -500, 300};
    model.softIron(0, 2) = 0.02;
    return model;
}

Scenario flight()
{
    Scenario scenario;
    scenario.latitude_deg = 52;
    scenario.dip_deg = 67;
    scenario.speed_m_s = 60;
    scenario.step_s = 0.1;
    scenario.duration_s = 600;
    scenario.manoeuvres = {{60, 120, 3, 0, 0}, {180, 210, 0, 1, 0}, {240, 300, 0, 0, 5}};
    scenario.gusts = Gusts{0.3, 12, 7, false};
    scenario.vertical = VerticalGyro{};
    scenario.gyro = HeadingGyro{};
    scenario.gyro->drift_deg_h = 3;
    scenario.gyro->apparentDrift = true;
    scenario.gyro->slavingTau_s = 60;
    scenario.gyro->outerAxisTilt_deg = 2;
    scenario.compass.model = someIron();
    scenario.compass.horizontal_nT = 18700;
    return scenario;
}

double rms(std::span<const double> values)
{
    double sum = 0;
    for (const double value : values)
        sum += value * value;
    return std::sqrt(sum / static_cast<double>(values.size()));
}

TEST(ReferenceRun, aShareIsTheRunWithAllLessTheRunWithoutIt)
{
    const Scenario scenario = flight();
    const auto run = runScenario(scenario);
    ASSERT_TRUE(run);
    EXPECT_EQ(run->shares.size(), 6u);
    std::vector<double> sum(run->time_s.size(), 0.0);
    for (const auto& share : run->shares)
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] += share.error_rad[i];
    for (std::size_t i = 0; i < sum.size(); ++i)
        ASSERT_NEAR(sum[i], run->headingError_rad[i], 1e-12);
    const auto without = [&](auto change, ErrorSource source) {
        Scenario changed = scenario;
        change(changed);
        const auto other = runScenario(changed);
        ASSERT_TRUE(other);
        const auto& share = shareOf(*run, source);
        EXPECT_GT(rms(share), 1e-5);
        for (std::size_t i = 0; i < share.size(); i += 7)
            ASSERT_NEAR(share[i], run->headingError_rad[i] - other->headingError_rad[i], 1e-12);
    };
    without([](Scenario& s) { s.compass.model.reset(); }, ErrorSource::OwnDeviation);
    without([](Scenario& s) { s.gyro->slavingTau_s.reset(); }, ErrorSource::Slaving);
    without(
        [](Scenario& s) {
            s.gyro->drift_deg_h = 0;
            s.gyro->apparentDrift = false;
        },
        ErrorSource::Drift);
}

/// Without dynamics and level, the sensor reads what core/sensor says of the aircraft's iron.
TEST(ReferenceRun, theAircraftsOwnDeviation)
{
    Scenario scenario;
    scenario.dip_deg = 67;
    scenario.duration_s = 120;
    scenario.step_s = 1;
    scenario.manoeuvres = {{0, 120, 3, 0, 0}}; // standing still it turns without bank
    scenario.compass.model = someIron();
    scenario.compass.horizontal_nT = 18700;
    const auto run = runScenario(scenario);
    ASSERT_TRUE(run);
    for (std::size_t i = 0; i < run->time_s.size(); ++i) {
        const auto field = MeridianField::fromDip(18700, toRadians(67));
        const auto reading = readSensor(someIron(), field, {MagneticHeading::fromRadians(run->heading_rad[i]), 0, 0});
        ASSERT_NEAR(toDegrees(run->headingError_rad[i]), -reading.deviation->degrees(), 1e-9);
    }
}

TEST(ReferenceRun, needleInARateOneTurn)
{
    Scenario scenario;
    scenario.dip_deg = 67;
    scenario.speed_m_s = 120 * 1852 / 3600.0;
    scenario.duration_s = 120;
    scenario.step_s = 0.5;
    scenario.manoeuvres = {{0, 120, 3, 0, 0}};
    scenario.compass.type = CompassType::Needle;
    const auto run = runScenario(scenario);
    ASSERT_TRUE(run);
    for (const auto& [second, error] : {std::pair{0, -36.408}, {15, -50.325}, {30, 0.0}, {60, 36.408}, {75, 18.351}, {105, -18.351}})
        EXPECT_NEAR(toDegrees(run->headingError_rad[static_cast<std::size_t>(second) * 2]), error, 6e-4) << second;
}

TEST(ReferenceRun, slavedStandoffAndTurnReduction)
{
    Scenario scenario = flight();
    scenario.gusts.reset();
    scenario.manoeuvres.clear();
    scenario.compass.model.reset();
    scenario.vertical.reset();
    scenario.speed_m_s = 0;
    scenario.duration_s = 3000;
    scenario.gyro->drift_deg_h = 0.5;
    scenario.gyro->apparentDrift = false;
    scenario.gyro->slavingTau_s = 147.13;
    scenario.gyro->outerAxisTilt_deg = 0;
    const auto run = runScenario(scenario);
    ASSERT_TRUE(run);
    EXPECT_NEAR(toDegrees(run->headingError_rad.back()), 0.0204, 5e-5);
    EXPECT_NEAR(toDegrees(*run->slavingStandoff_rad), 0.0204, 5e-5);
    // A one-cycle deviation in a steady turn.
    scenario.manoeuvres = {{0, 3000, 3, 0, 0}};
    scenario.gyro->drift_deg_h = 0;
    scenario.compass.model = SensorModel{};
    scenario.compass.model->hardIron_nT = {100, 0, 0};
    const auto turning = runScenario(scenario);
    ASSERT_TRUE(turning);
    double largest = 0;
    for (std::size_t i = turning->time_s.size() / 2; i < turning->time_s.size(); ++i)
        largest = std::max(largest, std::abs(turning->headingError_rad[i]));
    EXPECT_NEAR(largest / (100 / 18700.0), 0.1287, 5e-4);
}

TEST(ReferenceRun, freeAndRateLimitedGyros)
{
    Scenario scenario;
    scenario.duration_s = 3600;
    scenario.step_s = 1;
    scenario.dip_deg = 60;
    scenario.gyro = HeadingGyro{};
    scenario.gyro->drift_deg_h = 0.5;
    auto run = runScenario(scenario);
    ASSERT_TRUE(run);
    EXPECT_NEAR(toDegrees(run->headingError_rad.back()), 0.5, 1e-9);
    // Set 12° out and slaved at 3°/min: back after four minutes; from beyond 3° at 3°/s almost at once.
    scenario.gyro->drift_deg_h = 0;
    scenario.gyro->initialError_deg = 12;
    scenario.gyro->slavingRate_deg_min = 3;
    run = runScenario(scenario);
    EXPECT_NEAR(toDegrees(run->headingError_rad[120]), 6, 1e-9);
    EXPECT_NEAR(toDegrees(run->headingError_rad[240]), 0, 1e-9);
    scenario.gyro->fastAbove_deg = 3;
    run = runScenario(scenario);
    EXPECT_NEAR(toDegrees(run->headingError_rad[3]), 3, 1e-9);
    EXPECT_NEAR(toDegrees(run->headingError_rad[63]), 0, 1e-9);
}

TEST(ReferenceRun, cutOffLimitsSwitchesAndFastLevelling)
{
    Scenario scenario;
    scenario.duration_s = 300;
    scenario.step_s = 0.1;
    scenario.manoeuvres = {{0, 60, 0, 0.2 * kGravity_m_s2, 0}};
    scenario.vertical = VerticalGyro{};
    scenario.vertical->rateCompensation = true;
    scenario.vertical->cutoff_deg = 5;
    auto run = runScenario(scenario);
    ASSERT_TRUE(run);
    EXPECT_NEAR(run->tilt[600].forward_rad, 0, 1e-12); // it does not follow at all
    scenario.vertical->cutoff_deg.reset();
    scenario.vertical->rateLimit_deg_min = 2;
    run = runScenario(scenario);
    EXPECT_NEAR(toDegrees(run->tilt[600].forward_rad), 2, 1e-6);
    // A sensor that only switches: at its rate to the edge of the dead zone.
    scenario.vertical->rateLimit_deg_min.reset();
    scenario.vertical->levelSwitch = LevelSwitch{0.5, 4, 4};
    scenario.vertical->initialTilt_deg = 3;
    scenario.manoeuvres.clear();
    run = runScenario(scenario);
    EXPECT_NEAR(toDegrees(run->tilt[300].forward_rad), 1, 0.02);
    EXPECT_NEAR(toDegrees(run->tilt.back().forward_rad), 0.5, 0.02);
    // Sides that differ rectify what swings to and fro.
    scenario.vertical->levelSwitch.reset();
    scenario.vertical->initialTilt_deg = 0;
    scenario.gusts = Gusts{1, 10, 1, true};
    scenario.vertical->rateLimit_deg_min = 1;
    run = runScenario(scenario);
    const double fair = run->tilt.back().starboard_rad;
    scenario.vertical->reverseLimit_deg_min = 3;
    run = runScenario(scenario);
    EXPECT_GT(toDegrees(run->tilt.back().starboard_rad), toDegrees(fair) + 0.5);
    // With a cut-off an axis far out is never levelled, but for a fast mode at the beginning.
    scenario.gusts.reset();
    scenario.vertical = VerticalGyro{};
    scenario.vertical->rateCompensation = true;
    scenario.vertical->cutoff_deg = 5;
    scenario.vertical->initialTilt_deg = 20;
    run = runScenario(scenario);
    EXPECT_NEAR(toDegrees(run->tilt.back().forward_rad), 20, 1e-9);
    scenario.vertical->fastUntil_s = 60;
    run = runScenario(scenario);
    EXPECT_NEAR(toDegrees(run->tilt.back().forward_rad), 0, 0.01);
}

TEST(ReferenceRun, ratesCorrectionsAndCoriolis)
{
    Scenario scenario;
    scenario.latitude_deg = 70;
    scenario.speed_m_s = 304.8;
    scenario.heading_deg = 90;
    scenario.duration_s = 1200;
    scenario.step_s = 1;
    scenario.vertical = VerticalGyro{};
    scenario.vertical->rateCompensation = true;
    auto run = runScenario(scenario);
    ASSERT_TRUE(run);
    // Along the parallel: Coriolis and [K 9.8] both lean it to port.
    EXPECT_NEAR(toDegrees(run->tilt.back().starboard_rad), -(0.24386 + 0.2336), 1e-3);
    EXPECT_NEAR(run->tilt.back().forward_rad, 0, 1e-9);
    scenario.vertical->accelerationCorrection = true;
    scenario.vertical->turnRateError_deg_h = 10;
    run = runScenario(scenario);
    EXPECT_NEAR(toDegrees(run->tilt.back().starboard_rad), 0.086266, 1e-4);
    scenario.vertical->rateCompensation = false;
    scenario.vertical->turnRateError_deg_h = 0;
    run = runScenario(scenario);
    // τ1 (V/R + Ω cos Φ) along the track to the east.
    EXPECT_NEAR(toDegrees(run->tilt.back().forward_rad), -60 * (9.857 + 15.0411 * std::cos(toRadians(70))) / 3600, 1e-4);
    EXPECT_NEAR(toDegrees(*run->standoff_rad), 60 * (9.857 + 15.0411 * std::cos(toRadians(70))) / 3600, 1e-4);
}

TEST(ReferenceRun, driftUnderAcceleration)
{
    Scenario scenario;
    scenario.duration_s = 360;
    scenario.step_s = 1;
    scenario.manoeuvres = {{0, 360, 0, 0.1 * kGravity_m_s2, 0}};
    scenario.gyro = HeadingGyro{};
    scenario.gyro->levelOuterAxis = true;
    scenario.gyro->accelerationDrift = {20, 10}; // per hour and g, per hour and g²
    const auto run = runScenario(scenario);
    ASSERT_TRUE(run);
    EXPECT_NEAR(toDegrees(shareOf(*run, ErrorSource::Drift).back()), (20 * 0.1 + 10 * 0.1) * 0.1, 1e-6);
}

TEST(ReferenceRun, aCardInLiquidSwingsWithItsPeriodAndIsDraggedInTurns)
{
    Scenario scenario;
    scenario.duration_s = 300;
    scenario.step_s = 0.1;
    scenario.manoeuvres = {{0, 120, 3, 0, 0}};
    scenario.compass.type = CompassType::Needle;
    scenario.compass.card = CardInLiquid{15, 0.3, 10, {}};
    auto run = runScenario(scenario);
    ASSERT_TRUE(run);
    // Steady turn: ω² sin e = −2ζω ψ̇, the liquid turning with the aircraft.
    const double natural = 2 * kPi / 15;
    EXPECT_NEAR(run->headingError_rad[1190], -std::asin(2 * 0.3 * toRadians(3) / natural), 2e-3);
    EXPECT_NEAR(run->headingError_rad.back(), 0, 1e-3);
    // A little afterwards it swings with its damped period: zero crossings half of it apart, once the liquid is still.
    scenario.compass.card->liquidLag_s = 0;
    scenario.compass.card->damping = 0.05;
    run = runScenario(scenario);
    std::vector<double> crossings;
    for (std::size_t i = 1500; i + 1 < run->time_s.size(); ++i)
        if ((run->headingError_rad[i] > 0) != (run->headingError_rad[i + 1] > 0))
            crossings.push_back(run->time_s[i]);
    ASSERT_GE(crossings.size(), 5u);
    EXPECT_NEAR(crossings[4] - crossings[0], 30 / std::sqrt(1 - 0.0025), 0.3);
}

TEST(ReferenceRun, nothingAndTheExtremes)
{
    Scenario nothing;
    auto run = runScenario(nothing);
    ASSERT_TRUE(run);
    EXPECT_EQ(run->time_s.size(), 1u);
    EXPECT_EQ(run->headingError_rad[0], 0);
    Scenario wild = flight();
    wild.speed_m_s = 2000;
    wild.manoeuvres = {{0, 600, 300, 50, 0}, {300, 600, 0, -500, 0}, {10, 20, 0, 0, 5000}};
    run = runScenario(wild);
    ASSERT_TRUE(run);
    EXPECT_GE(run->warnings.size(), 3u);
    for (const double error : run->headingError_rad)
        ASSERT_LE(std::abs(error), kPi + 1e-12);
    for (const double pole : {90.0, -90.0}) {
        Scenario polar = flight();
        polar.latitude_deg = polar.dip_deg = pole;
        run = runScenario(polar);
        ASSERT_TRUE(run);
        for (const double error : run->headingError_rad)
            ASSERT_TRUE(std::isfinite(error));
        EXPECT_FALSE(run->warnings.empty());
    }
    Scenario bad = flight();
    bad.step_s = 0;
    EXPECT_FALSE(runScenario(bad));
    bad = flight();
    bad.step_s = 1e-9;
    EXPECT_FALSE(runScenario(bad));
    bad = flight();
    bad.manoeuvres.push_back({10, 5, 1, 0, 0});
    EXPECT_FALSE(runScenario(bad));
    bad = flight();
    bad.vertical->tau1_s = 0;
    EXPECT_FALSE(runScenario(bad));
    EXPECT_EQ(runScenario(flight(), [](double) { return false; }).error().code, ErrorCode::Cancelled);
}

TEST(ReferenceRun, gustsHaveTheirSizeAndPeriod)
{
    Scenario scenario = flight();
    scenario.duration_s = 20000;
    scenario.manoeuvres.clear();
    const auto motion = motionOf(scenario);
    double squares = 0;
    int upward = 0;
    for (std::size_t i = 0; i + 1 < motion.points.size(); ++i) {
        squares += motion.points[i].gustForward_m_s2 * motion.points[i].gustForward_m_s2;
        upward += motion.points[i].gustForward_m_s2 < 0 && motion.points[i + 1].gustForward_m_s2 >= 0;
    }
    EXPECT_NEAR(std::sqrt(squares / static_cast<double>(motion.points.size())), 0.3, 0.03);
    EXPECT_NEAR(20000.0 / upward, 12, 2);
    EXPECT_EQ(motionOf(scenario).points[500].gustForward_m_s2, motion.points[500].gustForward_m_s2);
}

} // namespace
} // namespace lubberline
