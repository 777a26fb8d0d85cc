#pragma once
/// What is due, from storage: on a worker thread, with a connection of its own, or straight from the command line.

#include <string>
#include <vector>

#include "core/due/DueList.h"
#include "db/stores/Stores.h"

namespace lubberline::ui {

struct DueNews {
    std::vector<DueLine> lines;
    std::vector<DueRule> rules;
    std::vector<Message> warnings;          ///< moves that could not be predicted
    std::vector<CompassForecast> forecasts; ///< what the lines take of the fleet's history, in the order of compasses
    bool forecastsAreNew = false;           ///< else the fleet has changed since they were made, or they are still to come
    [[nodiscard]] int due() const;          ///< lines that are due or overdue
};

/// What years of swings expect of every compass with a limit. It reads all swings: long in a large fleet.
/// @param today UTC. Errors: those of the stores; Cancelled.
Result<std::vector<CompassForecast>> dueForecasts(db::Stores& stores, Date today, const Progress& progress);

/// @param today UTC. @param forecasts  as they are known. Errors: those of the stores; Cancelled.
Result<DueNews> dueNews(db::Stores& stores, Date today, const Progress& progress, std::vector<CompassForecast> forecasts = {});

} // namespace lubberline::ui
