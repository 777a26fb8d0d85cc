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
    std::vector<Message> warnings; ///< moves that could not be predicted
    [[nodiscard]] int due() const; ///< lines that are due or overdue
};

/// @param today UTC. Errors: those of the stores; Cancelled.
Result<DueNews> dueNews(db::Stores& stores, Date today, const Progress& progress);

} // namespace lubberline::ui
