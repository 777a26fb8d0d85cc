#pragma once
/// A source of stray field located and sized as a dipole, from readings around it:
///   B(r) = B0 + μ0/4π (3 (m·n) n − m)/d³, n d = r − r0,   μ0/4π = 100 nT·m³/(A·m²)
/// B0 is a uniform field, as the Earth's where the readings are not less it. True beyond some three lengths of the source.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/base/Result.h"

namespace lubberline {

struct StrayReading {
    Eigen::Vector3d at_m = Eigen::Vector3d::Zero(); ///< any one set of axes; those of the field
    Eigen::Vector3d field_nT = Eigen::Vector3d::Zero();
};

/// Two dipoles that explain what one does not.
struct TwoSources {
    std::array<Eigen::Vector3d, 2> at_m{}, moment_A_m2{};
    Eigen::Vector3d uniform_nT = Eigen::Vector3d::Zero();
    double rms_nT = 0; ///< of what both leave, a component
};

struct DipoleSource {
    Eigen::Vector3d at_m = Eigen::Vector3d::Zero(), atError_m = Eigen::Vector3d::Zero(); ///< standard errors
    Eigen::Vector3d moment_A_m2 = Eigen::Vector3d::Zero();
    double momentError_A_m2 = 0; ///< of its size
    Eigen::Vector3d uniform_nT = Eigen::Vector3d::Zero(), uniformError_nT = Eigen::Vector3d::Zero();
    double rms_nT = 0;             ///< of what is left, a component
    double nearest_m = 0;          ///< of the readings
    std::optional<TwoSources> two; ///< where chance does not explain how much less they leave: the errors of the one then reach to them
    std::vector<Message> warnings;
    [[nodiscard]] Eigen::Vector3d fieldAt_nT(const Eigen::Vector3d& at_m) const; ///< without the uniform field
};

/// Least squares: moment and uniform field follow linearly from a place, the place by damped Gauss–Newton from many beginnings. A second dipole
/// is tried (F test), and whether neighbours leave the same over: errors are those of noise only where noise is what is left.
/// @param length_m of the source, where it is known; 0: not. Errors: InvalidInput (fewer than five readings, two at one place), Numeric (no
/// place explains them better than none).
Result<DipoleSource> locateDipole(std::span<const StrayReading> readings, double length_m = 0);

/// How near things may stand to a flux gate, as its maker asks [Garmin, installation manual of the GMU 11/44].
struct InstallationDistance {
    Pattern thing;
    double least_m = 0;
};
[[nodiscard]] std::span<const InstallationDistance> installationDistances();

} // namespace lubberline
