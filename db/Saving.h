#pragma once
/// Private to db: how a record with an id and a record id is written: one transaction, one audit entry with what changed.

#include <QStringList>

#include "core/record/Id.h"
#include "db/Audit.h"
#include "db/Statement.h"
#include "db/Transaction.h"

namespace lubberline::db {

/// Where the records of one kind are stored.
struct Table {
    const char* what; ///< for people: "aircraft type"
    QString name;
    QStringList fields; ///< the columns of the particulars: all but the id, the record id and what is computed
};

/// The particulars of a row as text, for the audit trail.
struct StoredRow {
    RecordId record;
    std::vector<std::string> fields;
};
/// Errors: NotFound.
Result<StoredRow> storedRow(Database& database, const Table& table, std::int64_t id);

/// "name: before -> after; …" of the fields that differ; without the arrow where there was nothing before.
[[nodiscard]] std::string changesBetween(const Table& table, const StoredRow& before, const StoredRow& after);

[[nodiscard]] QString insertInto(const Table& table); ///< parameters: record id, fields
[[nodiscard]] QString updateOf(const Table& table);   ///< parameters: fields, id
[[nodiscard]] QString placeholders(qsizetype count);  ///< "?, ?, …"

/// Inserts (id not valid; a record id is made when there is none) or updates. `bind` binds the fields in their order.
template <class IdType, class Bind>
Result<IdType> saveRecord(Database& database, const Table& table, IdType id, const RecordId& record, Bind bind)
{
    auto transaction = Transaction::begin(database);
    if (!transaction)
        return transaction.error();
    const bool isNew = !id.valid();
    const Result<StoredRow> before = isNew ? StoredRow{record.empty() ? newRecordId() : record, {}} : storedRow(database, table, id.value);
    if (!before)
        return before.error();
    Statement statement(database, isNew ? insertInto(table) : updateOf(table));
    if (isNew)
        statement << before->record;
    bind(statement);
    if (!isNew)
        statement << id;
    if (const auto done = statement.run(); !done)
        return done.error();
    if (isNew)
        id = IdType{statement.insertedId()};
    const auto after = storedRow(database, table, id.value);
    if (!after)
        return after.error();
    const std::string changes = changesBetween(table, *before, *after);
    if (isNew || !changes.empty())
        if (const auto kept = audit(database, (isNew ? "added " : "changed ") + std::string(table.what), after->record, changes); !kept)
            return kept.error();
    if (const auto committed = transaction->commit(); !committed)
        return committed.error();
    return id;
}

/// A row of a record that the rest of the program knows by its RecordId alone.
using RowId = Id<struct RowTag>;
/// Not valid where there is no such record.
Result<RowId> rowWith(Database& database, const Table& table, const RecordId& record);
/// Takes a record out; what it said stays readable in the audit trail. Errors: NotFound.
Result<void> removeRecord(Database& database, const Table& table, const RecordId& record);

/// Errors: InvalidInput when the name is empty.
Result<void> requireName(const std::string& name, const char* what);

} // namespace lubberline::db
