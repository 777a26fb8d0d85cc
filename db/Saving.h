#pragma once
/// Private to db: how a record with an id and a record id is written: one transaction, one audit entry.

#include "core/record/Id.h"
#include "db/Audit.h"
#include "db/Statement.h"
#include "db/Transaction.h"

namespace lubberline::db {

/// `bind` binds the columns between record and id, in the order of both statements:
///   insert: INSERT INTO … (record, columns…) VALUES (?, …)      update: UPDATE … SET columns… WHERE id = ?
template <class IdType, class Bind>
Result<IdType> saveRecord(Database& database, const char* what, IdType id, const RecordId& record, const std::string& name,
    const QString& insert, const QString& update, Bind bind)
{
    auto transaction = Transaction::begin(database);
    if (!transaction)
        return transaction.error();
    Statement statement(database, id.valid() ? update : insert);
    const RecordId identity = record.empty() ? newRecordId() : record;
    if (!id.valid())
        statement << identity;
    bind(statement);
    if (id.valid())
        statement << id;
    if (const auto done = statement.run(); !done)
        return done.error();
    if (id.valid() && statement.changed() == 0)
        return Error{ErrorCode::NotFound, std::string("there is no such ") + what + " any more", database.path().toStdString()};
    const IdType stored = id.valid() ? id : IdType{statement.insertedId()};
    if (const auto kept = audit(database, std::string(id.valid() ? "changed " : "added ") + what, identity, name); !kept)
        return kept.error();
    if (const auto committed = transaction->commit(); !committed)
        return committed.error();
    return stored;
}

inline Result<void> requireName(const std::string& name, const char* what)
{
    if (name.empty())
        return Error{ErrorCode::InvalidInput, std::string(what) + " is empty; expected a name"};
    return {};
}

} // namespace lubberline::db
