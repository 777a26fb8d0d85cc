#pragma once
/// The records that there are, held against those that the audit trail tells of.

#include <vector>

#include "core/base/Result.h"
#include "db/engine/Database.h"

namespace lubberline::db {

/// Each record whose last entry does not remove it is there; each that is there has an entry, where the trail began with the file; and the
/// station's keys are those that the trail says were added.
Result<std::vector<Message>> recordFaults(Database& database);

} // namespace lubberline::db
