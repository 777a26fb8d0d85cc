#include "db/saving/Saving.h"

namespace lubberline::db {

QString selectFrom(const Table& table) { return "SELECT id, record, " + table.fields.join(", ") + " FROM " + table.name + " "; }

Result<StoredRow> storedRow(Database& database, const Table& table, std::int64_t id, RowMust must)
{
    Statement statement(database, selectFrom(table) + "WHERE id = ?");
    statement << id;
    return oneOf<StoredRow>(statement, database, table.what, [&](Statement& row) {
        if (must == RowMust::BeReadable)
            table.read(row);
        StoredRow stored{row.anything(1), {}};
        for (int i = 0; i < table.fields.size(); ++i)
            stored.fields.push_back(row.anything(2 + i));
        return stored;
    });
}

Result<StoredRow> writtenRow(Database& database, const Table& table, std::int64_t id)
{
    auto row = storedRow(database, table, id, RowMust::BeReadable);
    if (row || row.error().code != ErrorCode::Corrupt)
        return row;
    return Error{ErrorCode::InvalidInput, row.error().message, row.error().file};
}

std::string changesBetween(const Table& table, const StoredRow& before, const StoredRow& after)
{
    std::string text;
    for (std::size_t i = 0; i < after.fields.size(); ++i) {
        const std::string was = i < before.fields.size() ? before.fields[i] : std::string();
        if (was == after.fields[i])
            continue;
        text += (text.empty() ? "" : "; ") + table.fields[static_cast<qsizetype>(i)].toStdString() + ": ";
        text += was.empty() ? after.fields[i] : was + " -> " + after.fields[i];
    }
    return text;
}

QString nextNumber(const QString& table)
{
    return QStringLiteral(
        "(SELECT 1 + MAX(COALESCE((SELECT MAX(id) FROM %1), 0), COALESCE((SELECT last FROM used_number WHERE name = '%1'), 0)))")
        .arg(table);
}

QString insertInto(const Table& table)
{
    return "INSERT INTO " + table.name + " (id, record, " + table.fields.join(", ") + ") VALUES (" + nextNumber(table.name) + ", "
        + placeholders(table.fields.size() + 1) + ")";
}

QString sameAs(const Table& table)
{
    return "SELECT 1 FROM " + table.name + " WHERE " + table.fields.join(" IS ? AND ") + " IS ? AND id = ?";
}

QString updateOf(const Table& table) { return "UPDATE " + table.name + " SET " + table.fields.join(" = ?, ") + " = ? WHERE id = ?"; }

QString placeholders(qsizetype count) { return QStringList(count, "?").join(", "); }

Result<RowId> rowWith(Database& database, const Table& table, const RecordId& record)
{
    Statement statement(database, "SELECT id FROM " + table.name + " WHERE record = ?");
    statement << record;
    const auto found = firstOf<RowId>(statement, [](Statement& row) { return row.id<RowId>(0); });
    if (!found)
        return found.error();
    return found->value_or(RowId{});
}

Error changedElsewhere(const Database& database, const Table& table, const StoredRow& row)
{
    return {ErrorCode::Conflict,
        {MARKED("db", "this %1 (%2) has been changed elsewhere; nothing was overwritten, look at it again"), table.what,
            row.fields.front()},
        database.path().toStdString()};
}

Result<bool> exists(Statement& statement)
{
    if (const auto done = statement.run(); !done)
        return done.error();
    return statement.next();
}

Result<void> removeRecord(Database& database, const Table& table, const RecordId& record)
{
    auto transaction = Transaction::begin(database);
    if (!transaction)
        return transaction.error();
    const auto id = rowWith(database, table, record);
    if (!id)
        return id.error();
    const auto row = storedRow(database, table, id->value);
    if (!row)
        return row.error();
    Statement statement(database, "DELETE FROM " + table.name + " WHERE id = ?");
    statement << *id;
    if (const auto done = statement.run(); !done)
        return done;
    if (const auto kept = audit(database, "removed " + std::string(table.what.english), record, changesBetween(table, {}, *row)); !kept)
        return kept;
    return transaction->commit();
}

Result<void> requireName(const std::string& name, Pattern what)
{
    if (name.empty())
        return Error{ErrorCode::InvalidInput, {MARKED("db", "%1 is empty; expected a name"), what}};
    return {};
}

} // namespace lubberline::db
