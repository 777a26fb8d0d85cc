#pragma once
/// The field of currents, by Biot and Savart [nT/A]. Metres; any one set of axes.

#include <Eigen/Core>

#include "core/iron/FerrousPart.h"

namespace lubberline {

/// A circular loop of radius a, anywhere off the wire, by complete elliptic integrals (W. Smythe, Static and Dynamic
/// Electricity, 3rd ed., section 7.10): with β² = (a + ρ)² + z², α² = (a − ρ)² + z², m = 4aρ/β²
///   B_z = μ0/(2πβ) (K + (a² − ρ² − z²)/α² E),  B_ρ = μ0 z/(2πρβ) (−K + (a² + ρ² + z²)/α² E)
[[nodiscard]] Eigen::Vector3d fieldOfLoop_nT_per_A(const CurrentLoop& loop, const Eigen::Vector3d& at_m);

/// Straight wires one after another; r1, r2 from the ends of each to the place:
///   B = μ0/4π (|r1| + |r2|) / (|r1||r2| (|r1||r2| + r1·r2)) r1 × r2
[[nodiscard]] Eigen::Vector3d fieldOfWire_nT_per_A(const WirePath& path, const Eigen::Vector3d& at_m);

/// How near the conductor passes [m].
[[nodiscard]] double distanceTo(const CurrentLoop& loop, const Eigen::Vector3d& at_m);
[[nodiscard]] double distanceTo(const WirePath& path, const Eigen::Vector3d& at_m);

} // namespace lubberline
