#pragma once
/// Aircraft types, aircraft, compass systems and events.

#include <vector>

#include "core/record/Aircraft.h"
#include "core/record/FleetRows.h"
#include "db/Database.h"

namespace lubberline::db {

class FleetRepository {
public:
    explicit FleetRepository(Database& database) : m_database(database) {}

    Result<Totals> totals();
    Result<std::vector<TypeRow>> types();                             ///< by name
    Result<std::vector<AircraftRow>> aircraftOf(AircraftTypeId type); ///< by registration
    Result<std::vector<CompassRow>> compassesOf(AircraftId aircraft); ///< by name
    /// Each word must be found in type, registration or compass, or in date, site, note or people of a swing. Aircraft first,
    /// then compasses, then swings, the newest first; `limit` in all.
    Result<std::vector<SearchHit>> search(const std::string& words, int limit);

    Result<AircraftType> type(AircraftTypeId id);
    Result<Aircraft> aircraft(AircraftId id);
    Result<CompassSystem> compass(CompassId id);
    Result<std::vector<Event>> eventsOf(AircraftId id); ///< newest first
    /// Errors: NotFound.
    Result<AircraftId> aircraftNamed(const std::string& registration);

    /// Inserts (id not valid; a record id is made when empty) or updates; one transaction with its audit entry.
    /// Errors: Conflict when another record has the name, InvalidInput when a name is empty.
    Result<AircraftTypeId> save(const AircraftType& type);
    Result<AircraftId> save(const Aircraft& aircraft);
    Result<CompassId> save(const CompassSystem& compass);
    Result<EventId> save(const Event& event);

private:
    Database& m_database;
};

} // namespace lubberline::db
