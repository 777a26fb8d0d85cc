#pragma once
/// Private to db: what the store of swings and its readings (SwingReadings.cpp) share.

#include <span>
#include <vector>

#include "core/record/Swing.h"
#include "db/engine/Database.h"

namespace lubberline::db {

[[nodiscard]] Error isSigned(const Database& database);
/// Without readings and signatures. Errors: NotFound.
Result<Swing> particularsOf(Database& database, SwingId id);
/// The particulars of a swing whose readings may be changed. Errors: NotFound, Frozen.
Result<Swing> openSwing(Database& database, SwingId id);
Result<std::size_t> countOfReadings(Database& database, SwingId swing);
/// Readings one after the other from `position` on, with one prepared statement. @return their ids. Errors: InvalidInput (a text
/// that is too long).
Result<std::vector<ReadingId>> insertReadings(Database& database, SwingId swing, int position, std::span<const Reading> readings);

} // namespace lubberline::db
