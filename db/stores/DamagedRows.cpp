#include <algorithm>
#include <set>

#include "core/base/FileText.h"
#include "core/format/exchange/JobJson.h"
#include "core/record/Status.h"
#include "db/stores/KeyStore.h"
#include "db/stores/Signatures.h"
#include "db/stores/SwingRows.h"
#include "db/stores/Tables.h"

namespace lubberline::db {

namespace {

using ReadRow = void (*)(const Statement& row);

struct Rows {
    QString sql;
    ReadRow read;
};

/// Tables that are no records of their own, and what is kept beside the particulars of a record.
std::vector<Rows> otherRows()
{
    return {
        {"SELECT r.swing_id, r.position, " + readingColumns() + " FROM reading r",
            [](const Statement& row) {
                (void)row.id<SwingId>(0);
                (void)row.integer(1, {0, double{kMaxReadings}});
                (void)readingFrom(row, 2);
            }},
        {"SELECT id, record, swing_id, plan_json, state FROM swing_job",
            [](const Statement& row) {
                (void)row.record(1);
                (void)row.id<SwingId>(2);
                if (const auto plan = readJobPlan(row.longText(3), {}); !plan)
                    row.damages(3, plan.error());
                (void)row.integer(4, {0, 2});
            }},
        {"SELECT id, job_id, place, event_json FROM job_event",
            [](const Statement& row) {
                (void)row.id<Id<struct JobTag>>(1);
                (void)row.integer(2, {0, 1e6});
                if (const auto event = readJobEvent(row.longText(3), {}); !event)
                    row.damages(3, event.error());
            }},
        {"SELECT id, job_id, field, typed FROM job_typed",
            [](const Statement& row) {
                (void)row.id<Id<struct JobTag>>(1);
                (void)row.name(2);
                (void)row.text(3);
            }},
        {"SELECT id, name, last FROM used_number",
            [](const Statement& row) {
                (void)row.name(1);
                (void)row.integer(2, {1, 1e15});
            }},
        {"SELECT id, time_utc, what, record, link, file_link, detail FROM audit_entry",
            [](const Statement& row) {
                (void)row.momentStated(1);
                (void)row.name(2);
                for (int column = 3; column <= 5; ++column)
                    (void)row.text(column);
                (void)row.longText(6);
            }},
        {"SELECT id, file, head, since_utc, entries, entries_before FROM audit_head",
            [](const Statement& row) {
                (void)row.name(1);
                (void)row.text(2);
                (void)row.momentStated(3);
                for (int column = 4; column <= 5; ++column)
                    (void)row.integer(column, {0, 1e15});
            }},
        {"SELECT id, fingerprint, holder, added_utc, public_key FROM signing_key",
            [](const Statement& row) {
                if (!isFingerprint(row.text(1)))
                    row.damages(1, MARKED("db", "40 or 64 capital hexadecimal digits"));
                (void)row.name(2);
                (void)row.momentStated(3);
                (void)row.longText(4);
            }},
        {"SELECT id, status FROM compass", [](const Statement& row) { (void)row.as(1, Status::OutOfLimits); }},
        {"SELECT " + swingRowColumns() + " FROM swing", [](const Statement& row) { (void)swingRowFrom(row); }},
    };
}

/// SQLite gives a text that is not UTF-8 with its bad bytes replaced: it is shown, but it is not what somebody wrote.
std::vector<Message> otherBytes(Database& database, const QString& table)
{
    Statement columns(database, "SELECT name FROM pragma_table_info(?) WHERE type = 'TEXT'");
    columns << table.toStdString();
    const auto names = rowsOf<std::string>(columns, [](Statement& row) { return row.text(0); });
    if (!names)
        return {described(names.error())};
    std::vector<Message> found;
    for (const auto& name : *names) {
        const QString column = QString::fromStdString(name);
        Statement suspects(database, // only where one stands is each byte looked at
            QStringLiteral("SELECT id, CAST(%1 AS BLOB) FROM %2 WHERE typeof(%1) = 'text' AND %1 GLOB '*[^' || char(1) || '-~]*'")
                .arg(column, table));
        const auto damaged = rowsOf<Message>(suspects, [&](Statement& row) -> Message {
            const auto why = notUtf8(row.bytes(1));
            return why.empty() ? Message() : Message{MARKED("db", "%1.%2, row %3: %4"), table.toStdString(), name, row.anything(0), why};
        });
        if (!damaged)
            found.push_back(described(damaged.error()));
        else
            std::copy_if(damaged->begin(), damaged->end(), std::back_inserter(found), [](const Message& one) { return !one.empty(); });
    }
    return found;
}

} // namespace

std::vector<Message> damagedRows(Database& database)
{
    std::vector<Message> all;
    std::set<std::string> told; // some columns are read twice
    const auto add = [&](const std::vector<Message>& damages) {
        for (const auto& damage : damages)
            if (told.insert(damage.english()).second)
                all.push_back(damage);
    };
    for (const Table* table : {&typeTable(), &aircraftTable(), &compassTable(), &eventTable(), &swingTable(), &siteTable(), &limitsTable(),
             &instrumentTable(), &sensorTable(), &electricalTable(), &coilTable(), &ruleTable(), &waiverTable()}) {
        Statement statement(database, selectFrom(*table));
        add(damagesIn(statement, [table](Statement& row) {
            (void)row.id<RowId>(0);
            table->read(row);
        }));
        add(otherBytes(database, table->name));
    }
    add(damagedSignatures(database));
    for (const auto& [sql, read] : otherRows()) {
        Statement statement(database, sql);
        add(damagesIn(statement, read));
    }
    for (const char* table : {"reading", "signature", "audit_entry", "signing_key"})
        add(otherBytes(database, table));
    return all;
}

std::vector<Message> damagedLists(Database& database)
{
    std::vector<Message> all;
    for (const auto& [sql, read] : std::vector<Rows>{
             {"SELECT id, name FROM aircraft_type", [](const Statement& row) { (void)row.text(1); }},
             {"SELECT id, registration FROM aircraft", [](const Statement& row) { (void)row.text(1); }},
             {"SELECT id, name, status FROM compass",
                 [](const Statement& row) {
                     (void)row.text(1);
                     (void)row.as(2, Status::OutOfLimits);
                 }},
             {"SELECT " + swingRowColumns() + " FROM swing", [](const Statement& row) { (void)swingRowFrom(row); }},
         }) {
        Statement statement(database, sql);
        const auto damages = damagesIn(statement, read);
        all.insert(all.end(), damages.begin(), damages.end());
    }
    return all;
}

} // namespace lubberline::db
