#pragma once
/// D and E of a type: the soft iron of its airframe. They are alike in all its aircraft, and no compensator of magnets takes them out: their
/// mean is the type's standard soft-iron correction, and what its next aircraft is expected to have before anybody has swung it.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/deviation/SlipCheck.h"
#include "core/fleet/FleetCurves.h"
#include "core/fleet/Proportion.h"

namespace lubberline {

struct SoftIronCoefficient {
    int aircraft = 0; ///< each with the mean of its swings
    double mean_deg = 0, standardError_deg = 0;
    double between_deg = 0; ///< standard deviation between aircraft, the fits' own error taken out
    /// Standard deviation of an aircraft that was not swung: √(between² + standard error²), with aircraft − 1 degrees of freedom.
    double next_deg = 0;
    Interval next95_deg; ///< of it, by Student's factor
};

/// Of one kind of compass: those of one type and compass name.
struct SoftIronStandard {
    std::string type, compass;
    std::optional<SoftIronCoefficient> D, E; ///< none where fewer than three aircraft tell it
};

/// By type and compass; kinds that tell neither are left out.
[[nodiscard]] std::vector<SoftIronStandard> softIronOf(const FleetSwings& fleet, const FleetCurves& curves);

/// How an aircraft of the type is expected to deviate before anybody has swung it: A, B and C as of any compass, D and E as its siblings
/// have them, as wide as Student's factor for so few makes them.
[[nodiscard]] ExpectedCurve expectedOf(const SoftIronStandard& standard);

/// "D −2.21° ± 0.09° from 20 aircraft; the next aircraft within −2.40° to −2.02° (95 %)".
[[nodiscard]] Message inWords(const SoftIronCoefficient& coefficient, char letter);

} // namespace lubberline
