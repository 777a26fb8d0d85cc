#pragma once
/// What a list says of a swing beside its row.

#include "core/record/Swing.h"
#include "db/engine/Database.h"

namespace lubberline::db {

struct SwingMarks {
    RadioState radio = RadioState::NotStated;
    bool somebodySigned = false; ///< it is signed, and not by its state alone
};

/// Errors: NotFound.
Result<SwingMarks> marksOf(Database& database, SwingId swing);

} // namespace lubberline::db
