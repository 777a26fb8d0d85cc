#pragma once
/// Whole fleets into and out of a database.

#include <vector>

#include "core/base/Progress.h"
#include "core/record/Fleet.h"
#include "db/Database.h"

namespace lubberline::db {

struct Imported {
    int aircraft = 0;     ///< new ones
    int swings = 0;       ///< new ones
    int alreadyThere = 0; ///< swings that were stored before, unchanged
    std::vector<SwingId> swingIds; ///< of all swings of the fleet, new or not
};

/// Stores all of a fleet in one transaction, or nothing. A record is known by its RecordId, else by its name (type, registration,
/// compass on its aircraft, site, limits profile); particulars of what is known already are left as they are.
/// Errors: Conflict when a swing with the same record id has other contents (aircraft and date are named); Cancelled.
Result<Imported> importFleet(Database& database, const Fleet& fleet, const Progress& progress);

/// The fleet, or these aircraft, with all that they refer to. Errors: NotFound, Cancelled.
Result<Fleet> exportFleet(Database& database, const std::vector<AircraftId>& aircraft, const Progress& progress);

} // namespace lubberline::db
