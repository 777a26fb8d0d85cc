#pragma once
/// Whole fleets into and out of a database.

#include <vector>

#include "core/base/Progress.h"
#include "core/record/Fleet.h"
#include "db/engine/Database.h"

namespace lubberline::db {

struct Imported {
    int aircraft = 0;              ///< new ones
    int swings = 0;                ///< new ones
    int alreadyThere = 0;          ///< swings that were stored before, unchanged
    std::vector<SwingId> swingIds; ///< of all swings of the fleet, new or not
    std::vector<Message> warnings; ///< signatures that do not hold here, and signed swings that nobody signed
};

/// Stores all of a fleet in one transaction, or nothing. A record is known by its RecordId, else by its name (type,
/// registration, compass on its aircraft, sensor model of its compass, site, limits profile); what is known already is left as
/// it is. A swing without a field stamp is the same as a stored one that has got one since; so is one whose stamp has other
/// figures for the same place and date, which are those of another model. Errors: Conflict when a swing with the same record id
/// has other contents (aircraft and date are named); Corrupt when a signed swing is not what was signed; Cancelled.
Result<Imported> importFleet(Database& database, const Fleet& fleet, const Progress& progress);
/// All of several fleets, or nothing.
Result<Imported> importAll(Database& database, const std::vector<Fleet>& fleets, const Progress& progress);

/// The fleet, or these aircraft, with all that they refer to. Errors: NotFound, Cancelled.
Result<Fleet> exportFleet(Database& database, const std::vector<AircraftId>& aircraft, const Progress& progress);

} // namespace lubberline::db
