#pragma once
/// Backup, verification and status of a database.

#include <string>
#include <vector>

#include "core/base/Progress.h"
#include "core/record/FleetRows.h"
#include "db/Database.h"

namespace lubberline::db {

/// Writes a whole copy while the database is in use. Written beside and renamed: no half copy is left.
/// Errors: Conflict when the file exists already, Io, Full.
Result<void> backup(Database& database, const QString& path);

struct VerifyReport {
    std::int64_t swings = 0;
    std::int64_t readings = 0;
    std::vector<std::string> findings; ///< empty: all is well
};

/// SQLite's integrity check, foreign keys, and every cached result recomputed from its readings. Changes nothing.
Result<VerifyReport> verify(Database& database, const Progress& progress);

struct DatabaseStatus {
    std::string path;
    std::int64_t bytes = 0;
    int schema = 0;
    std::string journal;
    Totals totals;
    std::int64_t readings = 0;
    std::int64_t auditEntries = 0;
};
Result<DatabaseStatus> status(Database& database);

} // namespace lubberline::db
