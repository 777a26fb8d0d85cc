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
    Pattern words;
};
constexpr std::array kUniqueNames{
    UniqueName{"aircraft_type.name", MARKED("db", "there is an aircraft type of this name already; expected another")},
    UniqueName{"aircraft.registration", MARKED("db", "there is an aircraft of this registration already; expected another")},
    UniqueName{
        "compass.aircraft_id, compass.name", MARKED("db", "there is a compass of this name on this aircraft already; expected another")},
    UniqueName{"site.name", MARKED("db", "there is a site of this name already; expected another")},
    UniqueName{"limits_profile.name", MARKED("db", "there is a limits profile of this name already; expected another")},
    UniqueName{".record", MARKED("db", "there is a record of this identity already; expected another")},
};

Error constraintError(int code, const std::string& detail, const std::string& file)
{
    switch (code) {
    case kTrigger: // ours: what the triggers say is in the schema
        if (detail.find("signed") != std::string::npos)
            return {ErrorCode::Frozen, MARKED("db", "the swing is signed and frozen; expected a new revision instead of a change"), file};
        return {ErrorCode::Frozen, {MARKED("db", "%1; expected no change of it"), detail}, file};
    case kCheck:
        return {ErrorCode::InvalidInput,
            {MARKED("db", "a value is outside its range; expected one that fits %1"), detail.substr(detail.find(':') + 1)}, file};
    case kForeignKey:
        return {
            ErrorCode::Conflict, MARKED("db", "the record refers to another that is not in the database, or is still referred to"), file};
    case kNotNull:
        return {ErrorCode::InvalidInput,
            {MARKED("db", "something that is needed is not stated (%1); expected a value"), detail.substr(detail.find(':') + 2)}, file};
    default:
        for (const auto& [columns, words] : kUniqueNames)
            if (detail.find(columns) != std::string::npos)
                return {ErrorCode::Conflict, words, file};
        return {ErrorCode::Conflict, {MARKED("db", "the record contradicts another in the database (%1)"), detail}, file};
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
            MARKED("db", "another program is writing to the database; expected it to be free: close the other program or try again"), file};
    case kReadOnly:
        return {ErrorCode::ReadOnly, MARKED("db", "the database may only be read; expected a file and folder that may be written"), file};
    case kIoError:
        return {ErrorCode::Io,
            {MARKED("db", "the drive failed while the database was read or written (%1); expected a drive that is there"), detail}, file};
    case kCorrupt:
        return {ErrorCode::Corrupt, {MARKED("db", "the database is damaged (%1); expected a whole one: restore a backup"), detail}, file};
    case kFull: return {ErrorCode::Full, MARKED("db", "the drive is full; expected room for the database: free some space"), file};
    case kCannotOpen:
        return {
            ErrorCode::Io, MARKED("db", "the database cannot be opened; expected a file in a folder that is there and may be read"), file};
    case kNotADatabase:
        return {ErrorCode::Format, MARKED("db", "this is not a Lubberline database; expected an SQLite file made by this program"), file};
    case kConstraint: return constraintError(code, detail, file);
    default: return {ErrorCode::Io, {MARKED("db", "the database refused (%1)"), detail}, file};
    }
}

} // namespace lubberline::db
