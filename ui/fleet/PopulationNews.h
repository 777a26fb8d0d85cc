#pragma once
/// What the page of years as a population shows, and how it is made on a worker.

#include <memory>

#include "core/fleet/FleetReport.h"
#include "core/fleet/FleetSelection.h"
#include "db/stores/Stores.h"

namespace lubberline::ui {

struct PopulationNews {
    FleetSwings fleet;
    FleetReport report;
    FleetSelection selection;
    bool firstLook = false; ///< of a part of the swings
};

/// With a connection of its own. Errors: those of the store and of the report; Cancelled.
Result<std::shared_ptr<const PopulationNews>> populationNews(
    const db::Stores& from, const FleetSelection& selection, FleetOptions options, bool firstLook, const Progress& progress);

struct SwingBehind {
    std::size_t row; ///< of the columns
    GridValue value;
};
/// The swings of a heading of the pattern, those farthest from its mean first.
[[nodiscard]] std::vector<SwingBehind> swingsBehind(const PopulationNews& news, double heading_deg);

} // namespace lubberline::ui
