#include "db/transfer/Years.h"

#include <utility>

#include "db/engine/Changes.h"
#include "db/engine/Statement.h"
#include "db/engine/Transaction.h"
#include "db/saving/Audit.h"
#include "db/stores/ResultCache.h"

namespace lubberline::db {

namespace {

Result<void> takeOut(Database& database, const QString& sql, const MadeRows& rows)
{
    if (rows.first == 0)
        return {};
    Statement statement(database, sql);
    statement << rows.first << rows.last;
    return statement.run();
}

Result<void> nothingChangedSince(Database& database, const YearsMade& made)
{
    Statement statement(database,
        "SELECT a.registration, s.date FROM swing s JOIN compass c ON c.id = s.compass_id JOIN aircraft a ON a.id = c.aircraft_id"
        " WHERE s.id BETWEEN ? AND ? AND (s.state = 2 OR s.record IN (SELECT record FROM audit_entry WHERE id > ?)) LIMIT 1");
    statement << made.swings.first << made.swings.last << made.lastAudit;
    const auto changed = firstOf<std::string>(statement, [](Statement& row) { return row.text(0) + ", " + row.text(1); });
    if (!changed)
        return changed.error();
    if (*changed)
        return Error{ErrorCode::Conflict, {MARKED("db", "a swing of this import (%1) was changed since; nothing was undone"), **changed},
            database.path().toStdString()};
    return {};
}

} // namespace

Result<std::int64_t> undoYears(Database& database, const YearsMade& made)
{
    auto transaction = Transaction::begin(database);
    if (!transaction)
        return transaction.error();
    if (const auto same = nothingChangedSince(database, made); !same)
        return same.error();
    Statement compasses(database, "SELECT DISTINCT compass_id FROM swing WHERE id BETWEEN ? AND ?");
    compasses << made.swings.first << made.swings.last;
    const auto touched = rowsOf<CompassId>(compasses, [](Statement& row) { return row.id<CompassId>(0); });
    if (!touched)
        return touched.error();
    Statement swings(database, "DELETE FROM swing WHERE id BETWEEN ? AND ?");
    swings << made.swings.first << made.swings.last;
    if (const auto done = swings.run(); !done)
        return done.error();
    const std::int64_t taken = swings.changed();
    // Of what was made for them, what nobody uses.
    const std::pair<const char*, const MadeRows*> steps[] = {
        {"DELETE FROM compass WHERE id BETWEEN ? AND ? AND id NOT IN (SELECT compass_id FROM swing) AND id NOT IN (SELECT compass_id FROM"
         " sensor_model) AND id NOT IN (SELECT compass_id FROM electrical_swing) AND id NOT IN (SELECT compass_id FROM coil_bench)",
            &made.compasses},
        {"DELETE FROM aircraft WHERE id BETWEEN ? AND ? AND id NOT IN (SELECT aircraft_id FROM compass) AND id NOT IN (SELECT aircraft_id FROM"
         " event)",
            &made.aircraft},
        {"DELETE FROM aircraft_type WHERE id BETWEEN ? AND ? AND id NOT IN (SELECT type_id FROM aircraft)", &made.types},
        {"DELETE FROM site WHERE id BETWEEN ? AND ? AND id NOT IN (SELECT site_id FROM swing WHERE site_id IS NOT NULL) AND id NOT IN (SELECT"
         " base_id FROM aircraft WHERE base_id IS NOT NULL)",
            &made.sites}};
    for (const auto& [sql, rows] : steps)
        if (const auto done = takeOut(database, sql, *rows); !done)
            return done.error();
    for (const CompassId compass : *touched)
        if (const auto done = refreshCompass(database, compass); !done)
            return done.error();
    if (const auto kept = audit(database, "undone import", {}, made.name + ": " + std::to_string(taken) + " swings"); !kept)
        return kept.error();
    database.changes().note(change::Fleet{});
    database.changes().note(change::Sites{});
    if (const auto committed = transaction->commit(); !committed)
        return committed.error();
    return taken;
}

} // namespace lubberline::db
