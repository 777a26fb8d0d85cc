#include "db/SwingRepository.h"

#include <QStringList>

#include <algorithm>

#include "db/Audit.h"
#include "db/FleetRepository.h"
#include "db/ResultCache.h"
#include "db/Saving.h"
#include "db/SiteRepository.h"
#include "db/SwingRows.h"

namespace lubberline::db {

namespace {

Error noSuchSwing(const Database& database)
{
    return {ErrorCode::NotFound, "there is no such swing in the database", database.path().toStdString()};
}

Error isSigned(const Database& database)
{
    return {ErrorCode::Frozen, "the swing is signed and frozen; expected a new revision instead of a change", database.path().toStdString()};
}

QString placeholders(qsizetype count)
{
    return QStringList(count, "?").join(", ");
}

Result<Swing> particulars(Database& database, SwingId id)
{
    Statement statement(database, "SELECT " + swingColumns() + " FROM swing s WHERE s.id = ?");
    statement << id;
    if (const auto done = statement.run(); !done)
        return done.error();
    if (!statement.next())
        return noSuchSwing(database);
    return swingFrom(statement, 0);
}

/// The particulars of a swing whose readings may be changed. Errors: NotFound, Frozen.
Result<Swing> openSwing(Database& database, SwingId id)
{
    auto swing = particulars(database, id);
    if (swing && swing->state == SwingState::Signed)
        return isSigned(database);
    return swing;
}

Result<ReadingId> insertRow(Database& database, SwingId swing, int position, const Reading& reading)
{
    static const QString kInsert = "INSERT INTO reading (swing_id, position, " + readingFields().join(", ") + ") VALUES (?, ?, " + placeholders(readingFields().size()) + ")";
    Statement statement(database, kInsert);
    statement << swing << position;
    bindReading(statement, reading);
    if (const auto done = statement.run(); !done)
        return done.error();
    return ReadingId{statement.insertedId()};
}

Result<std::optional<LimitsProfile>> limitsOf(Database& database, LimitsProfileId id)
{
    if (!id.valid())
        return std::optional<LimitsProfile>{};
    const auto profiles = SiteRepository(database).limitsProfiles();
    if (!profiles)
        return profiles.error();
    const auto found = std::find_if(profiles->begin(), profiles->end(), [&](const LimitsProfile& profile) { return profile.id == id; });
    return found == profiles->end() ? std::optional<LimitsProfile>{} : std::optional(*found);
}

Result<Reading> storedReading(Database& database, SwingId swing, ReadingId id)
{
    Statement statement(database, "SELECT " + readingColumns() + " FROM reading r WHERE r.id = ? AND r.swing_id = ?");
    statement << id << swing;
    if (const auto done = statement.run(); !done)
        return done.error();
    if (!statement.next())
        return Error{ErrorCode::NotFound, "there is no such reading in the swing", database.path().toStdString()};
    return readingFrom(statement, 0);
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
    Statement row(m_database, "SELECT id, compass_id, date, kind, stage, state, reading_count, max_abs_deviation_deg, a_deg, b_deg, c_deg, d_deg, e_deg, status"
                              " FROM swing WHERE compass_id = ? ORDER BY date DESC, id DESC");
    row << compass;
    if (const auto done = row.run(); !done)
        return done.error();
    std::vector<SwingRow> rows;
    while (row.next())
        rows.push_back({row.id<SwingId>(0), row.id<CompassId>(1), row.text(2), row.as<SwingKind>(3), row.as<SwingStage>(4), row.as<SwingState>(5),
            static_cast<int>(row.integer(6)), row.optionalReal(7),
            {row.optionalReal(8), row.optionalReal(9), row.optionalReal(10), row.optionalReal(11), row.optionalReal(12)}, row.as<Status>(13)});
    return rows;
}

Result<Swing> SwingRepository::swing(SwingId id)
{
    auto swing = particulars(m_database, id);
    if (!swing)
        return swing.error();
    Statement statement(m_database, "SELECT " + readingColumns() + " FROM reading r WHERE r.swing_id = ? ORDER BY r.position, r.id");
    statement << id;
    if (const auto done = statement.run(); !done)
        return done.error();
    while (statement.next())
        swing->readings.push_back(readingFrom(statement, 0));
    return swing;
}

Result<SwingRecord> SwingRepository::record(SwingId id)
{
    FleetRepository fleet(m_database);
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
    const auto limits = limitsOf(m_database, compass->limits);
    if (!limits)
        return limits.error();
    SwingRecord record{*found, *compass, *aircraft, *type, {}, *limits};
    if (found->site.valid()) {
        const auto sites = SiteRepository(m_database).sites();
        if (!sites)
            return sites.error();
        for (const auto& site : *sites)
            if (site.id == found->site)
                record.site = site;
    }
    return record;
}

Result<std::optional<Swing>> SwingRepository::previous(SwingId id)
{
    Statement statement(m_database, "SELECT p.id FROM swing s JOIN swing p ON p.compass_id = s.compass_id AND p.id <> s.id"
                                    " AND (p.date < s.date OR (p.date = s.date AND p.id < s.id)) WHERE s.id = ?"
                                    " ORDER BY p.date DESC, p.id DESC LIMIT 1");
    statement << id;
    if (const auto done = statement.run(); !done)
        return done.error();
    if (!statement.next())
        return std::optional<Swing>{};
    auto found = swing(statement.id<SwingId>(0));
    if (!found)
        return found.error();
    return std::optional(std::move(found.value()));
}

Result<SwingId> SwingRepository::named(const std::string& beginning)
{
    const std::string file = m_database.path().toStdString();
    if (beginning.empty() || beginning.find_first_not_of("0123456789abcdef-") != std::string::npos)
        return Error{ErrorCode::InvalidInput, "'" + beginning + "' is no record id; expected one, or its beginning, as `lubberline swings` lists them", file};
    Statement statement(m_database, "SELECT id FROM swing WHERE record LIKE ? LIMIT 2");
    statement << beginning + "%";
    if (const auto done = statement.run(); !done)
        return done.error();
    if (!statement.next())
        return Error{ErrorCode::NotFound, "there is no swing whose record id begins with " + beginning, file};
    const auto id = statement.id<SwingId>(0);
    if (statement.next())
        return Error{ErrorCode::Conflict, "several swings have record ids that begin with " + beginning + "; expected more of it", file};
    return id;
}

Result<void> SwingRepository::forEach(const std::function<bool(const Swing&)>& callback)
{
    // Two statements in step, both in order of swing: a join would bring a swing's columns again with each of its readings.
    Statement swings(m_database, "SELECT " + swingColumns() + " FROM swing s ORDER BY s.id");
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
        if (!callback(swing))
            break;
    }
    return {};
}

Result<SwingId> SwingRepository::save(const Swing& swing)
{
    auto transaction = Transaction::begin(m_database);
    if (!transaction)
        return transaction.error();
    if (swing.id.valid())
        if (const auto open = openSwing(m_database, swing.id); !open)
            return open.error();
    static const QString kInsert = "INSERT INTO swing (record, " + swingFields().join(", ") + ") VALUES (?, " + placeholders(swingFields().size()) + ")";
    static const QString kUpdate = "UPDATE swing SET " + swingFields().join(" = ?, ") + " = ? WHERE id = ?";
    // A signed swing comes in as one whole: it is frozen only when its readings are there.
    Swing stored = swing;
    if (!swing.id.valid() && swing.state == SwingState::Signed)
        stored.state = SwingState::Complete;
    const auto id = saveRecord(m_database, "swing", swing.id, swing.record, swing.date, kInsert, kUpdate,
        [&](Statement& statement) { bindParticulars(statement, stored); });
    if (!id)
        return id.error();
    if (!swing.id.valid())
        for (std::size_t i = 0; i < swing.readings.size(); ++i)
            if (const auto inserted = insertRow(m_database, *id, static_cast<int>(i), swing.readings[i]); !inserted)
                return inserted.error();
    if (const auto refreshed = refreshSwing(m_database, *id); !refreshed)
        return refreshed.error();
    if (stored.state != swing.state) {
        Statement freeze(m_database, "UPDATE swing SET state = 2 WHERE id = ?");
        freeze << *id;
        if (const auto done = freeze.run(); !done)
            return done.error();
    }
    if (const auto committed = transaction->commit(); !committed)
        return committed.error();
    return *id;
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
    if (found->state != SwingState::Draft)
        return Error{ErrorCode::Frozen, "only a draft can be removed; this swing is complete", m_database.path().toStdString()};
    std::string detail = found->date; // what is removed stays readable in the audit trail
    for (const auto& reading : found->readings)
        detail += "; " + auditText(reading);
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
    const auto id = insertRow(m_database, swing, position, reading);
    if (!id)
        return id.error();
    if (const auto done = finish(m_database, *transaction, *open, "added reading", auditText(reading)); !done)
        return done.error();
    return *id;
}

Result<void> SwingRepository::saveReading(SwingId swing, const Reading& reading)
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
    Statement close(m_database, "UPDATE reading SET position = position - 1 WHERE swing_id = ? AND position > (SELECT position FROM reading WHERE id = ?)");
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
