#include "db/transfer/Maintenance.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <functional>

#include "core/record/Id.h"
#include "db/engine/Copy.h"
#include "db/engine/Statement.h"
#include "db/engine/Transaction.h"
#include "db/schema/Schema.h"
#include "db/stores/FleetStore.h"
#include "db/stores/ResultCache.h"
#include "db/stores/SignatureChecks.h"
#include "db/stores/Tables.h"
#include "db/stores/TrailRecords.h"
#include "db/transfer/ResultCheck.h"

namespace lubberline::db {

namespace {

constexpr int kChainedSchema = 8; ///< since when the audit trail is a chain

/// Adds a finding for each row that `sql` answers.
template <class Words>
Result<void> findings(Database& database, VerifyReport& report, const QString& sql, Words words)
{
    Statement statement(database, sql);
    const auto found = rowsOf<Message>(statement, words);
    if (!found)
        return found.error();
    report.findings.insert(report.findings.end(), found->begin(), found->end());
    return {};
}

/// The pages of a file that is read as a copy, too: the copy is made anew of what could be read.
Result<void> checkOriginal(Database& database, VerifyReport& report)
{
    if (!database.readAsCopy())
        return {};
    report.notes.push_back({MARKED("db", "the file has the old schema %1, in which the audit trail is no chain; it was read as a copy"),
        database.fileSchema()});
    auto original = Database::openAsItIs(database.path());
    if (!original)
        return original.error();
    return findings(
        *original, report, "SELECT integrity_check FROM pragma_integrity_check WHERE integrity_check <> 'ok'", [](Statement& row) {
            return Message{MARKED("db", "integrity: %1"), row.text(0)};
        });
}

/// SQLite's own checks (integrity_check holds every row against the CHECKs of its table, too), and what the schema cannot
/// promise.
Result<void> checkStructure(Database& database, VerifyReport& report)
{
    auto done = findings(
        database, report, "SELECT integrity_check FROM pragma_integrity_check WHERE integrity_check <> 'ok'", [](Statement& row) {
            return Message{MARKED("db", "integrity: %1"), row.text(0)};
        });
    if (done)
        done = findings(database, report, "PRAGMA foreign_key_check", [](Statement& row) {
            return Message{MARKED("db", "foreign key: a row of %1 (%2) refers to a missing row of %3"), row.anything(0), row.anything(1),
                row.anything(2)};
        });
    if (done)
        done = findings(database, report,
            "SELECT DISTINCT s.record FROM reading r JOIN swing s ON s.id = r.swing_id GROUP BY r.swing_id, r.position"
            " HAVING COUNT(*) > 1",
            [](Statement& row) {
                return Message{MARKED("db", "order: two readings of the swing %1 are in one place"), row.text(0)};
            });
    return done;
}

Result<void> checkRows(Database& database, VerifyReport& report)
{
    const auto damages = damagedRows(database);
    report.findings.insert(report.findings.end(), damages.begin(), damages.end());
    return {};
}

/// The audit trail and the signatures, each held against the other.
Result<void> checkTrail(Database& database, VerifyReport& report, std::vector<NotedHead> heads)
{
    const auto faults = signatureFaults(database, heads, report.notes, {});
    if (!faults)
        return faults.error();
    for (const auto& fault : *faults)
        report.findings.push_back({MARKED("db", "signature: %1"), fault});
    if (database.readAsCopy() && database.fileSchema() < kChainedSchema)
        return {}; // the chain is one that was made just now, in the copy
    auto chain = checkChain(database, heads);
    if (!chain)
        return chain.error();
    for (auto& finding : chain->findings)
        report.findings.push_back({MARKED("db", "audit trail: %1"), std::move(finding)});
    for (auto& note : chain->notes)
        report.notes.push_back(std::move(note));
    const auto head = chainHead(database);
    if (!head)
        return head.error();
    report.head = head->head;
    report.entries = head->entries;
    return {};
}

/// The records, against those that the trail tells of.
Result<void> checkRecords(Database& database, VerifyReport& report)
{
    const auto faults = recordFaults(database);
    if (!faults)
        return faults.error();
    for (const auto& fault : *faults)
        report.findings.push_back({MARKED("db", "audit trail: %1"), fault});
    return {};
}

/// The badge of a compass is that of its latest swing with a result.
Result<void> checkBadges(Database& database, VerifyReport& report)
{
    return findings(database, report,
        "SELECT a.registration, c.name FROM compass c JOIN aircraft a ON a.id = c.aircraft_id WHERE c.status <> " + statusOfLatest(),
        [](Statement& row) {
            return Message{MARKED("db", "results: the state kept for %1, %2 is not that of its latest swing"), row.text(0), row.text(1)};
        });
}

/// What is copied of a damaged database is as damaged.
Result<void> sayDamage(Database& database, const std::string& copy)
{
    VerifyReport report;
    if (const auto done = checkStructure(database, report); !done)
        report.findings.push_back(done.error().message);
    (void)checkRows(database, report);
    if (report.findings.empty())
        return {};
    return Error{ErrorCode::Corrupt,
        {MARKED("db",
             "the copy is written, but the database is damaged and the copy is as damaged (%1 findings; the first: %2); expected a whole one:"
             " `lubberline db verify` lists them"),
            report.findings.size(), report.findings.front()},
        copy};
}

} // namespace

Result<void> backup(Database& database, const QString& path)
{
    const auto original = database.readAsCopy() ? Database::openAsItIs(database.path()) : Result<Database>(Error{});
    if (database.readAsCopy() && !original)
        return original.error();
    if (const auto copied = copyTo(database.readAsCopy() ? *original : database, path); !copied)
        return copied;
    return sayDamage(database, path.toStdString());
}

namespace {

bool reachesTheDrive(const QString& path)
{
    const int handle = ::open(QFile::encodeName(path).constData(), O_RDONLY | O_CLOEXEC);
    if (handle < 0)
        return false;
    const bool done = ::fsync(handle) == 0;
    ::close(handle);
    return done;
}

/// A copy that is known to be a whole database of ours, of this program's schema; gone with it unless it is taken.
class CheckedCopy {
public:
    explicit CheckedCopy(QString path) : m_path(std::move(path)) {}
    CheckedCopy(const CheckedCopy&) = delete;
    CheckedCopy& operator=(const CheckedCopy&) = delete;
    ~CheckedCopy()
    {
        for (const std::string& file : filesOf(m_path))
            QFile::remove(QString::fromStdString(file));
    }

    /// In the schema of this program; the backup is only read.
    Result<void> copy(const QString& from) const
    {
        auto backup = openDatabase(from, OpenMode::ReadOnly);
        if (!backup)
            return backup.error();
        VerifyReport report;
        if (auto read = checkStructure(*backup, report); !read)
            return read;
        if (!report.findings.empty())
            return Error{ErrorCode::Corrupt, {MARKED("db", "the backup is damaged: %1"), report.findings.front()}, from.toStdString()};
        return copyTo(*backup, m_path);
    }

private:
    QString m_path;
};

/// Taking the log away needs the database for oneself alone.
Result<void> requireNobodyElse(const QString& path)
{
    auto database = openDatabase(path, OpenMode::ReadWriteCreate);
    if (!database)
        return database.error();
    if (database->readOnly())
        return Error{
            ErrorCode::ReadOnly, MARKED("db", "the database may only be read; expected one that may be replaced"), path.toStdString()};
    return execute(*database, "PRAGMA journal_mode = DELETE");
}

} // namespace

Result<void> restore(const QString& backup, const QString& path, const QString& aside)
{
    const bool there = QFileInfo::exists(path);
    if (QFileInfo(backup).canonicalFilePath() == QFileInfo(path).canonicalFilePath() && there)
        return Error{ErrorCode::InvalidInput, MARKED("db", "this is the database itself; expected a backup of it"), path.toStdString()};
    if (there && QFileInfo::exists(aside))
        return Error{ErrorCode::Conflict,
            MARKED("db", "there is a file of this name already; expected a new name for the database as it is now"), aside.toStdString()};
    const QString partial = path + "." + QString::fromStdString(newRecordId()).left(8) + ".partial";
    const CheckedCopy copy(partial);
    if (auto copied = copy.copy(backup); !copied)
        return copied;
    if (there)
        if (auto alone = requireNobodyElse(path); !alone)
            return alone;
    if (there && !QFile::rename(path, aside))
        return Error{
            ErrorCode::Io, MARKED("db", "the database could not be put aside; expected a folder that may be written"), path.toStdString()};
    if (QFile::rename(partial, path) && reachesTheDrive(QFileInfo(path).absolutePath()))
        return {};
    if (there)
        QFile::rename(aside, path);
    return Error{ErrorCode::Io,
        MARKED("db", "the backup could not be put in the place of the database; expected a folder that may be written"),
        path.toStdString()};
}

std::vector<Message> listDamages(Database& database) { return damagedLists(database); }

Result<VerifyReport> verify(Database& database, const Progress& progress, const std::vector<NotedHead>& heads)
{
    const auto snapshot = Transaction::beginReading(database);
    if (!snapshot)
        return snapshot.error();
    VerifyReport report;
    const auto results = [&progress](Database& one, VerifyReport& into) { return checkResults(one, into, progress); };
    const auto trail = [&heads](Database& one, VerifyReport& into) { return checkTrail(one, into, heads); };
    for (const auto& check : std::vector<std::function<Result<void>(Database&, VerifyReport&)>>{
             checkOriginal, checkStructure, checkRows, trail, checkRecords, results, checkBadges}) {
        const auto done = check(database, report);
        if (done)
            continue;
        if (done.error().code != ErrorCode::Corrupt && done.error().code != ErrorCode::NotFound) // a row refers to one that is not there
            return done.error();
        if (std::find(report.findings.begin(), report.findings.end(), done.error().message) == report.findings.end())
            report.findings.push_back(done.error().message); // and what else can be looked at is
    }
    return report;
}

Result<DatabaseStatus> status(Database& database)
{
    const auto snapshot = Transaction::beginReading(database);
    if (!snapshot)
        return snapshot.error();
    DatabaseStatus status;
    status.path = database.path().toStdString();
    status.bytes = QFileInfo(database.path()).size();
    const auto totals = FleetStore(database).totals();
    if (!totals)
        return totals.error();
    status.totals = *totals;
    const auto chain = chainHead(database);
    if (!chain)
        return chain.error();
    status.chain = *chain;
    Statement statement(database,
        "SELECT (SELECT COUNT(*) FROM reading), (SELECT COUNT(*) FROM audit_entry), (SELECT user_version FROM pragma_user_version),"
        " (SELECT journal_mode FROM pragma_journal_mode), (SELECT COUNT(*) FROM sensor_model)");
    return oneOf<DatabaseStatus>(statement, database, MARKED("db", "status"), [&](Statement& row) {
        status.readings = row.integer(0);
        status.auditEntries = row.integer(1);
        status.schema = database.readAsCopy() ? database.fileSchema() : static_cast<int>(row.integer(2));
        status.journal = row.text(3);
        status.sensorModels = row.integer(4);
        return status;
    });
}

} // namespace lubberline::db
