#pragma once
/// Private to db: how a record with an id and a record id is written: one transaction, one audit entry with what changed.

#include <QStringList>

#include "core/record/Id.h"
#include "db/engine/Changes.h"
#include "db/engine/Statement.h"
#include "db/engine/Transaction.h"
#include "db/saving/Audit.h"

namespace lubberline::db {

/// Where the records of one kind are stored.
struct Table {
    Pattern what; ///< "aircraft type"
    QString name;
    QStringList fields;                 ///< the columns of the particulars: all but the id, the record id and what is computed
    void (*read)(const Statement& row); ///< makes a record of a row of selectFrom(); damages it where it is none
};

/// "SELECT id, record, fields FROM table ".
[[nodiscard]] QString selectFrom(const Table& table);

/// The particulars of a row as text, for the audit trail.
struct StoredRow {
    RecordId record;
    std::vector<std::string> fields;
};
/// Errors: NotFound; where it must be readable, Corrupt.
enum class RowMust { BeThere, BeReadable };
Result<StoredRow> storedRow(Database& database, const Table& table, std::int64_t id, RowMust must = RowMust::BeThere);
/// What could not be read again must not be stored. Errors: NotFound, InvalidInput.
Result<StoredRow> writtenRow(Database& database, const Table& table, std::int64_t id);

/// "name: before -> after; …" of the fields that differ; without the arrow where there was nothing before.
[[nodiscard]] std::string changesBetween(const Table& table, const StoredRow& before, const StoredRow& after);

/// The number of a new row, as an expression: the next that no row has or ever had.
[[nodiscard]] QString nextNumber(const QString& table);
[[nodiscard]] QString insertInto(const Table& table); ///< parameters: record id, fields
[[nodiscard]] QString sameAs(const Table& table);     ///< parameters: fields, id; a row where all of them are so
[[nodiscard]] QString updateOf(const Table& table);   ///< parameters: fields, id
[[nodiscard]] QString placeholders(qsizetype count);  ///< "?, ?, …"

[[nodiscard]] Error changedElsewhere(const Database& database, const Table& table, const StoredRow& row);
Result<bool> exists(Statement& statement); ///< whether it has a row

/// A new record (a record id is made when there is none). `bind(statement, record)` binds the fields in their order.
template <class IdType, class Record, class Bind>
Result<IdType> addRecord(Database& database, const Table& table, const Record& record, Bind bind)
{
    auto transaction = Transaction::begin(database);
    if (!transaction)
        return transaction.error();
    Statement statement(database, insertInto(table));
    statement << (record.record.empty() ? newRecordId() : record.record);
    bind(statement, record);
    if (const auto done = statement.run(); !done)
        return done.error();
    const IdType id{statement.insertedId()};
    const auto after = writtenRow(database, table, id.value);
    if (!after)
        return after.error();
    if (const auto kept = audit(database, "added " + std::string(table.what.english), after->record, changesBetween(table, {}, *after));
        !kept)
        return kept.error();
    if (const auto committed = transaction->commit(); !committed)
        return committed.error();
    return id;
}

/// The policy for concurrent change, the same for every kind of record: whoever changes one says what he knew of it. When it is
/// something else by now, nothing is overwritten, unless it is already as he wants it.
/// Errors: NotFound; Conflict.
template <class IdType, class Record, class Bind>
Result<void> changeRecord(Database& database, const Table& table, IdType id, const Record& known, const Record& record, Bind bind)
{
    auto transaction = Transaction::begin(database);
    if (!transaction)
        return transaction.error();
    const auto before = storedRow(database, table, id.value);
    if (!before)
        return before.error();
    const auto isAs = [&](const Record& one) -> Result<bool> {
        Statement same(database, sameAs(table));
        bind(same, one);
        same << id;
        return exists(same);
    };
    const auto done = isAs(record);
    if (!done)
        return done.error();
    if (*done)
        return transaction->commit();
    const auto asKnown = isAs(known);
    if (!asKnown)
        return asKnown.error();
    if (!*asKnown)
        return changedElsewhere(database, table, *before);
    Statement statement(database, updateOf(table));
    bind(statement, record);
    statement << id;
    if (const auto stored = statement.run(); !stored)
        return stored;
    const auto after = writtenRow(database, table, id.value);
    if (!after)
        return after.error();
    if (const auto kept
        = audit(database, "changed " + std::string(table.what.english), after->record, changesBetween(table, *before, *after));
        !kept)
        return kept;
    return transaction->commit();
}

/// A row of a record that the rest of the program knows by its RecordId alone.
using RowId = Id<struct RowTag>;
/// Not valid where there is no such record.
Result<RowId> rowWith(Database& database, const Table& table, const RecordId& record);
/// Takes a record out; what it said stays readable in the audit trail. Errors: NotFound.
Result<void> removeRecord(Database& database, const Table& table, const RecordId& record);

/// Errors: InvalidInput when the name is empty.
Result<void> requireName(const std::string& name, Pattern what);

/// Runs `store` in one transaction and notes what changed in it: `note()`, or `note(id)` where `store` returns an id.
template <class Store, class Note>
auto noting(Database& database, Store store, Note note) -> decltype(store())
{
    auto transaction = Transaction::begin(database);
    if (!transaction)
        return transaction.error();
    auto stored = store();
    if (!stored)
        return stored;
    if constexpr (std::is_same_v<decltype(stored), Result<void>>)
        note();
    else
        note(*stored);
    if (const auto committed = transaction->commit(); !committed)
        return committed.error();
    return stored;
}

} // namespace lubberline::db
