#pragma once
/// Electrical swings of remote compasses, known by their RecordId.

#include <vector>

#include "core/record/ElectricalSwing.h"
#include "core/record/Fleet.h"
#include "db/Database.h"

namespace lubberline::db {

class ElectricalRepository {
public:
    explicit ElectricalRepository(Database& database) : m_database(database) {}

    Result<std::vector<ElectricalSwing>> of(CompassId compass); ///< newest first. Errors: Corrupt (one that does not read)
    /// A record id is made when empty.
    Result<void> save(CompassId compass, const ElectricalSwing& swing);

private:
    Database& m_database;
};

} // namespace lubberline::db
