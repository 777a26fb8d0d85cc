#pragma once
/// The steps of our schema, and databases of ours opened at the newest.

#include <vector>

#include "db/engine/Database.h"

namespace lubberline::db {

[[nodiscard]] const std::vector<Migration>& migrations();
/// The newest schema that this program knows.
[[nodiscard]] int schemaVersion();

/// Errors: those of Database::open().
Result<Database> openDatabase(const QString& path, OpenMode mode);

} // namespace lubberline::db
