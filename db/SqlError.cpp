#include "db/SqlError.h"

namespace lubberline::db {

namespace {

// SQLite's primary result codes (sqlite.org/rescode.html); extended codes keep them in their low byte.
constexpr int kBusy = 5, kLocked = 6, kReadOnly = 8, kIoError = 10, kCorrupt = 11, kFull = 13, kCannotOpen = 14, kConstraint = 19,
              kNotADatabase = 26;

} // namespace

Error errorOf(const QSqlError& error, const QString& path)
{
    const std::string file = path.toStdString();
    const std::string detail = error.databaseText().toStdString();
    switch (error.nativeErrorCode().toInt() & 0xFF) {
    case kBusy:
    case kLocked:
        return {ErrorCode::Locked, "another program is writing to the database; expected it to be free: close the other program or try again", file};
    case kReadOnly:
        return {ErrorCode::ReadOnly, "the database may only be read; expected a file and folder that may be written", file};
    case kIoError:
        return {ErrorCode::Io, "the drive failed while the database was read or written (" + detail + "); expected a drive that is there", file};
    case kCorrupt:
        return {ErrorCode::Corrupt, "the database is damaged (" + detail + "); expected a whole one: restore a backup", file};
    case kFull:
        return {ErrorCode::Full, "the drive is full; expected room for the database: free some space", file};
    case kCannotOpen:
        return {ErrorCode::Io, "the database cannot be opened; expected a file in a folder that is there and may be read", file};
    case kNotADatabase:
        return {ErrorCode::Format, "this is not a Lubberline database; expected an SQLite file made by this program", file};
    case kConstraint:
        if (detail.find("signed") != std::string::npos)
            return {ErrorCode::Frozen, "the swing is signed and frozen; expected a new revision instead of a change", file};
        return {ErrorCode::Conflict, "the record contradicts another in the database (" + detail + ")", file};
    default:
        return {ErrorCode::Io, "the database refused (" + detail + ")", file};
    }
}

} // namespace lubberline::db
