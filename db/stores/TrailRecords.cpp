#include "db/stores/TrailRecords.h"

#include "db/chain/Links.h"
#include "db/engine/Statement.h"
#include "db/stores/Tables.h"

namespace lubberline::db {

namespace {

/// Those whose rows are entered in the trail, each under its record id.
QStringList tables()
{
    QStringList names;
    for (const Table* table : {&typeTable(), &aircraftTable(), &compassTable(), &eventTable(), &swingTable(), &siteTable(), &limitsTable(),
             &instrumentTable(), &sensorTable(), &electricalTable(), &coilTable(), &ruleTable(), &waiverTable()})
        names += table->name;
    return names;
}

/// Of each record the last entry. An import of years that was undone takes its rows out under one entry for all, and nothing that is signed.
Result<void> findMissing(Database& database, std::int64_t before, std::vector<Message>& findings)
{
    QString sql
        = "SELECT last, time_utc, what, record FROM (SELECT MAX(id) AS last, time_utc, what, record FROM audit_entry WHERE record <> ''"
          " GROUP BY record) WHERE what NOT LIKE 'removed %' AND what NOT LIKE '% guided swing' AND what NOT LIKE '% key' AND last > ?"
          " AND (what = 'froze swing' OR last > (SELECT IFNULL(MAX(id), 0) FROM audit_entry WHERE what = 'undone import'))";
    for (const QString& table : tables())
        sql += " AND record NOT IN (SELECT record FROM " + table + ")";
    Statement statement(database, sql);
    statement << before;
    const auto missing = rowsOf<Message>(statement, [](Statement& row) -> Message {
        return {
            MARKED("db",
                "the record %1, of which the audit trail says last \"%2\" at %3, is not there: it was taken out behind the program's back"),
            row.anything(3), row.anything(2), row.anything(1)};
    });
    if (!missing)
        return missing.error();
    findings.insert(findings.end(), missing->begin(), missing->end());
    return {};
}

Result<void> findPutIn(Database& database, std::vector<Message>& findings)
{
    for (const QString& table : tables()) {
        Statement statement(database,
            "SELECT id, record FROM " + table
                + " WHERE record NOT IN (SELECT record FROM audit_entry) OR (SELECT what FROM audit_entry a WHERE a.record = " + table
                + ".record ORDER BY a.id DESC LIMIT 1) LIKE 'removed %'");
        const auto rows = rowsOf<Message>(statement, [&table](Statement& row) -> Message {
            return {MARKED("db", "%1, row %2: the audit trail does not know the record %3: it was put in behind the program's back"),
                table.toStdString(), row.anything(0), row.anything(1)};
        });
        if (!rows)
            return rows.error();
        findings.insert(findings.end(), rows->begin(), rows->end());
    }
    return {};
}

Result<void> findKeys(Database& database, std::vector<Message>& findings)
{
    Statement statement(database,
        "SELECT fingerprint, holder FROM signing_key k WHERE NOT EXISTS (SELECT 1 FROM (SELECT what, detail FROM audit_entry WHERE"
        " record = k.fingerprint ORDER BY id DESC LIMIT 1) WHERE what IN ('added key', 'renewed key') AND detail = 'holder: ' || k.holder)");
    const auto strange = rowsOf<Message>(statement, [](Statement& row) -> Message {
        return {MARKED("db",
                    "the key %1 of %2 is not what the audit trail says: it was put in, or given to another, behind the program's back"),
            row.anything(0), row.anything(1)};
    });
    if (!strange)
        return strange.error();
    findings.insert(findings.end(), strange->begin(), strange->end());
    Statement gone(database,
        "SELECT last, record, detail FROM (SELECT MAX(id) AS last, what, record, detail FROM audit_entry WHERE what LIKE '% key' GROUP BY record)"
        " WHERE what <> 'removed key' AND record NOT IN (SELECT fingerprint FROM signing_key)");
    const auto missing = rowsOf<Message>(gone, [](Statement& row) -> Message {
        return {MARKED("db", "the key %1 (%2) is not there, and the audit trail does not say that it was removed"), row.anything(1),
            row.anything(2)};
    });
    if (!missing)
        return missing.error();
    findings.insert(findings.end(), missing->begin(), missing->end());
    return {};
}

} // namespace

Result<std::vector<Message>> recordFaults(Database& database)
{
    const auto head = chainHead(database);
    if (!head)
        return head.error();
    std::vector<Message> findings;
    if (const auto done = findMissing(database, head->before, findings); !done)
        return done.error();
    if (head->before == 0)
        if (const auto done = findPutIn(database, findings); !done)
            return done.error();
    if (const auto done = findKeys(database, findings); !done)
        return done.error();
    return findings;
}

} // namespace lubberline::db
