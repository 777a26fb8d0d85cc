#pragma once
/// Where files go.

#include <QString>

#include <string>

#include "core/base/Date.h"
#include "core/base/Result.h"

namespace lubberline::app {

/// The database of `--db`, else of LUBBERLINE_DB, else fleet.lubberline in the user's data folder (made when missing).
/// Errors: Unsupported (a postgresql:// address), Io (the data folder cannot be made).
Result<QString> databasePath(const std::string& option);

/// demonstration.lubberline in the user's data folder: the demonstration never mixes with a real fleet.
Result<QString> demonstrationPath(const std::string& option);

/// A path as the name of a file: to SQLite ":memory:" would be a place of its own, and to Qt all that begins with a colon.
[[nodiscard]] QString plainName(const std::string& path);

/// Of a database in the data folder: its files are the user's alone, whatever the umask was that made them.
void keepPrivate(const QString& database);

/// The time now, UTC, ISO 8601: what is printed on documents.
[[nodiscard]] QString nowUtc();
[[nodiscard]] Date today(); ///< UTC

} // namespace lubberline::app
