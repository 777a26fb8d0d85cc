#pragma once
/// The figures of a fleet report as tables and sentences, the same for paper, HTML and the pages of the window.

#include <QStringList>

#include <vector>

#include "core/fleet/FleetReport.h"
#include "core/fleet/FleetSelection.h"
#include "ui/report/page/Table.h"

namespace lubberline::ui {

/// "Su-22 · standby compass · from 2020-01-01"; "all swings" where nothing is chosen.
[[nodiscard]] QString wordsFor(const FleetSelection& selection, const FleetOptions& options);

/// The report in a few sentences for somebody who does not know the program.
[[nodiscard]] QStringList fleetSummary(const FleetReport& report, const FleetSwings& fleet);
/// How each figure was made, and what it does not say.
[[nodiscard]] QStringList fleetMethods(const FleetReport& report);

[[nodiscard]] Table patternTable(const FleetReport& report);
[[nodiscard]] Table fleetCoefficientTable(const FleetReport& report, const FleetSwings& fleet);
/// D and E of each type as its standard soft-iron correction, and what its next aircraft is expected to have.
[[nodiscard]] Table softIronTable(const FleetReport& report);
/// The highest and lowest amplitude (order 0 apart) are marked and named, as in the paper's table.
[[nodiscard]] Table fleetHarmonicTable(const FleetReport& report);
[[nodiscard]] Table exceedanceTable(const FleetReport& report);
[[nodiscard]] Table varianceTable(const FleetReport& report);
[[nodiscard]] Table plantTable(const FleetReport& report);
/// What the control charts of A rang for, in words, and how often they ring for nothing.
[[nodiscard]] Table alarmTable(const FleetReport& report);
[[nodiscard]] Table jumpTable(const FleetReport& report, const FleetSwings& fleet);
[[nodiscard]] Table driftTable(const FleetReport& report, const FleetSwings& fleet);
/// @param most  rows at the head; 0: all.
[[nodiscard]] Table rankingTable(const FleetReport& report, const FleetSwings& fleet, std::size_t most);
/// How many compasses stand how near to their limit.
[[nodiscard]] Table binTable(const FleetReport& report);

} // namespace lubberline::ui
