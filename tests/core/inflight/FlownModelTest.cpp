// The whole sensor model from flight to flight: two flights with a model kept between are one long flight; a model that was kept by
// something else is read as the heading is read with it.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <span>

#include "core/angle/Angle.h"
#include "core/inflight/FlownModel.h"
#include "core/sensor/SensorReading.h"

using namespace lubberline;

namespace {

const MeridianField kField = MeridianField::fromDip(18700, toRadians(67));
constexpr double kOver_nT = 25000; // another than that of the log

SensorModel iron()
{
    SensorModel model;
    model.softIron << 0.012, -0.004, 0.010, 0.006, -0.009, 0.003, 0.005, -0.008, 0;
    model.hardIron_nT = {700, -400, 300};
    return model;
}

/// As a bench gives it: turned in its mount, with a scale, a constant field and a circuit.
SensorRecord calibrated()
{
    SensorRecord sensor;
    sensor.model = iron();
    sensor.model.softIron(2, 2) = 0.05;
    sensor.model.softConstant_nT = {20, -30, 40};
    sensor.model.misalignment = {0.02, -0.01, 0.03};
    sensor.model.circuits = {{"landing light", {10, 5, -4}, 8, true}, {"pitot heat", {100, 100, 100}, 5, false}};
    auto& covariance = sensor.uncertainty.emplace().covariance;
    for (int i = 0; i < kUncertainParameters; ++i)
        for (int j = 0; j < kUncertainParameters; ++j)
            covariance(i, j) = (i == j ? 1.0 : 0.3) * (i < 9 ? 1e-3 : 20.0) * (j < 9 ? 1e-3 : 20.0);
    return sensor;
}

std::vector<ContinuousSample> flown(int count, double correlation = 0)
{
    std::mt19937_64 engine(7);
    std::normal_distribution<double> normal;
    std::vector<ContinuousSample> samples;
    double error_deg = 0;
    for (int i = 0; i < count; ++i) {
        const double pitch = 15 * std::sin(0.71 * i), roll = 22 * std::sin(0.43 * i + 1);
        const auto reading
            = readSensor(iron(), kField, {MagneticHeading::fromDegrees(wrap360(137.5 * i)), toRadians(pitch), toRadians(roll)});
        error_deg = correlation * error_deg + std::sqrt(1 - correlation * correlation) * 0.3 * normal(engine);
        ContinuousSample sample;
        sample.time_s = 10.0 * i;
        sample.compassHeading_deg = reading.compass->degrees();
        sample.deviation_deg = reading.deviation->degrees() + error_deg;
        sample.at = {pitch, roll, kField};
        samples.push_back(sample);
    }
    return samples;
}

ContinuousResult followed(std::span<const ContinuousSample> samples, const std::optional<ContinuousState>& start = {})
{
    ContinuousOptions options;
    options.noise_deg = 0.3;
    options.wholeModelOver_nT = start ? start->horizontal_nT : kField.horizontal_nT;
    options.start = start;
    ContinuousSwing swing(options);
    for (const auto& sample : samples)
        swing.add(sample);
    return swing.finish();
}

} // namespace

TEST(FlownModel, twoFlightsAreOneLongFlight)
{
    const auto samples = flown(2000);
    const auto whole = std::span(samples);
    const ContinuousResult first = followed(whole.first(900));
    ASSERT_EQ(first.widened, 1.0);
    const auto kept = flownModel(first, {});
    ASSERT_TRUE(kept);
    const auto start = stateOf(*kept, kOver_nT);
    ASSERT_TRUE(start);
    const auto both = flownModel(followed(whole.subspan(900), start), start), once = flownModel(followed(whole), {});
    ASSERT_TRUE(both && once);
    EXPECT_LT((both->model.softIron - once->model.softIron).norm(), 1e-9);
    EXPECT_LT((both->model.hardIron_nT - once->model.hardIron_nT).norm(), 1e-4);
    const auto &a = both->uncertainty->covariance, &b = once->uncertainty->covariance;
    EXPECT_LT((a - b).norm(), 1e-6 * b.norm());
    EXPECT_EQ(b.row(8).norm(), 0.0); // no heading tells a scale of all axes
}

TEST(FlownModel, aKeptModelTellsTheHeadingThatTheSensorReads)
{
    const SensorRecord sensor = calibrated();
    const auto state = stateOf(sensor, kOver_nT);
    ASSERT_TRUE(state);
    for (double heading = 0; heading < 360; heading += 17)
        for (const auto& [pitch, roll] : {std::pair{0.0, 0.0}, {12.0, -25.0}, {-8.0, 40.0}}) {
            const auto reading
                = readSensor(sensor.model, kField, {MagneticHeading::fromDegrees(heading), toRadians(pitch), toRadians(roll)});
            const auto row = modelRow(reading.compass->degrees(), reading.deviation->degrees(), {pitch, roll, kField}, kOver_nT);
            EXPECT_NEAR(row.dot(state->state_deg), toDegrees(std::sin(reading.deviation->radians())), 1e-9) << heading;
        }
}

TEST(FlownModel, aKeptModelIsAsSureAsItWas)
{
    const SensorRecord sensor = calibrated();
    Eigen::MatrixXd slope(kModelStates, kUncertainParameters);
    for (int parameter = 0; parameter < kUncertainParameters; ++parameter) {
        const double step = parameter < 9 ? 1e-6 : 1e-2;
        const auto moved = [&](double by) {
            SensorRecord other = sensor;
            if (parameter < 9)
                other.model.softIron(parameter / 3, parameter % 3) += by;
            else
                other.model.hardIron_nT(parameter - 9) += by;
            return stateOf(other, kOver_nT)->state_deg;
        };
        slope.col(parameter) = (moved(step) - moved(-step)) / (2 * step);
    }
    const Eigen::MatrixXd expected = slope * sensor.uncertainty->covariance * slope.transpose();
    EXPECT_LT((stateOf(sensor, kOver_nT)->covariance - expected).norm(), 1e-6 * expected.norm());
}

TEST(FlownModel, whatIsNotKnownIsNoStart)
{
    SensorRecord sensor = calibrated();
    sensor.model = iron();
    for (const int place : {0, 8}) { // a and k known exactly: no flight would ever move a
        sensor.uncertainty->covariance.row(place).setZero();
        sensor.uncertainty->covariance.col(place).setZero();
    }
    EXPECT_FALSE(stateOf(sensor, kOver_nT));
    sensor.uncertainty.reset();
    EXPECT_FALSE(stateOf(sensor, kOver_nT));
    const auto few = flown(6);
    EXPECT_FALSE(flownModel(followed(few), {}));
}

/// Errors that last count for less; what was known before a flight stays as sure as it was.
TEST(FlownModel, errorsThatLastMakeAFlightLessSure)
{
    const auto samples = flown(1500, 0.9);
    const ContinuousResult result = followed(samples);
    ASSERT_GT(result.widened, 3.0);
    const auto kept = flownModel(result, {});
    ASSERT_TRUE(kept);
    EXPECT_NEAR(kept->uncertainty->covariance(0, 0), result.widened * result.state.covariance(0, 0) * kRadiansPerDegree * kRadiansPerDegree,
        1e-6 * kept->uncertainty->covariance(0, 0));
    const auto start = stateOf(*kept, kOver_nT);
    const ContinuousResult next = followed(samples, start);
    const auto after = flownModel(next, start);
    ASSERT_TRUE(after);
    for (const int place : {0, 4, 9, 10, 11}) {
        EXPECT_LT(after->uncertainty->covariance(place, place), kept->uncertainty->covariance(place, place)) << place;
        EXPECT_GT(after->uncertainty->covariance(place, place), 0.3 * kept->uncertainty->covariance(place, place)) << place;
    }
}
