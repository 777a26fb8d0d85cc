#pragma once

#include <string>

#include "db/engine/Database.h"

namespace lubberline::db {

/// Appends an entry (what was done to which record, and how it was before and after); inside the caller's transaction.
Result<void> audit(Database& database, const std::string& what, const std::string& record, const std::string& detail);

} // namespace lubberline::db
