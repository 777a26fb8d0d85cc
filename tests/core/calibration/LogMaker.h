#pragma once
/// Logs with a known truth.

#include <random>

#include "core/calibration/SensorLog.h"
#include "core/sensor/Attitude.h"
#include "core/sensor/SensorModel.h"

namespace lubberline::test {

struct LogPlan {
    SensorModel model = {};
    MeridianField field = MeridianField::fromDip(20000, toRadians(60)); ///< |B| 40 000 nT
    double tilt_deg = 180;                                              ///< pitch and roll are even within ±this
    double noise_nT = 100;
    double spikes = 0; ///< share of samples
    int samples = 2000;
    unsigned seed = 1;
};

inline SensorModel exampleModel()
{
    SensorModel model = {};
    model.softIron << 0.05, 0.02, -0.01, 0.02, -0.04, 0.015, -0.01, 0.015, 0.03;
    model.hardIron_nT = {3000, -2000, 1500};
    return model;
}

/// Attitudes at random, so neighbours tell nothing of each other.
inline SensorLog makeLog(const LogPlan& plan)
{
    std::mt19937_64 random(plan.seed);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> even(-1, 1);
    SensorLog log;
    const SensorResponse response = responseOf(plan.model);
    for (int i = 0; i < plan.samples; ++i) {
        const Attitude attitude{MagneticHeading::fromRadians(kPi * even(random)), toRadians(plan.tilt_deg) * even(random),
            toRadians(plan.tilt_deg) * even(random)};
        Eigen::Vector3d m = response.gain * fieldInBody(plan.field, attitude) + response.offset_nT;
        for (int axis = 0; axis < 3; ++axis)
            m[axis] += plan.noise_nT * normal(random);
        if (std::abs(even(random)) < plan.spikes)
            for (int axis = 0; axis < 3; ++axis)
                m[axis] += 20000 * normal(random);
        log.time_s.push_back(0.1 * i);
        for (int axis = 0; axis < 3; ++axis)
            log.field[static_cast<std::size_t>(axis)].push_back(m[axis]);
        log.heading_deg.push_back(attitude.heading.degrees());
        log.pitch_deg.push_back(toDegrees(attitude.pitch_rad));
        log.roll_deg.push_back(toDegrees(attitude.roll_rad));
    }
    log.counts.rows = plan.samples;
    return log;
}

} // namespace lubberline::test
