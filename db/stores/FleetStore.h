#pragma once
/// Aircraft types, aircraft, compass systems and events.

#include <vector>

#include "core/record/Aircraft.h"
#include "core/record/FleetRows.h"
#include "db/engine/Database.h"

namespace lubberline::db {

class FleetStore {
public:
    explicit FleetStore(Database& database) : m_database(database) {}

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

    /// A new record (a record id is made when empty); one transaction with its audit entry.
    /// Errors: Conflict when another record has the name, InvalidInput when a name is empty.
    Result<AircraftTypeId> add(const AircraftType& type);
    Result<AircraftId> add(const Aircraft& aircraft);
    Result<CompassId> add(const CompassSystem& compass);
    Result<EventId> add(const Event& event);
    /// @param known the record as the caller knows it. Errors: as above; NotFound; Conflict when it is another by now.
    Result<void> change(const AircraftType& known, const AircraftType& type);
    Result<void> change(const Aircraft& known, const Aircraft& aircraft);
    Result<void> change(const CompassSystem& known, const CompassSystem& compass);
    Result<void> change(const Event& known, const Event& event);

private:
    void noteAircraft(AircraftId id);
    void noteEvent(const Event& event);
    Database& m_database;
};

} // namespace lubberline::db
