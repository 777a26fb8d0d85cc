// What helmet systems demand, on a flight: one manoeuvre calibrates, the next one is compensated by what it found.
#include <gtest/gtest.h>

#include "core/calibration/AttitudeFit.h"
#include "core/calibration/Compensation.h"
#include "tests/core/calibration/LogMaker.h"

namespace lubberline::test {
namespace {

/// Turns through all headings with pitch within ±20° and roll within ±35°, each at its own pace, 240 samples a second.
SensorLog flightLog(const SensorModel& model, double seconds, double phase, double noise_nT)
{
    std::mt19937_64 random(static_cast<unsigned>(100 * phase) + 1);
    std::normal_distribution<double> normal;
    const SensorResponse response = responseOf(model);
    const MeridianField field = LogPlan{}.field;
    SensorLog log;
    for (int i = 0; i < static_cast<int>(240 * seconds); ++i) {
        const double time = i / 240.0;
        const Attitude attitude{MagneticHeading::fromDegrees(wrap360(6 * time + 50 * phase)), toRadians(20 * std::sin(0.41 * time + phase)),
            toRadians(35 * std::sin(0.67 * time + 2 * phase))};
        Eigen::Vector3d m = response.gain * fieldInBody(field, attitude) + response.offset_nT;
        log.time_s.push_back(std::round(1e4 * time) / 1e4); // as a logger writes it: steps of 4.1 and 4.2 ms
        for (std::size_t axis = 0; axis < 3; ++axis)
            log.field[axis].push_back(m[static_cast<Eigen::Index>(axis)] + noise_nT * normal(random));
        log.heading_deg.push_back(attitude.heading.degrees());
        log.pitch_deg.push_back(toDegrees(attitude.pitch_rad));
        log.roll_deg.push_back(toDegrees(attitude.roll_rad));
    }
    return log;
}

/// 40 nT across H of 20 000 nT are 0.11° level, and more where the tilt carries the vertical field's noise in.
TEST(HelmetFlight, theNextManoeuvreMeetsTheDemands)
{
    const SensorModel iron = exampleModel();
    const auto fit = fitAttitude(flightLog(iron, 120, 0, 40), {LogPlan{}.field});
    ASSERT_TRUE(fit) << describe(fit.error());
    EXPECT_EQ(fit->verdict, CalibrationVerdict::Good) << together(fit->reasons).english();
    CompensationOptions options;
    options.field = LogPlan{}.field;
    options.latency_ms = 1.5;
    options.filter_ms = 2.0;
    const auto flown = compensate(flightLog(iron, 60, 1.3, 40), fit->model, options);
    ASSERT_TRUE(flown) << describe(flown.error());
    EXPECT_GT(flown->before->rms_deg, 3);
    EXPECT_NEAR(flown->after->rms_deg, 0.13, 0.05);
    ASSERT_EQ(flown->demands.size(), 3u);
    for (const auto& demand : flown->demands)
        EXPECT_EQ(demand.met(), true) << demand.name.english();
    EXPECT_DOUBLE_EQ(*flown->demands[1].value, 3.5);
}

/// Something is carried aboard between the two: the heading is out, rate and latency are not; a latency that nobody states is not known.
TEST(HelmetFlight, ironThatCameAboardSinceIsSeen)
{
    SensorModel iron = exampleModel();
    const auto fit = fitAttitude(flightLog(iron, 120, 0, 40), {LogPlan{}.field});
    ASSERT_TRUE(fit) << describe(fit.error());
    iron.hardIron_nT += Eigen::Vector3d(150, -100, 0);
    const auto flown = compensate(flightLog(iron, 60, 1.3, 40), fit->model, {});
    ASSERT_TRUE(flown) << describe(flown.error());
    EXPECT_EQ(flown->demands[0].met(), true);
    EXPECT_EQ(flown->demands[1].met(), std::nullopt);
    EXPECT_EQ(flown->demands[2].met(), false) << flown->after->rms_deg;
}

} // namespace
} // namespace lubberline::test
