#pragma once
/// Backup, verification and status of a database.

#include <string>
#include <vector>

#include "core/base/Progress.h"
#include "core/record/FleetRows.h"
#include "db/chain/ChainCheck.h"
#include "db/engine/Database.h"

namespace lubberline::db {

/// Writes a whole copy of the file as it is, in an old schema too, while it is in use; not inside a transaction. Written beside and
/// renamed: no half copy is left, and it is on the drive when this returns. Errors: Conflict when the file exists already, Io (folder missing or not
/// writable), Full; Corrupt: the copy is there, but what was copied is damaged.
Result<void> backup(Database& database, const QString& path);

/// Puts a copy of a backup in the place of a database, which is kept as `aside`. The backup stays as it is; one of an older program is
/// brought up to date in its copy. Errors: those of opening the backup; Conflict when `aside` exists; Locked while somebody has the
/// database open; Io, Full. Then nothing was changed.
Result<void> restore(const QString& backup, const QString& path, const QString& aside);

struct VerifyReport {
    std::int64_t swings = 0;
    std::int64_t readings = 0;
    std::vector<Message> findings; ///< empty: all is well
    std::vector<Message> notes;    ///< what is no fault and worth knowing: since when the audit trail is chained, a clock set back
    std::string head;              ///< of the audit trail; note it elsewhere, and it can be held against this file later
    std::int64_t entries = 0;      ///< of the audit trail
};

/// SQLite's integrity check, foreign keys, every value of every row that is not what its column should hold, the chain of the audit trail,
/// every signature, and every cached result recomputed from its readings, all of one moment, whatever others write meanwhile. Changes
/// nothing. What is damaged is a finding. Errors: Cancelled; those of a drive.
/// @param heads  of the audit trail, noted earlier (in a report, a backup, on paper): the trail must hold each.
Result<VerifyReport> verify(Database& database, const Progress& progress, const std::vector<NotedHead>& heads = {});

/// What is wrong with what the lists of swings show: there it is as if it were not stated.
[[nodiscard]] std::vector<Message> listDamages(Database& database);

struct DatabaseStatus {
    std::string path;
    std::int64_t bytes = 0;
    int schema = 0;
    std::string journal;
    Totals totals;
    std::int64_t readings = 0;
    std::int64_t sensorModels = 0;
    std::int64_t auditEntries = 0;
    ChainHead chain;
};
Result<DatabaseStatus> status(Database& database);

} // namespace lubberline::db
