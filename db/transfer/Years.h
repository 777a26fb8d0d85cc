#pragma once
/// Records of years on paper (core/format/csv/YearsCsv.h) into a database, one swing after the other, whatever their number.

#include <memory>
#include <span>
#include <vector>

#include "core/base/Date.h"
#include "core/format/csv/YearsCsv.h"
#include "db/engine/Database.h"

namespace lubberline::db {

/// Rows that one import made: it was the only one to write then, so they have no others between.
struct MadeRows {
    std::int64_t first = 0, last = 0; ///< ids; 0: none
};

/// What an import made, by which it is undone as one step.
struct YearsMade {
    std::string name; ///< of the table
    MadeRows types, aircraft, compasses, sites, swings;
    std::int64_t lastAudit = 0; ///< what is written in the audit trail after it is not of this import
};

struct YearsOutcome {
    int types = 0, aircraft = 0, compasses = 0, sites = 0; ///< new ones
    std::int64_t swings = 0, readings = 0;                 ///< new ones
    std::int64_t alreadyThere = 0;                         ///< swings that were stored before
    std::int64_t drafts = 0; ///< of the new ones: something is missing for them to be complete (core/record/Completeness.h)
    std::vector<Message> warnings;
    std::vector<Message> suspicions; ///< compasses whose D says that their records are of the other sign (core/fleet/SignCheck.h)
    YearsMade made;
};

enum class YearsStep {
    Store, ///< all of it in one transaction, or nothing
    Look,  ///< nothing is stored: what would be
};

/// What is known already is left as it is: a type, aircraft or site by its name, a compass by its name on its aircraft, a swing by its
/// contents. Whole swings come in as complete, others as drafts. @param today UTC. Errors: those of the reader and the stores.
Result<YearsOutcome> importYears(Database& database, YearsReader& reader, YearsStep step, Date today);

/// All of several tables, or nothing.
Result<std::vector<YearsOutcome>> importYears(Database& database, std::span<const std::unique_ptr<YearsReader>> readers, Date today);

/// Takes out what an import made, and of that nothing that others use by now. @return swings taken out. Errors: Conflict (one of its
/// swings was changed since; nothing is undone).
Result<std::int64_t> undoYears(Database& database, const YearsMade& made);

} // namespace lubberline::db
