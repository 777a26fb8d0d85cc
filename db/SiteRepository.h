#pragma once
/// Compass bases and limits profiles.

#include <optional>
#include <vector>

#include "core/record/Site.h"
#include "db/Database.h"

namespace lubberline::db {

class SiteRepository {
public:
    explicit SiteRepository(Database& database) : m_database(database) {}

    Result<std::vector<Site>> sites();                   ///< by name
    Result<std::vector<LimitsProfile>> limitsProfiles(); ///< by name
    Result<std::optional<Site>> site(SiteId id);         ///< none when the id is not valid
    /// The limits that apply to a compass, if any.
    Result<std::optional<LimitsProfile>> limitsOf(CompassId compass);

    /// As FleetRepository::save(). A changed limits profile recomputes the status of the compasses that it applies to.
    Result<SiteId> save(const Site& site);
    Result<LimitsProfileId> save(const LimitsProfile& profile);

private:
    Database& m_database;
};

} // namespace lubberline::db
