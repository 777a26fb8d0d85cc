#pragma once
/// Loads that push a compass past what may stand on a card without being named there.

#include <string>
#include <vector>

#include "core/record/SwingJob.h"
#include "core/swing/Analysis.h"

namespace lubberline {

/// 14 CFR 23.1547, 25.1547 and 27.1547: a load that makes the deviation exceed this is named on the placard.
inline constexpr double kLoadToName_deg = 10;

struct LoadNote {
    std::string load;
    double heading_deg = 0;   ///< magnetic, of its largest deviation
    double deviation_deg = 0; ///< with the load on; east positive
    friend bool operator==(const LoadNote&, const LoadNote&) = default;
};

/// Of each load of the interference check that pushes |deviation| past `limit_deg`, the heading where it is worst, in the order
/// in which the loads were read. The compass reads more by on − off, so that the deviation is that of the fit less this change.
/// None where the readings allow no fit.
[[nodiscard]] std::vector<LoadNote> loadsPast(const SwingJob& job, const Analysis& analysis, double limit_deg = kLoadToName_deg);

} // namespace lubberline
