#include "db/SwingRepository.h"

#include <span>

#include "db/Audit.h"
#include "db/FleetRepository.h"
#include "db/ResultCache.h"
#include "db/Saving.h"
#include "db/Signatures.h"
#include "db/SiteRepository.h"
#include "db/SwingRows.h"

namespace lubberline::db {

namespace {

const Table& swingTable()
{
    static const Table table{"swing", "swing", swingFields()};
    return table;
}

Error isSigned(const Database& database)
{
    return {
        ErrorCode::Frozen, "the swing is signed and frozen; expected a new revision instead of a change", database.path().toStdString()};
}

Result<Swing> particulars(Database& database, SwingId id)
{
    Statement statement(database, "SELECT " + swingColumns() + " FROM swing s WHERE s.id = ?");
    statement << id;
    return oneOf<Swing>(statement, database, "swing", [](Statement& row) { return swingFrom(row, 0); });
}

/// The particulars of a swing whose readings may be changed. Errors: NotFound, Frozen.
Result<Swing> openSwing(Database& database, SwingId id)
{
    auto swing = particulars(database, id);
    if (swing && swing->state == SwingState::Signed)
        return isSigned(database);
    return swing;
}

/// Readings one after the other from `position` on, with one prepared statement. @return the id of the last.
Result<ReadingId> insertRows(Database& database, SwingId swing, int position, std::span<const Reading> readings)
{
    static const QString kInsert = "INSERT INTO reading (swing_id, position, " + readingFields().join(", ") + ") VALUES ("
        + placeholders(readingFields().size() + 2) + ")";
    Statement statement(database, kInsert);
    for (const auto& reading : readings) {
        statement << swing << position++;
        bindReading(statement, reading);
        if (const auto done = statement.run(); !done)
            return done.error();
    }
    return ReadingId{statement.insertedId()};
}

Result<Reading> storedReading(Database& database, SwingId swing, ReadingId id)
{
    Statement statement(database, "SELECT " + readingColumns() + " FROM reading r WHERE r.id = ? AND r.swing_id = ?");
    statement << id << swing;
    return oneOf<Reading>(statement, database, "reading of the swing", [](Statement& row) { return readingFrom(row, 0); });
}

/// After a change of readings: cached results, audit entry, commit.
Result<void> finish(Database& database, Transaction& transaction, const Swing& swing, const std::string& what, const std::string& detail)
{
    if (const auto refreshed = refreshSwing(database, swing.id); !refreshed)
        return refreshed;
    if (const auto kept = audit(database, what, swing.record, detail); !kept)
        return kept;
    return transaction.commit();
}

} // namespace

Result<std::vector<SwingRow>> SwingRepository::swingsOf(CompassId compass)
{
    Statement statement(m_database, "SELECT " + swingRowColumns() + " FROM swing WHERE compass_id = ? ORDER BY date DESC, id DESC");
    statement << compass;
    return rowsOf<SwingRow>(statement, swingRowFrom);
}

Result<Swing> SwingRepository::swing(SwingId id)
{
    const auto snapshot = Transaction::beginReading(m_database);
    if (!snapshot)
        return snapshot.error();
    auto swing = particulars(m_database, id);
    if (!swing)
        return swing;
    Statement statement(m_database, "SELECT " + readingColumns() + " FROM reading r WHERE r.swing_id = ? ORDER BY r.position, r.id");
    statement << id;
    auto readings = rowsOf<Reading>(statement, [](Statement& row) { return readingFrom(row, 0); });
    if (!readings)
        return readings.error();
    swing->readings = std::move(*readings);
    auto signatures = signaturesOf(m_database, id);
    if (!signatures)
        return signatures.error();
    swing->signatures = std::move(*signatures);
    return swing;
}

Result<SwingRecord> SwingRepository::record(SwingId id)
{
    const auto snapshot = Transaction::beginReading(m_database);
    if (!snapshot)
        return snapshot.error();
    FleetRepository fleet(m_database);
    SiteRepository sites(m_database);
    auto found = swing(id);
    if (!found)
        return found.error();
    const auto compass = fleet.compass(found->compass);
    if (!compass)
        return compass.error();
    const auto aircraft = fleet.aircraft(compass->aircraft);
    if (!aircraft)
        return aircraft.error();
    const auto type = fleet.type(aircraft->type);
    if (!type)
        return type.error();
    const auto site = sites.site(found->site);
    if (!site)
        return site.error();
    const auto limits = sites.limitsOf(compass->id);
    if (!limits)
        return limits.error();
    return SwingRecord{std::move(*found), *compass, *aircraft, *type, *site, *limits};
}

Result<std::optional<Swing>> SwingRepository::previous(SwingId id)
{
    Statement statement(m_database,
        "SELECT p.id FROM swing s JOIN swing p ON p.compass_id = s.compass_id AND p.id <> s.id AND p.record <> s.supersedes"
        " AND (p.date < s.date OR (p.date = s.date AND (p.stage < s.stage OR (p.stage = s.stage AND p.id < s.id))))"
        " WHERE s.id = ? AND NOT EXISTS (SELECT 1 FROM swing n WHERE n.supersedes = p.record)"
        " ORDER BY p.date < s.date DESC, p.date DESC, p.stage DESC, p.id DESC LIMIT 1");
    statement << id;
    const auto before = firstOf<SwingId>(statement, [](Statement& row) { return row.id<SwingId>(0); });
    if (!before)
        return before.error();
    if (!*before)
        return std::optional<Swing>{};
    auto found = swing(**before);
    if (!found)
        return found.error();
    return std::optional(std::move(*found));
}

Result<SwingId> SwingRepository::named(const std::string& beginning)
{
    const std::string file = m_database.path().toStdString();
    if (beginning.empty() || beginning.find_first_not_of("0123456789abcdef-") != std::string::npos)
        return Error{ErrorCode::InvalidInput,
            "'" + beginning + "' is no record id; expected one, or its beginning, as `lubberline swings` lists them", file};
    Statement statement(m_database, "SELECT id FROM swing WHERE record LIKE ? LIMIT 2");
    statement << beginning + "%";
    const auto found = rowsOf<SwingId>(statement, [](Statement& row) { return row.id<SwingId>(0); });
    if (!found)
        return found.error();
    if (found->empty())
        return Error{ErrorCode::NotFound, "there is no swing whose record id begins with " + beginning, file};
    if (found->size() > 1)
        return Error{ErrorCode::Conflict, "several swings have record ids that begin with " + beginning + "; expected more of it", file};
    return found->front();
}

Result<void> SwingRepository::forEach(const std::function<bool(const Swing&)>& callback)
{
    // Two statements in step, both in order of swing: a join would bring a swing's columns again with each of its readings.
    Statement swings(m_database, "SELECT " + swingColumns() + " FROM swing s ORDER BY s.id");
    const auto signatures = allSignatures(m_database);
    if (!signatures)
        return signatures.error();
    Statement readings(m_database, "SELECT r.swing_id, " + readingColumns() + " FROM reading r ORDER BY r.swing_id, r.position");
    for (Statement* statement : {&swings, &readings})
        if (const auto done = statement->run(); !done)
            return done;
    bool more = readings.next();
    while (swings.next()) {
        Swing swing = swingFrom(swings, 0);
        for (; more && readings.id<SwingId>(0) <= swing.id; more = readings.next())
            if (readings.id<SwingId>(0) == swing.id)
                swing.readings.push_back(readingFrom(readings, 1));
        if (const auto found = signatures->find(swing.id); found != signatures->end())
            swing.signatures = found->second;
        if (!callback(swing))
            return {};
    }
    const auto whole = swings.finished();
    return whole ? readings.finished() : whole;
}

Result<SwingId> SwingRepository::save(const Swing& swing)
{
    auto transaction = Transaction::begin(m_database);
    if (!transaction)
        return transaction.error();
    const auto id = swing.id.valid() ? change(swing) : add(swing);
    if (!id)
        return id;
    if (const auto committed = transaction->commit(); !committed)
        return committed.error();
    return id;
}

Result<SwingId> SwingRepository::add(Swing swing)
{
    // A signed swing comes in as one whole: it is frozen only when its readings are there.
    const SwingState state = swing.state;
    if (state == SwingState::Signed)
        swing.state = SwingState::Complete;
    const auto id
        = saveRecord(m_database, swingTable(), swing.id, swing.record, [&](Statement& statement) { bindParticulars(statement, swing); });
    if (!id)
        return id;
    if (const auto inserted = insertRows(m_database, *id, 0, swing.readings); !inserted)
        return inserted.error();
    for (const auto& signature : swing.signatures)
        if (const auto kept = addSignature(m_database, *id, signature); !kept)
            return kept.error();
    swing.id = *id;
    if (const auto stored = storeResult(m_database, swing); !stored)
        return stored.error();
    if (swing.state != state) {
        swing.state = state;
        return saveRecord(m_database, swingTable(), *id, swing.record, [&](Statement& statement) { bindParticulars(statement, swing); });
    }
    return id;
}

Result<SwingId> SwingRepository::change(const Swing& swing)
{
    const auto before = openSwing(m_database, swing.id);
    if (!before)
        return before.error();
    const auto id
        = saveRecord(m_database, swingTable(), swing.id, swing.record, [&](Statement& statement) { bindParticulars(statement, swing); });
    if (!id)
        return id;
    if (const auto refreshed = refreshSwing(m_database, swing.id); !refreshed)
        return refreshed.error();
    if (before->compass != swing.compass)
        if (const auto refreshed = refreshCompass(m_database, before->compass); !refreshed)
            return refreshed.error();
    return id;
}

Result<void> SwingRepository::changeFrom(const Swing& known, const Swing& swing)
{
    auto transaction = Transaction::begin(m_database);
    if (!transaction)
        return transaction.error();
    auto stored = openSwing(m_database, swing.id);
    if (!stored)
        return stored.error();
    Swing before = known;
    before.readings.clear();
    before.signatures.clear();
    if (*stored != before)
        return Error{ErrorCode::Conflict,
            "the particulars of this swing have been changed elsewhere; nothing was overwritten, look at it again",
            m_database.path().toStdString()};
    if (const auto done = change(swing); !done)
        return done.error();
    return transaction->commit();
}

Result<void> SwingRepository::replaceReadings(SwingId id, const std::vector<Reading>& readings)
{
    auto transaction = Transaction::begin(m_database);
    if (!transaction)
        return transaction.error();
    const auto open = openSwing(m_database, id);
    if (!open)
        return open.error();
    Statement statement(m_database, "DELETE FROM reading WHERE swing_id = ?");
    statement << id;
    if (const auto done = statement.run(); !done)
        return done;
    if (const auto inserted = insertRows(m_database, id, 0, readings); !inserted)
        return inserted.error();
    std::string detail;
    for (const auto& reading : readings)
        detail += (detail.empty() ? "reading: " : "; reading: ") + auditText(reading);
    return finish(m_database, *transaction, *open, "set readings", detail);
}

Result<void> SwingRepository::remove(SwingId id)
{
    auto transaction = Transaction::begin(m_database);
    if (!transaction)
        return transaction.error();
    const auto found = swing(id);
    if (!found)
        return found.error();
    if (found->state == SwingState::Signed)
        return isSigned(m_database);
    if (!found->signatures.empty())
        return Error{ErrorCode::Frozen, "somebody has signed this swing; it stays on record", m_database.path().toStdString()};
    if (found->state != SwingState::Draft)
        return Error{ErrorCode::Frozen, "only a draft can be removed; this swing is complete", m_database.path().toStdString()};
    const auto row = storedRow(m_database, swingTable(), id.value);
    if (!row)
        return row.error();
    std::string detail = changesBetween(swingTable(), {}, *row); // what is removed stays readable in the audit trail
    for (const auto& reading : found->readings)
        detail += "; reading: " + auditText(reading);
    Statement statement(m_database, "DELETE FROM swing WHERE id = ?");
    statement << id;
    if (const auto done = statement.run(); !done)
        return done;
    if (const auto refreshed = refreshCompass(m_database, found->compass); !refreshed)
        return refreshed;
    if (const auto kept = audit(m_database, "removed swing", found->record, detail); !kept)
        return kept;
    return transaction->commit();
}

Result<ReadingId> SwingRepository::insertReading(SwingId swing, int position, const Reading& reading)
{
    LUBBERLINE_EXPECT(position >= 0, "a reading's position counts from 0");
    auto transaction = Transaction::begin(m_database);
    if (!transaction)
        return transaction.error();
    const auto open = openSwing(m_database, swing);
    if (!open)
        return open.error();
    Statement shift(m_database, "UPDATE reading SET position = position + 1 WHERE swing_id = ? AND position >= ?");
    shift << swing << position;
    if (const auto done = shift.run(); !done)
        return done.error();
    const auto id = insertRows(m_database, swing, position, {&reading, 1});
    if (!id)
        return id.error();
    if (const auto done = finish(m_database, *transaction, *open, "added reading", auditText(reading)); !done)
        return done.error();
    return *id;
}

Result<void> SwingRepository::saveReading(SwingId swing, const Reading& known, const Reading& reading)
{
    auto transaction = Transaction::begin(m_database);
    if (!transaction)
        return transaction.error();
    const auto open = openSwing(m_database, swing);
    if (!open)
        return open.error();
    const auto before = storedReading(m_database, swing, reading.id);
    if (!before)
        return before.error();
    if (*before == reading)
        return transaction->commit();
    if (*before != known)
        return Error{ErrorCode::Conflict,
            "this reading has been changed elsewhere to: " + auditText(*before) + "; nothing was overwritten, look at it again",
            m_database.path().toStdString()};
    static const QString kUpdate = "UPDATE reading SET " + readingFields().join(" = ?, ") + " = ? WHERE id = ?";
    Statement statement(m_database, kUpdate);
    bindReading(statement, reading);
    statement << reading.id;
    if (const auto done = statement.run(); !done)
        return done;
    return finish(m_database, *transaction, *open, "changed reading", auditText(*before) + " -> " + auditText(reading));
}

Result<void> SwingRepository::removeReading(SwingId swing, ReadingId reading)
{
    auto transaction = Transaction::begin(m_database);
    if (!transaction)
        return transaction.error();
    const auto open = openSwing(m_database, swing);
    if (!open)
        return open.error();
    const auto before = storedReading(m_database, swing, reading);
    if (!before)
        return before.error();
    Statement close(m_database,
        "UPDATE reading SET position = position - 1 WHERE swing_id = ? AND position > (SELECT position FROM reading WHERE id = ?)");
    close << swing << reading;
    if (const auto done = close.run(); !done)
        return done;
    Statement statement(m_database, "DELETE FROM reading WHERE id = ?");
    statement << reading;
    if (const auto done = statement.run(); !done)
        return done;
    return finish(m_database, *transaction, *open, "removed reading", auditText(*before));
}

} // namespace lubberline::db
