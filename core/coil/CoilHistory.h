#pragma once
/// Coil benches that are kept, and what two of the same sensor say of its drift.

#include <optional>
#include <vector>

#include "core/coil/CoilBench.h"
#include "core/record/CoilBench.h"

namespace lubberline {

/// The whole rows of a log as a record; date and particulars are the caller's. Errors: those of coilBench(); InvalidInput (more readings
/// than a bench may have).
Result<CoilBench> coilRecordOf(const SensorLog& log);
/// The log again: coilBench() of it tells the same.
[[nodiscard]] SensorLog logOf(const CoilBench& bench);

/// What became other from one bench to a later one; intervals are 95 %.
struct CoilDrift {
    double years = 0;
    std::optional<double> at_c; ///< both biases were brought to this temperature; none: it is not known, or what a degree does is not
    Eigen::Vector3d bias_nT_per_year = Eigen::Vector3d::Zero(), biasInterval_nT_per_year = Eigen::Vector3d::Zero();
    Eigen::Vector3d scale_per_year = Eigen::Vector3d::Zero(), scaleInterval_per_year = Eigen::Vector3d::Zero(); ///< of the scale: relative
    Eigen::Vector3d noiseRatio = Eigen::Vector3d::Ones();                                                       ///< later per earlier
    std::vector<Message> doubts; ///< why a difference may not be the sensor's
};

/// Errors: InvalidInput, in words: the two cannot be compared (another sensor, another unit, less than 30 days apart); those of coilBench().
Result<CoilDrift> driftBetween(const CoilBench& earlier, const CoilBench& later);

} // namespace lubberline
