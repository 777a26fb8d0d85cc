#include "db/saving/Audit.h"

#include "db/chain/Links.h"
#include "db/engine/Statement.h"

namespace lubberline::db {

namespace {

/// What the next entry of a record follows.
struct Before {
    std::string head, link;
    std::int64_t last = 0;
};

/// The last number is that of the trail even where the head names an older one: somebody's row must not keep us from writing.
Result<Before> before(Database& database, const std::string& record)
{
    Statement statement(database,
        "SELECT head, (SELECT link FROM audit_entry WHERE record = ? ORDER BY id DESC LIMIT 1),"
        " MAX(entries, IFNULL((SELECT MAX(id) FROM audit_entry), 0)) FROM audit_head WHERE id = 1");
    statement << record;
    return oneOf<Before>(statement, database, MARKED("db", "head of the audit trail"), [](Statement& row) {
        return Before{row.text(0), row.optionalText(1), row.integer(2)};
    });
}

} // namespace

Result<void> audit(Database& database, const std::string& what, const std::string& record, const std::string& detail)
{
    const auto known = before(database, record);
    if (!known)
        return known.error();
    const ChainEntry entry{known->last + 1, database.clock().nowUtc_ms(), what, record, detail};
    const std::string link = recordLink(known->link, entry), head = fileLink(known->head, link);
    Statement statement(
        database, "INSERT INTO audit_entry (id, time_utc, what, record, detail, link, file_link) VALUES (?, ?, ?, ?, ?, ?, ?)");
    statement << entry.id << entry.timeUtc << what << record << detail << link << head;
    if (const auto kept = statement.run(); !kept)
        return kept;
    Statement moved(database, "UPDATE audit_head SET entries = ?, head = ? WHERE id = 1");
    moved << entry.id << head;
    return moved.run();
}

} // namespace lubberline::db
