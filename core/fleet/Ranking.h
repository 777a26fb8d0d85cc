#pragma once
/// Which compass to swing next: the chance that it is out of limits before its next date. Each coefficient is a level that wanders and
/// drifts (a Kalman filter of two states over the compass's swings), and begins as its type's population does: a compass with a single
/// swing is shrunk to its type and does not head the list for its noise. What is not known grows with time.

#include <vector>

#include "core/fleet/FleetChanges.h"

namespace lubberline {

struct RankingOptions {
    int today_day = 0;
    std::optional<double> limit_deg; ///< for all; none: each compass's own
    int interval_days = 0;           ///< from the last swing to the next where no rule says; 0: the median of the fleet's own
};

enum class RankReason { OutNow, Drift, Jump, NearLimit, FewSwings, LongAgo, Steady };

struct RankedCompass {
    std::int32_t compass = 0;
    double probability = 0; ///< of being out of limits at some time up to by_day
    int by_day = 0;
    FiveTerms expected_deg{}; ///< on by_day
    FiveTerms standardDeviation_deg{};
    FiveTerms drift_deg_year{};
    double largestExpected_deg = 0; ///< of the curve expected on by_day
    double limit_deg = 0;
    RankReason reason = RankReason::Steady;
    std::size_t coefficient = 0; ///< that the reason speaks of
    double figure = 0;           ///< of the reason: deg/year, deg, swings or years
    int swings = 0;
    int lastSwing_day = 0;
    /// Days by which the limit is reached in 5, 50 and 95 of 100 futures, up to twenty years on; none: not reached in that time.
    std::optional<int> reached5_day, reached50_day, reached95_day;
    /// Share of the futures in which it was reached by the end of each quarter of a year from the last swing on, the first at that swing
    /// itself; empty where it is not looked for: far from its limit.
    std::vector<double> reachedShare;
};

struct Ranking {
    std::vector<RankedCompass> compasses;           ///< the most probable first
    std::size_t withoutLimit = 0, withoutCurve = 0; ///< that could not be ranked
};

/// Errors: Cancelled.
Result<Ranking> rankingOf(const FleetSwings& fleet, const FleetCurves& curves, std::span<const CompassHistory> histories,
    const FleetChanges& changes, const RankingOptions& options, const Progress& progress = {});

[[nodiscard]] Message inWords(const RankedCompass& ranked);

} // namespace lubberline
