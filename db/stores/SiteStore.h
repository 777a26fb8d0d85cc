#pragma once
/// Compass bases, limits profiles and datum instruments.

#include <optional>
#include <vector>

#include "core/record/DatumInstrument.h"
#include "core/record/Site.h"
#include "db/engine/Database.h"

namespace lubberline::db {

class SiteStore {
public:
    explicit SiteStore(Database& database) : m_database(database) {}

    Result<std::vector<Site>> sites();                   ///< by name
    Result<std::vector<LimitsProfile>> limitsProfiles(); ///< by name
    Result<std::optional<Site>> site(SiteId id);         ///< none when the id is not valid
    /// The limits that apply to a compass, if any.
    Result<std::optional<LimitsProfile>> limitsOf(CompassId compass);

    Result<std::vector<DatumInstrument>> instruments(); ///< by name

    /// As FleetStore::add() and change(). Instruments are known by their RecordId.
    Result<SiteId> add(const Site& site);
    Result<LimitsProfileId> add(const LimitsProfile& profile);
    Result<RecordId> add(const DatumInstrument& instrument);
    Result<void> change(const Site& known, const Site& site);
    /// The status of the compasses that the limits apply to is computed anew.
    Result<void> change(const LimitsProfile& known, const LimitsProfile& profile);
    Result<void> change(const DatumInstrument& known, const DatumInstrument& instrument);
    Result<void> removeInstrument(const RecordId& record); ///< Errors: NotFound
    Result<void> removeSite(const RecordId& record);       ///< Errors: NotFound; Conflict while swings or aircraft are there

private:
    void noteSites();
    Database& m_database;
};

} // namespace lubberline::db
