#pragma once
/// A as human error: by base and by crew, before and after a date, and watched in the order of time.

#include <string>
#include <vector>

#include "core/fleet/ControlChart.h"
#include "core/fleet/FleetCurves.h"
#include "core/fleet/Proportion.h"

namespace lubberline {

struct GroupOfA {
    std::string name;
    std::int64_t swings = 0, aircraft = 0;
    double meanA_deg = 0, meanAbsA_deg = 0;
    Interval meanAbsA95_deg; ///< by compasses: swings of one compass are no independent witnesses
};

struct SideOfDate {
    std::int64_t swings = 0;
    double meanA_deg = 0, meanAbsA_deg = 0, standardDeviation_deg = 0;
};

/// |A| before and after a date (training, a new datum, another crew).
struct DateComparison {
    int day = 0;            ///< the first of "after"
    int lastBefore_day = 0; ///< the last swing before it: where it was looked for, the change lies between the two
    bool given = false;     ///< the date was given, not looked for
    SideOfDate before, after;
    double change = 0; ///< of the mean |A|, as a share of it before: −0.8 is a fall by 80 %
    Interval change95;
    double p = 1; ///< of a difference; where it was looked for, over all dates (Bonferroni)
    std::int64_t compassesOnBothSides = 0;
    std::optional<double> changeWithin; ///< the same of compasses that have swings on both sides alone
};

/// Something that the control charts tell of a base or crew: one alarm from where a chart first rings to where the last rings on the
/// same side, as long as the average has not come back to the middle between.
struct ChartAlarm {
    bool crew = false; ///< of a crew, else of a base
    std::string name;
    bool ewma = false, cusum = false; ///< which charts rang
    int day = 0, last_day = 0;
    std::uint32_t row = 0; ///< the swing at which it rang first
    double level_deg = 0;  ///< where the average of A (EWMA) stood while it rang, farthest from the middle
    bool high = false;
};

struct ChartWatch {
    ChartLimits limits;
    double ewmaFalseAlarmAfter = 0, cusumFalseAlarmAfter = 0; ///< swings on average, without a shift
    double ewmaShiftFoundAfter = 0, cusumShiftFoundAfter = 0; ///< at a shift of one standard deviation
    double centre_deg = 0, sigma_deg = 0;                     ///< median of A and 1.4826 MAD of the selection
    std::vector<ChartAlarm> alarms;                           ///< by day
};

struct PlantReport {
    std::vector<GroupOfA> bySite, byCrew;   ///< by name
    std::optional<DateComparison> training; ///< none: no date was given and none is told by the data (p < 0.01)
    std::optional<ChartWatch> charts;
};

[[nodiscard]] PlantReport plantsOf(
    const FleetSwings& fleet, const FleetCurves& curves, std::optional<SwingStage> stage, std::optional<int> trainingDay);

} // namespace lubberline
