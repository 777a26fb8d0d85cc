#pragma once
/// Electrical swings of remote compasses, known by their RecordId.

#include <vector>

#include "core/record/ElectricalSwing.h"
#include "core/record/Fleet.h"
#include "db/engine/Database.h"

namespace lubberline::db {

class ElectricalStore {
public:
    explicit ElectricalStore(Database& database) : m_database(database) {}

    Result<std::vector<ElectricalSwing>> of(CompassId compass); ///< newest first. Errors: Corrupt (one that does not read)
    /// A record id is made when empty.
    Result<RecordId> add(CompassId compass, const ElectricalSwing& swing);
    /// @param known as the caller knows it. Errors: NotFound; Conflict when it is another by now.
    Result<void> change(CompassId compass, const ElectricalSwing& known, const ElectricalSwing& swing);
    Result<void> remove(CompassId compass, const RecordId& record); ///< Errors: NotFound

private:
    Database& m_database;
};

} // namespace lubberline::db
