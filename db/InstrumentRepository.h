#pragma once
/// Datum instruments, known by their RecordId.

#include <vector>

#include "core/record/DatumInstrument.h"
#include "db/Database.h"

namespace lubberline::db {

class InstrumentRepository {
public:
    explicit InstrumentRepository(Database& database) : m_database(database) {}

    Result<std::vector<DatumInstrument>> instruments(); ///< by name
    /// A record id is made when empty. Errors: Conflict when another has the name; InvalidInput when that is empty.
    Result<void> save(const DatumInstrument& instrument);
    Result<void> remove(const RecordId& record); ///< Errors: NotFound

private:
    Database& m_database;
};

} // namespace lubberline::db
