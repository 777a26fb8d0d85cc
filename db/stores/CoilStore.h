#pragma once
/// Coil benches of the sensors of compasses, known by their RecordId. A bench is what was measured: it is kept or removed, never changed.

#include <optional>
#include <string>
#include <vector>

#include "core/record/CoilBench.h"
#include "db/engine/Database.h"

namespace lubberline::db {

class CoilStore {
public:
    explicit CoilStore(Database& database) : m_database(database) {}

    Result<std::vector<CoilBench>> of(CompassId compass); ///< newest first. Errors: Corrupt (one that does not read)
    /// The newest of the same sensor (serial numbers, where both are stated) that is not after that day; none: there is none.
    Result<std::optional<CoilBench>> before(CompassId compass, Date day, const std::string& serialNumber);
    /// A record id is made when empty.
    Result<RecordId> add(CompassId compass, const CoilBench& bench);
    Result<void> remove(CompassId compass, const RecordId& record); ///< Errors: NotFound

private:
    Database& m_database;
};

} // namespace lubberline::db
