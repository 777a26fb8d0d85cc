#include "core/coil/CoilBench.h"

#include <gmock/gmock.h>

#include <random>

#include "core/angle/Angle.h"

namespace lubberline::test {
namespace {

using testing::HasSubstr;

/// Each axis up and down by itself, ±65 000 nT in steps of 5000, with temperature that rises by 20°.
SensorLog coilLog(
    const Eigen::Matrix3d& gain, const Eigen::Vector3d& bias, double temperature_nT, double loop_nT, double cubic, double noise)
{
    std::mt19937_64 random(11);
    std::normal_distribution<double> normal;
    SensorLog log;
    for (const char* name : {"ax_nT", "ay_nT", "az_nT", "temperature_c"})
        log.others.push_back({name, {}});
    std::vector<double> sweep;
    for (const double end : {65000.0, -65000.0, 0.0})
        for (double at = sweep.empty() ? 0 : sweep.back(); at != end;)
            sweep.push_back(at += end > at ? 5000 : -5000);
    for (int round = 0; round < 4; ++round)
        for (int axis = 0; axis < 3; ++axis) {
            double before = 0;
            for (const double at : sweep) {
                Eigen::Vector3d applied = Eigen::Vector3d::Zero();
                applied[axis] = at;
                const double warm = 20.0 * static_cast<double>(log.size()) / 600.0;
                Eigen::Vector3d measured = gain * applied + bias + Eigen::Vector3d::Constant(temperature_nT * warm);
                measured[axis] += 0.5 * loop_nT * (at > before ? 1 : -1) + cubic * std::pow(at / 65000, 3);
                for (std::size_t k = 0; k < 3; ++k) {
                    log.others[k].values.push_back(applied[static_cast<Eigen::Index>(k)]);
                    log.field[k].push_back(measured[static_cast<Eigen::Index>(k)] + noise * normal(random));
                }
                log.others[3].values.push_back(20 + warm);
                before = at;
            }
        }
    return log;
}

Eigen::Matrix3d leaning()
{
    Eigen::Matrix3d gain;
    gain << 1.02, 0.01, 0, 0, 0.97, 0, 0, 0, 1.0;
    return gain;
}

TEST(CoilBench, scaleAxesAndBias)
{
    const auto result = coilBench(coilLog(leaning(), {120, -80, 40}, 0, 0, 0, 5));
    ASSERT_TRUE(result) << describe(result.error());
    EXPECT_NEAR(result->scale.x(), std::hypot(1.02, 0.01), 2e-5);
    EXPECT_NEAR(result->scale.y(), 0.97, 2e-5);
    EXPECT_NEAR(result->bias_nT.x(), 120, 3);
    EXPECT_NEAR(result->nonOrthogonality_deg.x(), toDegrees(std::atan(0.01 / 1.02)), 0.003);
    EXPECT_NEAR(result->nonOrthogonality_deg.y(), 0, 0.003);
    EXPECT_NEAR(result->noise_nT.z(), 5, 0.5);
    EXPECT_LT(std::abs(result->scale.x() - std::hypot(1.02, 0.01)), 4 * result->scaleError.x());
}

TEST(CoilBench, temperatureAndHysteresis)
{
    const auto result = coilBench(coilLog(Eigen::Matrix3d::Identity(), {0, 0, 0}, 3, 40, 0, 2));
    ASSERT_TRUE(result) << describe(result.error());
    ASSERT_TRUE(result->temperature_nT_per_c && result->hysteresis_nT);
    EXPECT_NEAR(result->temperature_nT_per_c->y(), 3, 0.2);
    EXPECT_NEAR(result->hysteresis_nT->x(), 40, 2) << "up − down";
}

TEST(CoilBench, nonlinearity)
{
    const auto result = coilBench(coilLog(Eigen::Matrix3d::Identity(), {0, 0, 0}, 0, 0, 200, 2));
    ASSERT_TRUE(result) << describe(result.error());
    // What a straight line leaves of 200 u³: at the end of the range some 200 (1 − 3/5) nT; the rows at zero make it a little more.
    EXPECT_NEAR(result->nonlinearity_nT.z(), 80, 25);
}

TEST(CoilBench, aTurnedMountIsTold)
{
    Eigen::Matrix3d turned;
    const double yaw = toRadians(2);
    turned << std::cos(yaw), std::sin(yaw), 0, -std::sin(yaw), std::cos(yaw), 0, 0, 0, 1;
    const auto result = coilBench(coilLog(turned, {0, 0, 0}, 0, 0, 0, 1));
    EXPECT_NEAR(toDegrees(result->misalignment.yaw_rad), 2, 0.005);
    EXPECT_NEAR(result->nonOrthogonality_deg.norm(), 0, 0.005);
}

/// µT in a column that says nT gave a record of a sensor with a scale of 0.001 and a noise of 15 pT.
TEST(CoilBench, aColumnInAnotherUnitIsRefused)
{
    const auto refusal = [](double measured, double applied) {
        SensorLog log = coilLog(leaning(), {50, 0, 0}, 0, 0, 0, 1);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (double& value : log.field[axis])
                value *= measured;
            for (double& value : log.others[axis].values)
                value *= applied;
        }
        const auto result = coilBench(log);
        return result ? std::string("it was taken") : describe(result.error());
    };
    EXPECT_EQ(refusal(1, 1), "it was taken");
    EXPECT_THAT(refusal(1e-3, 1), HasSubstr("the measured columns look like \u00B5T"));
    EXPECT_THAT(refusal(1e-3, 1), HasSubstr("has 0.00097 to 0.00102 nT measured per nT applied; expected 0.5 to 2"));
    EXPECT_THAT(refusal(1e-2, 1), HasSubstr("the measured columns look like mG"));
    EXPECT_THAT(refusal(1, 1e-3), HasSubstr("the applied columns look like \u00B5T"));
    EXPECT_THAT(refusal(0.07, 1), HasSubstr("a column is in another unit"));
    SensorLog counts = coilLog(3 * leaning(), {50, 0, 0}, 0, 0, 0, 1);
    counts.unit = FieldUnit::Counts;
    EXPECT_TRUE(coilBench(counts)) << "counts are worth what the bench says";
}

TEST(CoilBench, whatIsRefused)
{
    SensorLog log = coilLog(leaning(), {0, 0, 0}, 0, 0, 0, 1);
    log.others[2].values.assign(log.size(), 0.0);
    EXPECT_THAT(describe(coilBench(log).error()), HasSubstr("does not go through all three axes"));
    log.others.clear();
    EXPECT_THAT(describe(coilBench(log).error()), HasSubstr("expected the columns ax_nT, ay_nT, az_nT"));
}

} // namespace
} // namespace lubberline::test
