#pragma once
/// Private to db: which row is meant by a name.

#include "db/engine/Statement.h"

namespace lubberline::db {

/// The id of the first row of `table` that is so; not valid: there is none.
template <class IdType, class... Values>
Result<IdType> rowWhere(Database& database, const QString& table, const char* where, const Values&... values)
{
    Statement statement(database, "SELECT id FROM " + table + " WHERE " + where);
    static_cast<void>((statement << ... << values));
    const auto found = firstOf<IdType>(statement, [](Statement& row) { return row.id<IdType>(0); });
    if (!found)
        return found.error();
    return found->value_or(IdType{});
}

} // namespace lubberline::db
