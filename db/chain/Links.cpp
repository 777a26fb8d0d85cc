#include "db/chain/Links.h"

#include <QCryptographicHash>

#include <map>

#include "core/record/Id.h"
#include "db/engine/Statement.h"

namespace lubberline::db {

namespace {

/// With its length before it, so that nothing can move from one field into the next.
std::string field(const std::string& text) { return std::to_string(text.size()) + ":" + text + "\n"; }

} // namespace

std::string sha256(const std::string& text)
{
    return QCryptographicHash::hash(QByteArray::fromStdString(text), QCryptographicHash::Sha256).toHex().toStdString();
}

std::string recordLink(const std::string& before, const ChainEntry& entry)
{
    return sha256("lubberline audit entry 1\n" + field(before) + field(std::to_string(entry.id)) + field(entry.timeUtc) + field(entry.what)
        + field(entry.record) + field(entry.detail));
}

std::string fileLink(const std::string& before, const std::string& recordLink)
{
    return sha256("lubberline audit file 1\n" + field(before) + field(recordLink));
}

Result<ChainHead> chainHead(const Database& database)
{
    Statement statement(database, "SELECT file, entries, head, entries_before, since_utc FROM audit_head WHERE id = 1");
    const auto found = firstOf<ChainHead>(statement, [](Statement& row) {
        return ChainHead{row.text(0), row.integer(1), row.text(2), row.integer(3), row.text(4)};
    });
    if (!found)
        return found.error();
    if (!*found)
        return Error{
            ErrorCode::Corrupt, MARKED("db", "audit_head has no row; expected the head of the audit trail"), database.path().toStdString()};
    return **found;
}

Result<std::string> recordHead(const Database& database, const std::string& record)
{
    Statement statement(database, "SELECT link FROM audit_entry WHERE record = ? ORDER BY id DESC LIMIT 1");
    statement << record;
    const auto found = firstOf<std::string>(statement, [](Statement& row) { return row.text(0); });
    return found ? Result<std::string>(found->value_or(std::string())) : found.error();
}

Result<void> beginChain(const Database& database)
{
    Statement all(database, "SELECT id, time_utc, what, record, detail FROM audit_entry ORDER BY id");
    const auto entries = rowsOf<ChainEntry>(all, [](Statement& row) {
        return ChainEntry{row.integer(0), row.text(1), row.text(2), row.text(3), row.longText(4)};
    });
    if (!entries)
        return entries.error();
    const std::string file = newRecordId();
    std::string head = file;
    std::map<std::string, std::string> records;
    Statement link(database, "UPDATE audit_entry SET link = ?, file_link = ? WHERE id = ?");
    for (const ChainEntry& entry : *entries) {
        std::string& before = records[entry.record];
        before = recordLink(before, entry);
        head = fileLink(head, before);
        link << before << head << entry.id;
        if (const auto done = link.run(); !done)
            return done;
    }
    const std::int64_t last = entries->empty() ? 0 : entries->back().id;
    Statement begun(database, "INSERT INTO audit_head (id, file, entries, head, entries_before, since_utc) VALUES (1, ?, ?, ?, ?, ?)");
    begun << file << last << head << last << database.clock().nowUtc();
    return begun.run();
}

} // namespace lubberline::db
