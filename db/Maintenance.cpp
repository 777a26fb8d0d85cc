#include "db/Maintenance.h"

#include <QFile>
#include <QFileInfo>

#include <cmath>
#include <map>

#include "db/FleetRepository.h"
#include "db/ResultCache.h"
#include "db/SiteRepository.h"
#include "db/Statement.h"
#include "db/SwingRepository.h"

namespace lubberline::db {

namespace {

/// Cached figures are degrees of the same computation on the same readings; only another build of the mathematics may differ.
constexpr double kSameResult_deg = 1e-9;

bool same(std::optional<double> a, std::optional<double> b)
{
    return a.has_value() == b.has_value() && (!a || std::abs(*a - *b) <= kSameResult_deg);
}

bool same(const CachedResult& computed, const SwingRow& stored)
{
    if (computed.readings != stored.readings || computed.status != stored.status || !same(computed.maxAbsDeviation_deg, stored.maxAbsDeviation_deg))
        return false;
    for (std::size_t i = 0; i < stored.coefficient_deg.size(); ++i)
        if (!same(computed.coefficient_deg[i], stored.coefficient_deg[i]))
            return false;
    return true;
}

Result<void> checkStructure(Database& database, VerifyReport& report)
{
    Statement integrity(database, "PRAGMA integrity_check");
    if (const auto done = integrity.run(); !done)
        return done;
    while (integrity.next())
        if (integrity.text(0) != "ok")
            report.findings.push_back("integrity: " + integrity.text(0));
    Statement keys(database, "PRAGMA foreign_key_check");
    if (const auto done = keys.run(); !done)
        return done;
    while (keys.next())
        report.findings.push_back("foreign key: a row of " + keys.text(0) + " refers to a missing row of " + keys.text(2));
    return {};
}

Result<std::map<SwingId, SwingRow>> storedRows(Database& database)
{
    Statement row(database, "SELECT id, compass_id, date, kind, stage, state, reading_count, max_abs_deviation_deg, a_deg, b_deg, c_deg, d_deg, e_deg, status FROM swing");
    if (const auto done = row.run(); !done)
        return done.error();
    std::map<SwingId, SwingRow> rows;
    while (row.next())
        rows[row.id<SwingId>(0)] = {row.id<SwingId>(0), row.id<CompassId>(1), row.text(2), row.as<SwingKind>(3), row.as<SwingStage>(4), row.as<SwingState>(5),
            static_cast<int>(row.integer(6)), row.optionalReal(7),
            {row.optionalReal(8), row.optionalReal(9), row.optionalReal(10), row.optionalReal(11), row.optionalReal(12)}, row.as<Status>(13)};
    return rows;
}

Result<std::map<CompassId, std::optional<LimitsProfile>>> limitsByCompass(Database& database)
{
    const auto profiles = SiteRepository(database).limitsProfiles();
    if (!profiles)
        return profiles.error();
    Statement row(database, "SELECT id, limits_id FROM compass");
    if (const auto done = row.run(); !done)
        return done.error();
    std::map<CompassId, std::optional<LimitsProfile>> limits;
    while (row.next()) {
        auto& slot = limits[row.id<CompassId>(0)];
        for (const auto& profile : *profiles)
            if (profile.id == row.id<LimitsProfileId>(1))
                slot = profile;
    }
    return limits;
}

Result<void> checkResults(Database& database, VerifyReport& report, const Progress& progress)
{
    const auto stored = storedRows(database);
    if (!stored)
        return stored.error();
    const auto limits = limitsByCompass(database);
    if (!limits)
        return limits.error();
    bool cancelled = false;
    const auto done = SwingRepository(database).forEach([&](const Swing& swing) {
        ++report.swings;
        report.readings += static_cast<std::int64_t>(swing.readings.size());
        const auto row = stored->find(swing.id);
        const auto profile = limits->find(swing.compass);
        if (row == stored->end() || profile == limits->end() || !same(resultOf(swing, profile->second), row->second))
            report.findings.push_back("results: those kept for the swing of " + swing.date + " (record " + swing.record + ") are not what its readings give");
        cancelled = progress && report.swings % 64 == 0 && !progress(static_cast<double>(report.swings) / static_cast<double>(stored->size()));
        return !cancelled;
    });
    if (!done)
        return done;
    if (cancelled)
        return Error{ErrorCode::Cancelled, "cancelled", database.path().toStdString()};
    if (progress)
        progress(1.0);
    return {};
}

} // namespace

Result<void> backup(Database& database, const QString& path)
{
    const std::string file = path.toStdString();
    if (QFileInfo::exists(path))
        return Error{ErrorCode::Conflict, "there is a file of this name already; expected a new name for the backup", file};
    const QString folder = QFileInfo(path).absolutePath();
    if (!QFileInfo(folder).isDir())
        return Error{ErrorCode::Io, "the folder " + folder.toStdString() + " is not there; expected an existing one", file};
    const QString partial = path + ".partial";
    QFile::remove(partial);
    Statement statement(database, "VACUUM INTO ?");
    statement << partial.toStdString();
    if (const auto done = statement.run(); !done) {
        QFile::remove(partial);
        Error error = done.error();
        error.file = file;
        return error;
    }
    if (!QFile::rename(partial, path)) {
        QFile::remove(partial);
        return Error{ErrorCode::Io, "the backup could not be given its name; expected a folder that may be written", file};
    }
    return {};
}

Result<VerifyReport> verify(Database& database, const Progress& progress)
{
    VerifyReport report;
    if (const auto done = checkStructure(database, report); !done)
        return done.error();
    if (const auto done = checkResults(database, report, progress); !done)
        return done.error();
    return report;
}

Result<DatabaseStatus> status(Database& database)
{
    DatabaseStatus status;
    status.path = database.path().toStdString();
    status.bytes = QFileInfo(database.path()).size();
    const auto totals = FleetRepository(database).totals();
    if (!totals)
        return totals.error();
    status.totals = *totals;
    for (const auto& [sql, target] : {std::pair{"SELECT COUNT(*) FROM reading", &status.readings}, std::pair{"SELECT COUNT(*) FROM audit_entry", &status.auditEntries}}) {
        const auto count = number(database, sql);
        if (!count)
            return count.error();
        *target = *count;
    }
    const auto schema = number(database, "PRAGMA user_version");
    if (!schema)
        return schema.error();
    status.schema = static_cast<int>(*schema);
    Statement journal(database, "PRAGMA journal_mode");
    if (const auto done = journal.run(); !done)
        return done.error();
    if (journal.next())
        status.journal = journal.text(0);
    return status;
}

} // namespace lubberline::db
