#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "core/angle/Angle.h"
#include "core/swing/SwingResult.h"

namespace lubberline {
namespace {

using testing::HasSubstr;

/// Scale 2 (counts per nT), noise 40, a loop of 120 and a bend of 60 nT on each axis, read as counts.
CoilBench benchWith(double noise_nT, double loop_nT, double bend_nT)
{
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    CoilBench bench;
    bench.date = "2026-05-01";
    bench.inCounts = true;
    for (int round = 0; round < 20; ++round)
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (int step = 0; step < 40; ++step) {
                const bool up = step >= 1 && step <= 20; // by the step that led there
                const double u = step < 20 ? -1 + step / 10.0 : 1 - (step - 20) / 10.0;
                std::array<double, 6> row{};
                row[axis] = 65000 * u;
                for (std::size_t k = 0; k < 3; ++k) {
                    const double loop = k == axis ? 0.5 * loop_nT * (up ? 1 : -1) + bend_nT * (2.5 * u * u * u - 1.5 * u) : 0.0;
                    row[k + 3] = 2 * (row[k] + loop + noise_nT * normal(random));
                }
                bench.readings.push_back(row);
            }
    return bench;
}

TEST(SensorBench, noiseLoopAndBendAreStandardUncertaintiesInNanotesla)
{
    const auto bench = sensorBenchOf(benchWith(40, 0, 0));
    ASSERT_TRUE(bench);
    EXPECT_NEAR(bench->noise_nT, 40, 1.5);
    EXPECT_NEAR(sensorBenchOf(benchWith(5, 120, 0))->hysteresis_nT, 120 / std::sqrt(12.0), 1.5) << "anything between the two ways";
    EXPECT_NEAR(sensorBenchOf(benchWith(5, 0, 60))->nonlinearity_nT, 60 / std::sqrt(3.0), 6) << "anything up to the largest";
}

TEST(SensorBench, itsAngleGoesWithTheField)
{
    SensorBench bench;
    bench.noise_nT = 30;
    bench.hysteresis_nT = 40;
    EXPECT_NEAR(bench.whole_nT(), 50, 1e-12);
    EXPECT_NEAR(toDegrees(*errorIn(bench, 20000)), toDegrees(50.0 / 20000), 1e-6);
    EXPECT_EQ(errorIn(bench, 1999), std::nullopt);
}

TEST(SensorBench, isInTheErrorsOfASwingWhoseFieldIsKnown)
{
    SwingRecord record;
    for (int heading = 0; heading < 360; heading += 45) {
        Reading reading;
        reading.magnetic = MagneticHeading::fromDegrees(heading);
        reading.compass = CompassHeading::fromDegrees(heading);
        record.swing.readings.push_back(reading);
    }
    record.compass.resolution_deg = 0.1;
    SensorBench bench;
    bench.date = "2026-05-01";
    bench.noise_nT = 200;
    const auto unknown = resultOf(record, nullptr, {}, bench);
    ASSERT_TRUE(unknown);
    EXPECT_THAT(unknown->warnings.back().english(), HasSubstr("leaves 200 nT on each reading, which is not in the errors"));
    EXPECT_EQ(unknown->approximate.standardError[0], resultOf(record)->approximate.standardError[0]);
    FieldStamp stamp;
    stamp.field = {20000, 0, 40000};
    record.swing.field = stamp;
    const auto known = resultOf(record, nullptr, {}, bench);
    EXPECT_NEAR(*known->approximate.standardError[0], std::hypot(0.01, toRadians(0.1) / std::sqrt(12.0)) / std::sqrt(8.0), 2e-7);
    EXPECT_THAT(
        known->warnings.back().english(), HasSubstr("leaves 0.57\u00B0 on each reading, in the errors: by its coil bench of 2026-05-01"));
    EXPECT_THAT(wordsOf(SensorBench{}, 0.01, 20000).english(), HasSubstr("by its coil bench, noise"));
}

} // namespace
} // namespace lubberline
