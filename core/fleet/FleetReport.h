#pragma once
/// Everything that is told of a selection: one value, which page, report and command show.

#include "core/fleet/Exceedance.h"
#include "core/fleet/FleetChanges.h"
#include "core/fleet/Pattern.h"
#include "core/fleet/Plants.h"
#include "core/fleet/Ranking.h"
#include "core/fleet/SoftIron.h"
#include "core/fleet/VarianceComponents.h"

namespace lubberline {

struct FleetOptions {
    int grid = 8;
    FleetVote vote = FleetVote::Aircraft;
    std::optional<SwingStage> stage = {}; ///< of pattern, coefficients, bases and variance; pairs and histories need both
    std::optional<double> limit_deg = {}; ///< for all; none: each compass's own
    std::optional<int> training_day = {}; ///< a date to compare A before and after; none: it is looked for
    int today_day = 0;
    bool changes = true;  ///< jumps, drifts and who next: of a part of a selection they would be others
    bool variance = true; ///< takes the longest
};

struct FleetCounts {
    std::int64_t aircraft = 0, compasses = 0, swings = 0, used = 0;
    std::vector<SwingsLeftOut> leftOut; ///< why the others are not used
};

/// Variance components of one coefficient, or why there are none.
struct CoefficientVariance {
    std::optional<VarianceReport> report;
    Message why; ///< empty with a report
};

struct FleetReport {
    FleetOptions options;
    FleetCounts counts;
    FleetCurves curves; ///< of the columns' swings
    PopulationPattern pattern;
    std::vector<HarmonicOrder> found, left; ///< of the mean as found and as left; empty where there are no such swings
    Exceedance exceedance;
    std::array<CoefficientVariance, kCoefficientCount> variance;
    PlantReport plants;
    std::vector<SoftIronStandard> softIron; ///< of all swings, found and left: corrections leave it
    std::vector<CompassHistory> histories;  ///< in the order of the columns
    FleetChanges changes;
    Ranking ranking;
    std::vector<Message> warnings;
};

/// The columns must be in order (putInOrder). Errors: InvalidInput (no swing is left, a grid out of range), Cancelled.
Result<FleetReport> fleetReportOf(const FleetSwings& fleet, const FleetOptions& options, const Progress& progress = {});

/// Of all that, only who to swing next, each compass against its own limit: what the due list takes. Without a swing: nobody.
/// Errors: Cancelled.
Result<Ranking> swingNext(const FleetSwings& fleet, int today_day, const Progress& progress = {});

/// "A jumped by +2.1°" and the like in one line each.
[[nodiscard]] Message inWords(const FleetJump& jump, const FleetSwings& fleet);
[[nodiscard]] Message inWords(const ChartAlarm& alarm);
/// What the comparison tells, and what it cannot.
[[nodiscard]] std::vector<Message> inWords(const DateComparison& comparison);

} // namespace lubberline
