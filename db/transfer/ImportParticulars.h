#pragma once
/// Private to db: all of a fleet but its swings into a database. What is known by its record id, else by its name, is left as it is.

#include <map>

#include "core/record/Fleet.h"
#include "db/engine/Database.h"

namespace lubberline::db {

/// Ids of the fleet's own numbering → ids in the database.
struct ImportedIds {
    std::map<LimitsProfileId, LimitsProfileId> limits;
    std::map<SiteId, SiteId> sites;
    std::map<AircraftTypeId, AircraftTypeId> types;
    std::map<AircraftId, AircraftId> aircraft;
    std::map<CompassId, CompassId> compasses;
    std::map<EventId, EventId> events;
    int newAircraft = 0;
};

template <class IdType>
IdType translated(const std::map<IdType, IdType>& known, IdType id)
{
    const auto found = known.find(id);
    return found == known.end() ? IdType{} : found->second;
}

/// Inside the caller's transaction. Errors: those of the stores.
Result<ImportedIds> importParticulars(Database& database, const Fleet& fleet);

} // namespace lubberline::db
