#pragma once
/// What would remain of the deviation if some components were taken out: the source's before and after [P, Fig. 14].

#include <vector>

#include "core/swing/Analysis.h"

namespace lubberline {

struct Removal {
    std::vector<double> remaining_rad; ///< deviation read − the removed components at its compass heading, wrapped; as the readings
    double maxAbs_rad = 0;
    double rms_rad = 0;
    Harmonics harmonics; ///< of what remains, on magnetic heading
};

/// δ_i − Σ removed components of the approximate fit, B sin ψ'_i etc. [P 4].
/// Errors: Numeric when a removed coefficient could not be told from the headings.
Result<Removal> removeComponents(const Analysis& analysis, CoefficientSet removed);

} // namespace lubberline
