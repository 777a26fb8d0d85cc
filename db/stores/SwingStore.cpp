#include "db/stores/SwingStore.h"

#include <algorithm>

#include "core/record/Ranges.h"
#include "core/swing/SwingField.h"
#include "db/saving/Audit.h"
#include "db/saving/Saving.h"
#include "db/stores/FleetStore.h"
#include "db/stores/ResultCache.h"
#include "db/stores/Signatures.h"
#include "db/stores/SiteStore.h"
#include "db/stores/SwingReadings.h"
#include "db/stores/SwingRows.h"
#include "db/stores/Tables.h"

namespace lubberline::db {

Error isSigned(const Database& database)
{
    return {ErrorCode::Frozen, MARKED("db", "the swing is signed and frozen; expected a new revision instead of a change"),
        database.path().toStdString()};
}

Result<Swing> particularsOf(Database& database, SwingId id)
{
    Statement statement(database, "SELECT " + swingColumns() + " FROM swing s WHERE s.id = ?");
    statement << id;
    return oneOf<Swing>(statement, database, MARKED("db", "swing"), [](Statement& row) { return swingFrom(row, 0); });
}

Result<Swing> openSwing(Database& database, SwingId id)
{
    auto swing = particularsOf(database, id);
    if (swing && swing->state == SwingState::Signed)
        return isSigned(database);
    return swing;
}

const Table& swingTable()
{
    static const Table table{MARKED("db", "swing"), "swing", swingFields(), [](const Statement& row) { (void)swingFrom(row, 0); }};
    return table;
}

Result<std::vector<SwingRow>> SwingStore::swingsOf(CompassId compass)
{
    Statement statement(m_database, "SELECT " + swingRowColumns() + " FROM swing WHERE compass_id = ? ORDER BY date DESC, id DESC");
    statement << compass;
    return shownRowsOf<SwingRow>(statement, swingRowFrom);
}

Result<std::vector<NewestSwing>> SwingStore::newest(int count)
{
    Statement statement(m_database,
        "SELECT " + swingRowColumns()
            + ", (SELECT a.registration FROM compass c JOIN aircraft a ON a.id = c.aircraft_id WHERE c.id = swing.compass_id),"
              " (SELECT c.name FROM compass c WHERE c.id = swing.compass_id) FROM swing"
              " WHERE id IN (SELECT id FROM swing ORDER BY date DESC, id DESC LIMIT ?) ORDER BY date DESC, id DESC");
    statement << count;
    return rowsOf<NewestSwing>(statement, [](Statement& row) {
        return NewestSwing{swingRowFrom(row), row.text(kSwingRowColumns), row.text(kSwingRowColumns + 1)};
    });
}

Result<Swing> SwingStore::swing(SwingId id, ReadingParts parts)
{
    const auto snapshot = Transaction::beginReading(m_database);
    if (!snapshot)
        return snapshot.error();
    auto swing = particularsOf(m_database, id);
    if (!swing)
        return swing;
    const bool all = parts == ReadingParts::All;
    Statement statement(m_database,
        "SELECT " + (all ? readingColumns() : headingColumns()) + " FROM reading r WHERE r.swing_id = ? ORDER BY r.position, r.id");
    statement << id;
    const auto count = countOfReadings(m_database, id);
    if (!count)
        return count.error();
    swing->readings.reserve(*count); // a log has thousands: what grows moves them again and again
    if (const auto done = statement.run(); !done)
        return done.error();
    while (statement.next())
        swing->readings.push_back(all ? readingFrom(statement, 0) : headingsOnlyFrom(statement, 0));
    if (const auto whole = statement.finished(); !whole)
        return whole.error();
    auto signatures = signaturesOf(m_database, id);
    if (!signatures)
        return signatures.error();
    swing->signatures = std::move(*signatures);
    return swing;
}

Result<SwingRecord> SwingStore::record(SwingId id, ReadingParts parts)
{
    const auto snapshot = Transaction::beginReading(m_database);
    if (!snapshot)
        return snapshot.error();
    FleetStore fleet(m_database);
    SiteStore sites(m_database);
    auto found = swing(id, parts);
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
    if (found->site.valid() && !*site)
        return Error{ErrorCode::Corrupt,
            {MARKED("db", "swing.site_id, row %1: %2 is stored; expected the number of a site"), id.value, found->site.value},
            m_database.path().toStdString()};
    const auto limits = sites.limitsOf(compass->id);
    if (!limits)
        return limits.error();
    return SwingRecord{std::move(*found), *compass, *aircraft, *type, *site, *limits};
}

Result<std::optional<SwingRow>> SwingStore::previousRow(SwingId id)
{
    Statement statement(m_database,
        "SELECT " + swingRowColumns()
            + " FROM swing WHERE id = (SELECT p.id FROM swing s JOIN swing p ON p.compass_id = s.compass_id AND p.id <> s.id"
              " AND p.record <> s.supersedes"
              " AND (p.date < s.date OR (p.date = s.date AND (p.stage < s.stage OR (p.stage = s.stage AND p.id < s.id))))"
              " WHERE s.id = ? AND NOT EXISTS (SELECT 1 FROM swing n WHERE n.supersedes = p.record)"
              " ORDER BY p.date < s.date DESC, p.date DESC, p.stage DESC, p.id DESC LIMIT 1)");
    statement << id;
    return firstOf<SwingRow>(statement, swingRowFrom);
}

Result<std::optional<Swing>> SwingStore::previous(SwingId id)
{
    const auto before = previousRow(id);
    if (!before)
        return before.error();
    if (!*before)
        return std::optional<Swing>{};
    auto found = swing((*before)->id);
    if (!found)
        return found.error();
    return std::optional(std::move(*found));
}

Result<RecordId> SwingStore::recordOf(SwingId id)
{
    Statement statement(m_database, "SELECT record FROM swing WHERE id = ?"); // that of a damaged swing, too: it is how it is named
    statement << id;
    return oneOf<RecordId>(statement, m_database, MARKED("db", "swing"), [](Statement& row) { return row.anything(0); });
}

Result<SwingId> SwingStore::named(const std::string& beginning)
{
    const std::string file = m_database.path().toStdString();
    if (beginning.empty() || beginning.find_first_not_of("0123456789abcdef-") != std::string::npos)
        return Error{ErrorCode::InvalidInput,
            {MARKED("db", "'%1' is no record id; expected one, or its beginning, as `lubberline swings` lists them"), beginning}, file};
    Statement statement(m_database, "SELECT id FROM swing WHERE record LIKE ? LIMIT 2");
    statement << beginning + "%";
    const auto found = rowsOf<SwingId>(statement, [](Statement& row) { return row.id<SwingId>(0); });
    if (!found)
        return found.error();
    if (found->empty())
        return Error{ErrorCode::NotFound, {MARKED("db", "there is no swing whose record id begins with %1"), beginning}, file};
    if (found->size() > 1)
        return Error{
            ErrorCode::Conflict, {MARKED("db", "several swings have record ids that begin with %1; expected more of it"), beginning}, file};
    return found->front();
}

Result<void> SwingStore::forEach(const std::function<bool(const Swing&)>& callback)
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
        const std::size_t before = swings.damages().size() + readings.damages().size();
        Swing swing = swingFrom(swings, 0);
        for (; more && readings.id<SwingId>(0) <= swing.id; more = readings.next())
            if (readings.id<SwingId>(0) == swing.id)
                swing.readings.push_back(readingFrom(readings, 1));
        if (const auto found = signatures->find(swing.id); found != signatures->end())
            swing.signatures = found->second;
        if (swings.damages().size() + readings.damages().size() > before)
            continue; // told in the end
        if (!callback(swing))
            return {};
    }
    const auto whole = swings.finished();
    return whole ? readings.finished() : whole;
}

Result<SwingId> SwingStore::add(const Swing& swing)
{
    const auto site = SiteStore(m_database).site(swing.site);
    if (!site)
        return site.error();
    Swing stamped = swing;
    stampUnlessSigned(stamped, *site);
    return addAsIs(stamped);
}

Result<SwingId> SwingStore::addAsIs(const Swing& swing)
{
    return noting(
        m_database, [&] { return insert(swing); },
        [&](SwingId id) {
            m_database.changes().note(change::Fleet{});
            m_database.changes().note(change::OfSwing{id});
        });
}

Result<SwingId> SwingStore::insert(Swing swing)
{
    // A signed swing comes in as one whole: it is frozen only when its readings are there.
    const SwingState state = swing.state;
    if (state == SwingState::Signed)
        swing.state = SwingState::Complete;
    const auto id = addRecord<SwingId>(m_database, swingTable(), swing, bindParticulars);
    if (!id)
        return id;
    if (const auto inserted = db::insertReadings(m_database, *id, 0, swing.readings); !inserted)
        return inserted.error();
    swing.id = *id;
    if (!swing.signatures.empty()) { // the record id may have been made just now
        const auto record = recordOf(*id);
        if (!record)
            return record.error();
        for (const auto& signature : swing.signatures)
            if (const auto kept = addSignature(m_database, *id, *record, signature, kSignedElsewhere); !kept)
                return kept.error();
    }
    if (const auto stored = storeResult(m_database, swing); !stored)
        return stored.error();
    if (swing.state == state)
        return id;
    const Swing complete = swing;
    swing.state = state;
    if (const auto frozen = changeRecord(m_database, swingTable(), *id, complete, swing, bindParticulars); !frozen)
        return frozen.error();
    return id;
}

Result<void> SwingStore::change(const Swing& known, const Swing& swing)
{
    if (known.state != swing.state)
        return Error{ErrorCode::InvalidInput,
            MARKED("db", "the state of a swing is no particular; expected it to be completed, opened again with a reason, or signed"),
            m_database.path().toStdString()};
    return replace(known, swing);
}

Result<void> SwingStore::replace(const Swing& known, const Swing& swing)
{
    const auto store = [&]() -> Result<void> {
        const auto before = openSwing(m_database, swing.id);
        if (!before)
            return before.error();
        if (const auto changed = changeRecord(m_database, swingTable(), swing.id, known, swing, bindParticulars); !changed)
            return changed;
        if (const auto refreshed = refreshSwing(m_database, swing.id); !refreshed)
            return refreshed;
        return before->compass == swing.compass ? Result<void>() : refreshCompass(m_database, before->compass);
    };
    return noting(m_database, store, [&] {
        m_database.changes().note(change::OfSwing{swing.id});
        if (known.date != swing.date || known.stage != swing.stage || known.kind != swing.kind || known.state != swing.state)
            m_database.changes().note(change::Fleet{});
    });
}

Result<void> SwingStore::remove(SwingId id)
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
        return Error{
            ErrorCode::Frozen, MARKED("db", "somebody has signed this swing; it stays on record"), m_database.path().toStdString()};
    if (found->state != SwingState::Draft)
        return Error{
            ErrorCode::Frozen, MARKED("db", "only a draft can be removed; this swing is complete"), m_database.path().toStdString()};
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
    m_database.changes().note(change::Fleet{});
    return transaction->commit();
}

} // namespace lubberline::db
