#include "core/sensor/ModelUncertainty.h"

#include <gtest/gtest.h>

#include "core/angle/Angle.h"
#include "core/sensor/SensorReading.h"

namespace lubberline {
namespace {

const MeridianField kField = MeridianField::fromDip(20000, toRadians(60));

double sigma_deg(const SensorModel& model, const ModelUncertainty& uncertainty, const Attitude& attitude)
{
    return toDegrees(headingSigma_rad(model, uncertainty, kField, attitude).value_or(-1));
}

/// 100 nT of P across the field of 20 000 nT are atan(1/200) at 090 and nothing at 000; of Q the other way round.
TEST(ModelUncertainty, hardIronOfALevelHeading)
{
    ModelUncertainty p, q;
    p.covariance(9, 9) = q.covariance(10, 10) = 100 * 100;
    EXPECT_NEAR(sigma_deg({}, p, {MagneticHeading::fromDegrees(90)}), toDegrees(100.0 / 20000), 1e-9);
    EXPECT_NEAR(sigma_deg({}, p, {MagneticHeading::fromDegrees(0)}), 0, 1e-9);
    EXPECT_NEAR(sigma_deg({}, q, {MagneticHeading::fromDegrees(180)}), toDegrees(100.0 / 20000), 1e-9);
    ModelUncertainty both;
    both.covariance = p.covariance + q.covariance;
    EXPECT_NEAR(sigma_deg({}, both, {MagneticHeading::fromDegrees(37)}), toDegrees(100.0 / 20000), 1e-9);
    // c does with the vertical field what P does: 0.001 of 34 641 nT.
    ModelUncertainty c;
    c.covariance(2, 2) = 1e-6;
    EXPECT_NEAR(sigma_deg({}, c, {MagneticHeading::fromDegrees(90)}), toDegrees(34.641 / 20000), 1e-6);
}

/// Each parameter moved by a thousandth of its part turns what the compass reads by so many of its standard deviations.
TEST(ModelUncertainty, isTheSlopeOfTheReading)
{
    SensorModel model;
    model.softIron << 0.04, 0.01, 0.03, 0.02, -0.01, -0.015, 0.02, 0.01, 0.05;
    model.hardIron_nT = {900, -600, 300};
    model.misalignment = {toRadians(2), toRadians(-3), toRadians(5)};
    const Attitude attitude{MagneticHeading::fromDegrees(127), toRadians(9), toRadians(-14)};
    const double before = readSensor(model, kField, attitude).compass->degrees();
    for (int i = 0; i < kUncertainParameters; ++i) {
        const double step = i < 9 ? 1e-5 : 0.5;
        SensorModel moved = model;
        (i < 9 ? moved.softIron(i / 3, i % 3) : moved.hardIron_nT[i - 9]) += step;
        ModelUncertainty one;
        one.covariance(i, i) = step * step;
        EXPECT_NEAR(sigma_deg(model, one, attitude), std::abs(readSensor(moved, kField, attitude).compass->degrees() - before), 1e-6) << i;
    }
}

TEST(ModelUncertainty, whereNothingIsLeftThereIsNone)
{
    SensorModel model;
    model.hardIron_nT = {-20000, 0, 0};
    ModelUncertainty any;
    any.covariance.setIdentity();
    EXPECT_FALSE(headingSigma_rad(model, any, kField, {MagneticHeading::fromDegrees(0)}));
}

} // namespace
} // namespace lubberline
