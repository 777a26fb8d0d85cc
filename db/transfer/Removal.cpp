#include "db/transfer/Removal.h"

#include <QSqlError>
#include <QSqlQuery>
#include <QSqlRecord>

#include <algorithm>

#include "db/engine/Changes.h"
#include "db/engine/SqlError.h"
#include "db/engine/Statement.h"
#include "db/engine/Transaction.h"
#include "db/saving/Audit.h"

namespace lubberline::db {

namespace {

struct Reference {
    QString table, column;
};

/// What belongs to a row of a table: all that refers to it, but a base or limits, which own nobody.
Result<std::vector<Reference>> belongings(const Database& database, const QString& table)
{
    Statement statement(database,
        "SELECT m.name, k.\"from\" FROM sqlite_master m, pragma_foreign_key_list(m.name) k WHERE m.type = 'table' AND k.\"table\" = ?");
    statement << table.toStdString();
    return rowsOf<Reference>(statement, [](Statement& row) {
        return Reference{QString::fromStdString(row.text(0)), QString::fromStdString(row.text(1))};
    });
}

Result<std::vector<std::int64_t>> rowsThatRefer(const Database& database, const Reference& reference, std::int64_t id)
{
    Statement statement(database, QStringLiteral("SELECT id FROM %1 WHERE %2 = ? ORDER BY id").arg(reference.table, reference.column));
    statement << id;
    return rowsOf<std::int64_t>(statement, [](Statement& row) { return row.integer(0); });
}

std::string nameOf(const QSqlRecord& row)
{
    for (const char* column : {"registration", "name", "date", "record"})
        if (row.contains(column) && !row.value(column).toString().isEmpty())
            return row.value(column).toString().toStdString();
    return {};
}

std::string contentsOf(const QSqlRecord& row)
{
    std::string text;
    for (int i = 0; i < row.count(); ++i)
        if (const QString value = row.value(i).toString(); !value.isEmpty() && !row.fieldName(i).endsWith("id"))
            text += (text.empty() ? "" : "; ") + row.fieldName(i).toStdString() + ": " + value.toStdString();
    return text;
}

/// Why what belongs to it may not go with it; ok: it may.
Result<void> mayGo(const Database& database, const QString& table, const QSqlRecord& row)
{
    const auto refuse = [&](Pattern why) { return Error{ErrorCode::Frozen, {why, nameOf(row)}, database.path().toStdString()}; };
    if (table == "swing" && row.value("state").toInt() == 2)
        return refuse(MARKED("db", "the swing of %1 in it is signed and stays on record; what has something signed cannot be removed"));
    if (table == "swing" && row.value("state").toInt() == 1)
        return refuse(MARKED("db", "the swing of %1 in it is complete; open it again, or it stays on record"));
    if (table == "signature")
        return refuse(MARKED("db", "%1 has signed a swing in it, which stays on record; what has something signed cannot be removed"));
    if (table == "waiver")
        return refuse(MARKED("db", "a waiver of %1 in it is signed and stays on record; what has something signed cannot be removed"));
    return {};
}

} // namespace

Result<Removed> Removal::remove(AircraftTypeId id) { return take(QStringLiteral("aircraft_type"), id.value); }
Result<Removed> Removal::remove(AircraftId id) { return take(QStringLiteral("aircraft"), id.value); }
Result<Removed> Removal::remove(CompassId id) { return take(QStringLiteral("compass"), id.value); }

Result<void> Removal::collectChildren(Removed& removed, const QString& table, std::int64_t id)
{
    const auto references = belongings(m_database, table);
    if (!references)
        return references.error();
    for (const Reference& reference : *references) {
        const auto rows = rowsThatRefer(m_database, reference, id);
        if (!rows)
            return rows.error();
        for (const std::int64_t row : *rows)
            if (auto collected = collect(removed, reference.table, row); !collected)
                return collected;
    }
    return {};
}

/// Those that refer to a row go before it.
Result<void> Removal::collect(Removed& removed, const QString& table, std::int64_t id)
{
    if (auto children = collectChildren(removed, table, id); !children)
        return children;
    QSqlQuery query(m_database.connection());
    if (!query.exec(QStringLiteral("SELECT * FROM %1 WHERE id = %2").arg(table).arg(id)))
        return errorOf(query.lastError(), m_database.path());
    if (!query.next())
        return Error{
            ErrorCode::NotFound, MARKED("db", "the record that is to be removed is gone already"), m_database.path().toStdString()};
    const QSqlRecord row = query.record();
    if (auto allowed = mayGo(m_database, table, row); !allowed)
        return allowed;
    Removed::Row kept{table, {}, {}};
    for (int i = 0; i < row.count(); ++i) {
        kept.columns.push_back(row.fieldName(i));
        kept.values.push_back(row.value(i));
    }
    removed.m_rows.push_back(std::move(kept));
    if (row.contains("record"))
        return audit(m_database, "removed " + table.toStdString(), row.value("record").toString().toStdString(), contentsOf(row));
    return {};
}

Result<Removed> Removal::take(const QString& table, std::int64_t id)
{
    auto transaction = Transaction::begin(m_database);
    if (!transaction)
        return transaction.error();
    Removed removed;
    if (const auto collected = collect(removed, table, id); !collected)
        return collected.error();
    for (const auto& row : removed.m_rows) {
        const auto key = static_cast<std::size_t>(std::find(row.columns.begin(), row.columns.end(), "id") - row.columns.begin());
        Statement statement(m_database, QStringLiteral("DELETE FROM %1 WHERE id = ?").arg(row.table));
        statement << static_cast<std::int64_t>(row.values[key].toLongLong());
        if (const auto done = statement.run(); !done)
            return done.error();
    }
    note();
    if (const auto committed = transaction->commit(); !committed)
        return committed.error();
    return removed;
}

Result<void> Removal::putBack(const Removed& removed)
{
    auto transaction = Transaction::begin(m_database);
    if (!transaction)
        return transaction.error();
    for (auto row = removed.m_rows.rbegin(); row != removed.m_rows.rend(); ++row) {
        QStringList columns, places;
        for (const QString& column : row->columns) {
            columns += column;
            places += QStringLiteral("?");
        }
        QSqlQuery query(m_database.connection());
        if (const auto& fault = m_database.fault(); fault)
            if (const auto refused = fault(QStringLiteral("INSERT INTO ") + row->table); refused)
                return *refused;
        query.prepare(QStringLiteral("INSERT INTO %1 (%2) VALUES (%3)").arg(row->table, columns.join(", "), places.join(", ")));
        for (const QVariant& value : row->values)
            query.addBindValue(value);
        if (!query.exec())
            return errorOf(query.lastError(), m_database.path());
        const auto record = std::find(row->columns.begin(), row->columns.end(), "record");
        if (record != row->columns.end())
            if (auto kept = audit(m_database, "put back " + row->table.toStdString(),
                    row->values[static_cast<std::size_t>(record - row->columns.begin())].toString().toStdString(), {});
                !kept)
                return kept;
    }
    note();
    return transaction->commit();
}

void Removal::note()
{
    m_database.changes().note(change::Fleet{});
    m_database.changes().note(change::Due{});
}

} // namespace lubberline::db
