#pragma once
/// Iron by its coercivity: how easily it takes on magnetism of its own, and loses it. Soft below 50 A/m (transformer sheet, mu-metal),
/// between up to 3000 A/m (structural and tool steel), hard above (magnets).
/// What may drift after a shock, under stress or after a strong current: of soft iron all that it kept; of iron between that too, and what the
/// Earth's field makes in it, which a shock can leave behind; of a magnet nothing but by a field near its own coercivity.

#include <optional>

#include "core/base/Message.h"
#include "core/iron/FerrousPart.h"

namespace lubberline {

inline constexpr double kSoftBelow_A_per_m = 50, kHardAbove_A_per_m = 3000;
/// Of the Earth's, for what a shock leaves behind.
inline constexpr double kShockField_nT = 50000;

enum class IronClass { Soft, Between, Hard };
[[nodiscard]] IronClass ironClassOf(double coercivity_A_per_m);
/// "soft", "between", "hard".
[[nodiscard]] Pattern nameOf(IronClass iron);

struct PartEffect;
/// The size of what may change at the sensor; none where the coercivity is not known.
[[nodiscard]] std::optional<double> mayDrift_nT(const PartEffect& effect);
/// The same in a sentence; empty where nothing may, or where it is not known.
[[nodiscard]] Message driftWarning(const PartEffect& effect);

} // namespace lubberline
