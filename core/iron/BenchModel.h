#pragma once
/// What an airframe does to the field at its sensor: S, p and the circuits' fields per ampere.
///   M = (1 + χ N̄)⁻¹ (χ B/μ0 + M_r): a part is magnetised by the Earth's field and its own demagnetising field, not by other
///   parts (said in the warnings); at the sensor −μ0 N(r) M: the tensor within three lengths of the part, a dipole beyond;
///   Biot–Savart.
/// N̄ from the closed forms of DemagnetisingFactors.h. M is taken as uniform: exact for ellipsoid and sphere, an approximation
/// for box and cylinder of high χ. A part's own axes are turned into body axes by rotation(roll, pitch, yaw)ᵀ, as an
/// attitude's. Signs: B at the sensor = B + S·B + p + Σ circuits; S = −Rᵀ N(r) (1 + χ N̄)⁻¹ χ R, p = −Rᵀ N(r) (1 + χ N̄)⁻¹ μ0
/// M_r.

#include <string>
#include <vector>

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/iron/CurrentField.h"
#include "core/iron/FerrousPart.h"
#include "core/sensor/SensorModel.h"

namespace lubberline {

struct PartEffect {
    std::string part;
    Eigen::Matrix3d softIron = Eigen::Matrix3d::Zero();
    Eigen::Vector3d hardIron_nT = Eigen::Vector3d::Zero();
    double distance_m = 0;                         ///< from the sensor to the part's centre
    bool dipole = true;                            ///< false: by the tensor
    std::optional<double> coercivity_A_per_m = {}; ///< of the part, for what may drift (Coercivity.h)
};

struct BenchModel {
    SensorModel model;             ///< softIron, hardIron_nT and circuits; the rest is zero
    std::vector<PartEffect> parts; ///< in the order of the bench
    std::vector<Message> warnings;
};

/// The groups of the bench with their states, in the order in which they are first named.
[[nodiscard]] std::vector<std::pair<std::string, std::vector<std::string>>> groupsOf(const IronBench& bench);

/// A group without a choice takes its first state. Parts that are alike and as far share a tensor; the last few are kept for
/// the next call, so that moving one part costs one tensor. Errors: InvalidInput (sensor inside a part or on a wire: names it;
/// sizes ≤ 0, χ < 0, a group without the chosen state, not finite), Cancelled.
Result<BenchModel> benchModel(const IronBench& bench, const BenchStates& states = {}, const Progress& progress = {});

} // namespace lubberline
