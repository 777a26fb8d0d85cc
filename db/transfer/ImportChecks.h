#pragma once
/// What an import holds against the signatures of a swing that comes in.

#include <vector>

#include "db/engine/Database.h"
#include "db/transfer/Transfer.h"

namespace lubberline::db {

/// In the file itself: a signed swing that is not what was signed does not come in. @param job the guided swing it was made by, or null.
/// Errors: Corrupt.
Result<void> checkSigned(const Database& database, const Fleet& fleet, const Swing& original, const JobRecord* job);

/// What stands in the database now, on the aircraft and compass as they are here: a signature that does not hold is marked wherever it
/// is shown, and told at once. @return what is told.
Result<std::vector<Message>> checkStored(Database& database, const Fleet& fleet, SwingId id, const Swing& original, const JobRecord* job);

} // namespace lubberline::db
