#pragma once
/// What a coefficient of one swing is worth beside its own readings: crews, bases and the compass itself scatter it from swing to swing.

#include <memory>
#include <vector>

#include "core/fleet/FleetCurves.h"
#include "core/fleet/ScatterPosterior.h"

namespace lubberline {

inline constexpr double kMedianOfChiSquare = 0.454936423119572; ///< one degree of freedom

/// Of one kind of compass and one coefficient, from what happened between swings without a correction between them.
struct ChangeScatter {
    std::size_t increments = 0;
    double swingVariance_deg2 = 0;       ///< of a swing beyond its fit; by the median, which jumps do not move
    double walkVariance_deg2_year = 0;   ///< by which a coefficient wanders in a year, jumps included
    double wanderVariance_deg2_year = 0; ///< likewise by the median, which jumps do not move: what is wandered is no jump and no drift
    bool known = false; ///< increments enough to take these as known; else they are means of what the posterior leaves possible
    std::shared_ptr<const ScatterPosterior> posterior = {}; ///< where they are not known
    /// Trends are larger than their errors throughout the kind: then a jump is only what no trend explains.
    bool driftIsCommon = false;
    /// Of A where crews were trained: from this day on their errors are others, and what it does at that day is theirs.
    std::optional<int> crews_day = {};
    double laterVariance_deg2 = 0;
    double laterShare = 1; ///< the same as a share of what it was before

    [[nodiscard]] bool isLater(int day) const { return crews_day && day >= *crews_day; }
    [[nodiscard]] double varianceAt(int day) const { return isLater(day) ? laterVariance_deg2 : swingVariance_deg2; }
};

/// The coefficient of a compass's swings as a dated series; `rows` are the swings.
struct CoefficientSeries {
    std::vector<DatedValue> values;
    std::vector<std::uint32_t> rows;
};
[[nodiscard]] CoefficientSeries seriesOf(
    const FleetSwings& fleet, const FleetCurves& curves, const CompassHistory& history, std::size_t c, const ChangeScatter& scatter);

/// As it stands without what its kind scatters by: variances of the fits alone.
[[nodiscard]] std::vector<DatedValue> bareSeriesOf(
    const FleetSwings& fleet, const FleetCurves& curves, const CompassHistory& history, std::size_t c, const ChangeScatter& scatter);

/// By kind and coefficient. @param crews_day  from which A is read by other crews, or by trained ones (Plants.h). Errors: Cancelled.
Result<std::vector<std::array<ChangeScatter, kCoefficientCount>>> scattersOf(const FleetSwings& fleet, const FleetCurves& curves,
    std::span<const CompassHistory> histories, std::optional<int> crews_day, const Progress& progress);

} // namespace lubberline
