#pragma once
/// Private to db: the results that are kept beside the readings, held against what the readings give.

#include "db/transfer/Maintenance.h"

namespace lubberline::db {

/// Counts swings and readings; adds a finding for each swing whose kept results are others, and a note for each whose results are to be
/// computed yet. Errors: Cancelled; those of a drive.
Result<void> checkResults(Database& database, VerifyReport& report, const Progress& progress);

} // namespace lubberline::db
