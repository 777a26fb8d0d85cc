#pragma once
/// How often a compass that was left in limits is found out of them at its next inspection: from pairs (as left, next as found). All swings
/// pooled would mix cut-off and drifted ones.

#include <vector>

#include "core/fleet/FleetCurves.h"
#include "core/fleet/Proportion.h"

namespace lubberline {

struct InspectionPair {
    std::uint32_t leftRow = 0, foundRow = 0; ///< of FleetSwings::swings
};
[[nodiscard]] std::vector<InspectionPair> pairsOf(const FleetSwings& fleet, std::span<const CompassHistory> histories);

struct ExceedanceHeading {
    double heading_deg = 0;
    double expectedShare = 0;   ///< Student prediction at this heading alone
    double threeSigmaShare = 0; ///< mean and standard deviation taken as if they were known
};

struct ExceedanceGroup {
    std::string name; ///< of the type, base or crew
    std::int64_t pairs = 0, exceeded = 0;
    Interval share95; ///< exact (Clopper and Pearson)
};

struct Exceedance {
    std::optional<double> limit_deg; ///< none: each compass was held against its own
    std::int64_t pairs = 0, exceeded = 0;
    std::int64_t withoutLimit = 0;   ///< pairs of compasses whose limit is not known: not counted
    std::optional<Interval> share95; ///< none without pairs
    /// Chance that the largest |deviation| over the headings of the next swing as found is beyond the limit: coefficients drawn from the
    /// Student prediction of those that were found, with their readings' scatter. None with fewer than two pairs, or without one limit.
    std::optional<double> expectedShare;
    std::optional<double> threeSigmaShare; ///< the largest of the headings', as the paper takes it
    std::vector<ExceedanceHeading> headings;
    std::vector<ExceedanceGroup> byType, bySite, byCrew; ///< by name; of the swing as found
};

/// @param limit_deg one for all; none: each compass's own, and the expected share where these are all one.
[[nodiscard]] Exceedance exceedanceOf(
    const FleetSwings& fleet, const FleetCurves& curves, std::span<const InspectionPair> pairs, std::optional<double> limit_deg, int grid);

} // namespace lubberline
