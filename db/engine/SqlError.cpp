#include "db/engine/SqlError.h"

#include <array>

namespace lubberline::db {

namespace {

// SQLite's primary result codes (sqlite.org/rescode.html); extended codes keep them in their low byte.
constexpr int kBusy = 5, kLocked = 6, kReadOnly = 8, kIoError = 10, kCorrupt = 11, kFull = 13, kCannotOpen = 14, kConstraint = 19,
              kNotADatabase = 26;
// Extended codes of constraints.
constexpr int kCheck = 275, kForeignKey = 787, kNotNull = 1299, kTrigger = 1811;

/// What SQLite names in "UNIQUE constraint failed: …", in words.
struct UniqueName {
    const char* columns;
    const char* words;
};
constexpr std::array kUniqueNames{
    UniqueName{"aircraft_type.name", "an aircraft type of this name"},
    UniqueName{"aircraft.registration", "an aircraft of this registration"},
    UniqueName{"compass.aircraft_id, compass.name", "a compass of this name on this aircraft"},
    UniqueName{"site.name", "a site of this name"},
    UniqueName{"limits_profile.name", "a limits profile of this name"},
    UniqueName{".record", "a record of this identity"},
};

Error constraintError(int code, const std::string& detail, const std::string& file)
{
    switch (code) {
    case kTrigger: // ours: what the triggers say is in the schema
        if (detail.find("signed") != std::string::npos)
            return {ErrorCode::Frozen, "the swing is signed and frozen; expected a new revision instead of a change", file};
        return {ErrorCode::Frozen, detail + "; expected no change of it", file};
    case kCheck:
        return {
            ErrorCode::InvalidInput, "a value is outside its range; expected one that fits " + detail.substr(detail.find(':') + 1), file};
    case kForeignKey:
        return {ErrorCode::Conflict, "the record refers to another that is not in the database, or is still referred to", file};
    case kNotNull:
        return {ErrorCode::InvalidInput,
            "something that is needed is not stated (" + detail.substr(detail.find(':') + 2) + "); expected a value", file};
    default:
        for (const auto& [columns, words] : kUniqueNames)
            if (detail.find(columns) != std::string::npos)
                return {ErrorCode::Conflict, std::string("there is ") + words + " already; expected another", file};
        return {ErrorCode::Conflict, "the record contradicts another in the database (" + detail + ")", file};
    }
}

} // namespace

Error errorOf(const QSqlError& error, const QString& path)
{
    const std::string file = path.toStdString();
    const std::string detail = error.databaseText().toStdString();
    const int code = error.nativeErrorCode().toInt();
    switch (code & 0xFF) {
    case kBusy:
    case kLocked:
        return {ErrorCode::Locked,
            "another program is writing to the database; expected it to be free: close the other program or try again", file};
    case kReadOnly: return {ErrorCode::ReadOnly, "the database may only be read; expected a file and folder that may be written", file};
    case kIoError:
        return {ErrorCode::Io, "the drive failed while the database was read or written (" + detail + "); expected a drive that is there",
            file};
    case kCorrupt: return {ErrorCode::Corrupt, "the database is damaged (" + detail + "); expected a whole one: restore a backup", file};
    case kFull: return {ErrorCode::Full, "the drive is full; expected room for the database: free some space", file};
    case kCannotOpen:
        return {ErrorCode::Io, "the database cannot be opened; expected a file in a folder that is there and may be read", file};
    case kNotADatabase: return {ErrorCode::Format, "this is not a Lubberline database; expected an SQLite file made by this program", file};
    case kConstraint: return constraintError(code, detail, file);
    default: return {ErrorCode::Io, "the database refused (" + detail + ")", file};
    }
}

} // namespace lubberline::db
