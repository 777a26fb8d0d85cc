#include "db/stores/SwingReadings.h"

#include <algorithm>

#include "core/base/Contract.h"
#include "core/base/FileText.h"
#include "core/base/UtcTime.h"
#include "core/record/Ranges.h"
#include "db/engine/Changes.h"
#include "db/engine/Transaction.h"
#include "db/saving/Audit.h"
#include "db/saving/Saving.h"
#include "db/stores/ResultCache.h"
#include "db/stores/SwingRows.h"
#include "db/stores/SwingStore.h"

namespace lubberline::db {

namespace {

/// What could not be read again must not be stored; the rest the columns hold themselves.
Result<void> checkTexts(const Reading& reading)
{
    if (!reading.timeUtc.empty() && !isUtcText(reading.timeUtc))
        return Error{ErrorCode::InvalidInput,
            {MARKED("db", "the time of a reading, %1, is no moment; expected UTC as YYYY-MM-DDTHH:MM:SSZ"), inQuotes(reading.timeUtc)}};
    std::size_t longest = reading.note.size();
    if (reading.exclusion)
        longest = std::max(longest, reading.exclusion->reason.size());
    if (longest > kLongestText)
        return Error{
            ErrorCode::InvalidInput, {MARKED("db", "a text of a reading has %1 bytes; expected at most %2"), longest, kLongestText}};
    return {};
}

/// Counted no further than it takes to know: a whole log may be changed in one step.
Result<bool> isALog(Database& database, SwingId swing)
{
    Statement statement(database, "SELECT COUNT(*) FROM (SELECT 1 FROM reading WHERE swing_id = ? LIMIT ?)");
    statement << swing << static_cast<std::int64_t>(kRefreshedAtOnce + 1);
    return oneOf<bool>(statement, database, MARKED("db", "swing"),
        [](Statement& row) { return row.integer(0) > static_cast<std::int64_t>(kRefreshedAtOnce); });
}

/// After a change of readings: cached results, audit entry, commit. @param only the reading whose figures are all that changed.
Result<void> finish(Database& database, Transaction& transaction, const Swing& swing, const std::string& what, const std::string& detail,
    ReadingId only = {})
{
    const auto isLog = only.valid() ? isALog(database, swing.id) : Result<bool>(false);
    if (!isLog)
        return isLog.error();
    if (const auto refreshed = *isLog ? markBehind(database, swing.id, swing.compass) : refreshSwing(database, swing.id); !refreshed)
        return refreshed;
    if (const auto kept = audit(database, what, swing.record, detail); !kept)
        return kept;
    database.changes().note(change::OfSwing{swing.id, only});
    return transaction.commit();
}

std::string auditTexts(std::span<const Reading> readings)
{
    std::string detail;
    for (const auto& reading : readings)
        detail += (detail.empty() ? "reading: " : "; reading: ") + auditText(reading);
    return detail;
}

} // namespace

Result<std::size_t> countOfReadings(Database& database, SwingId swing)
{
    Statement statement(database, "SELECT COUNT(*) FROM reading WHERE swing_id = ?");
    statement << swing;
    return oneOf<std::size_t>(
        statement, database, MARKED("db", "swing"), [](Statement& row) { return static_cast<std::size_t>(row.integer(0)); });
}

Result<std::vector<ReadingId>> insertReadings(Database& database, SwingId swing, int position, std::span<const Reading> readings)
{
    static const QString kInsert = "INSERT INTO reading (id, swing_id, position, " + readingFields().join(", ") + ") VALUES ("
        + nextNumber("reading") + ", " + placeholders(readingFields().size() + 2) + ")";
    Statement statement(database, kInsert);
    std::vector<ReadingId> ids;
    for (const auto& reading : readings) {
        if (const auto checked = checkTexts(reading); !checked)
            return checked.error();
        statement << swing << position++;
        bindReading(statement, reading);
        if (const auto done = statement.run(); !done)
            return done.error();
        ids.push_back(ReadingId{statement.insertedId()});
    }
    return ids;
}

Result<Reading> SwingStore::reading(SwingId swing, ReadingId id)
{
    Statement statement(m_database, "SELECT " + readingColumns() + " FROM reading r WHERE r.id = ? AND r.swing_id = ?");
    statement << id << swing;
    return oneOf<Reading>(statement, m_database, MARKED("db", "reading of the swing"), [](Statement& row) { return readingFrom(row, 0); });
}

Result<void> SwingStore::replaceReadings(SwingId id, const std::vector<Reading>& readings)
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
    if (const auto inserted = db::insertReadings(m_database, id, 0, readings); !inserted)
        return inserted.error();
    return finish(m_database, *transaction, *open, "set readings", auditTexts(readings));
}

Result<ReadingId> SwingStore::insertReading(SwingId swing, int position, const Reading& reading)
{
    const auto ids = insertReadings(swing, position, {&reading, 1});
    if (!ids)
        return ids.error();
    return ids->front();
}

Result<std::vector<ReadingId>> SwingStore::insertReadings(SwingId swing, int position, std::span<const Reading> readings)
{
    LUBBERLINE_EXPECT(position >= 0 && !readings.empty(), "a reading's position counts from 0");
    auto transaction = Transaction::begin(m_database);
    if (!transaction)
        return transaction.error();
    const auto open = openSwing(m_database, swing);
    if (!open)
        return open.error();
    Statement shift(m_database, "UPDATE reading SET position = position + ? WHERE swing_id = ? AND position >= ?");
    shift << static_cast<std::int64_t>(readings.size()) << swing << position;
    if (const auto done = shift.run(); !done)
        return done.error();
    auto ids = db::insertReadings(m_database, swing, position, readings);
    if (!ids)
        return ids;
    const bool one = readings.size() == 1;
    if (const auto done
        = finish(m_database, *transaction, *open, "added reading", one ? auditText(readings.front()) : auditTexts(readings));
        !done)
        return done.error();
    return ids;
}

Result<void> SwingStore::changeReading(SwingId swing, const Reading& known, const Reading& reading)
{
    const ReadingChange change{known, reading};
    return changeReadings(swing, {&change, 1});
}

Result<void> SwingStore::changeReadings(SwingId swing, std::span<const ReadingChange> changes)
{
    auto transaction = Transaction::begin(m_database);
    if (!transaction)
        return transaction.error();
    const auto open = openSwing(m_database, swing);
    if (!open)
        return open.error();
    static const QString kUpdate = "UPDATE reading SET " + readingFields().join(" = ?, ") + " = ? WHERE id = ?";
    Statement statement(m_database, kUpdate);
    std::string detail;
    ReadingId only;
    for (const auto& [known, reading] : changes) {
        const auto before = this->reading(swing, reading.id);
        if (!before)
            return before.error();
        if (*before == reading)
            continue;
        if (*before != known)
            return Error{ErrorCode::Conflict,
                {MARKED("db", "this reading has been changed elsewhere to: %1; nothing was overwritten, look at it again"),
                    auditText(*before)},
                m_database.path().toStdString()};
        if (const auto checked = checkTexts(reading); !checked)
            return checked;
        bindReading(statement, reading);
        statement << reading.id;
        if (const auto done = statement.run(); !done)
            return done;
        only = detail.empty() ? reading.id : ReadingId();
        detail += (detail.empty() ? "" : "; ") + auditText(*before) + " -> " + auditText(reading);
    }
    if (detail.empty())
        return transaction->commit();
    return finish(m_database, *transaction, *open, "changed reading", detail, only);
}

Result<void> SwingStore::removeReading(SwingId swing, ReadingId reading) { return removeReadings(swing, {&reading, 1}); }

Result<void> SwingStore::removeReadings(SwingId swing, std::span<const ReadingId> readings)
{
    LUBBERLINE_EXPECT(!readings.empty(), "something is removed");
    auto transaction = Transaction::begin(m_database);
    if (!transaction)
        return transaction.error();
    const auto open = openSwing(m_database, swing);
    if (!open)
        return open.error();
    std::vector<Reading> removed;
    Statement remove(m_database, "DELETE FROM reading WHERE id = ?");
    for (const ReadingId id : readings) {
        auto before = reading(swing, id);
        if (!before)
            return before.error();
        removed.push_back(std::move(before.value()));
        remove << id;
        if (const auto done = remove.run(); !done)
            return done;
    }
    Statement close(m_database,
        "UPDATE reading SET position = place.n FROM (SELECT id, ROW_NUMBER() OVER (ORDER BY position, id) - 1 AS n FROM reading"
        " WHERE swing_id = ?) AS place WHERE reading.id = place.id AND position <> place.n");
    close << swing;
    if (const auto done = close.run(); !done)
        return done;
    const bool one = removed.size() == 1;
    return finish(m_database, *transaction, *open, "removed reading", one ? auditText(removed.front()) : auditTexts(removed));
}

} // namespace lubberline::db
