#pragma once

#include "db/engine/Database.h"

namespace lubberline::db {

/// Writes a whole copy of the file as it is, while it is in use; not inside a transaction. Written beside and renamed: no half copy is
/// left, and it is on the drive when this returns. Errors: Conflict when the file exists already, Io (folder missing or not writable), Full.
Result<void> copyTo(const Database& database, const QString& path);

/// Without a name of its own first, into a folder that nobody else sees.
Result<void> copyInto(const Database& database, const QString& path);

} // namespace lubberline::db
