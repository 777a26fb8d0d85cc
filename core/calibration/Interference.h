#pragma once
/// Interference test: with the aircraft still, things are switched at noted times, and the field at the sensor must not change by more
/// than a limit on any axis (5, 5 and 8 mG on x, y and z by makers' manuals).

#include <optional>

#include "core/base/Result.h"
#include "core/calibration/SensorLog.h"
#include "core/sensor/SensorModel.h"

namespace lubberline {

struct TimedAction {
    double time_s = 0;
    std::string action;
};

inline const Eigen::Vector3d kInterferenceLimits_nT{500, 500, 800};

struct ActionOutcome {
    std::string action;
    double from_s = 0, to_s = 0;                         ///< until the next action
    Eigen::Vector3d change_nT = Eigen::Vector3d::Zero(); ///< median after − median before
    Eigen::Vector3d worst_nT = Eigen::Vector3d::Zero();  ///< largest departure from the median before, with its sign
    Eigen::Vector3d worstAt_s = Eigen::Vector3d::Zero();
    bool passes = false;
};

struct InterferenceResult {
    std::vector<ActionOutcome> actions;
    bool passes = false;
    Eigen::Vector3d limits_nT = kInterferenceLimits_nT;
    Eigen::Vector3d noise_nT = Eigen::Vector3d::Zero(); ///< before the first action: 1.4826 MAD
    std::vector<Circuit> circuits;                      ///< field per ampere of each current column that changed
    std::vector<Message> warnings;
};

/// Errors: InvalidInput (no time, counts, an action outside of the log, no samples before or after one).
Result<InterferenceResult> interferenceTest(
    const SensorLog& log, const std::vector<TimedAction>& actions, const Eigen::Vector3d& limits_nT = kInterferenceLimits_nT);

} // namespace lubberline
