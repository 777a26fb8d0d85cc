#include <cstdio>

#include <nlohmann/json.hpp>

#include "app/Console.h"
#include "app/OpenStores.h"
#include "app/Paths.h"
#include "app/QtSession.h"
#include "app/commands/Command.h"
#include "core/base/WholeFile.h"
#include "db/schema/Schema.h"
#include "db/transfer/Maintenance.h"

namespace lubberline::app {

namespace {

std::string entriesText(std::int64_t entries) { return entries == 1 ? "1 entry" : std::to_string(entries) + " entries"; }

struct DbArguments {
    std::string file;
    std::vector<std::string> heads;
    bool json = false;
};

/// Opens the database for reading and hands it to the work.
template <class Work>
int onDatabase(const std::string& option, Work work)
{
    const auto session = makeDrawingSession();
    auto stores = openStores(option, db::OpenMode::ReadOnly);
    return stores ? work((*stores)->database()) : fail(stores.error());
}

int statusCommand(db::Database& database, bool json)
{
    const auto status = db::status(database);
    if (!status)
        return fail(status.error());
    if (json) {
        put("%s\n",
            nlohmann::ordered_json{{"path", status->path}, {"size_bytes", status->bytes}, {"schema", status->schema},
                {"newest_schema", db::schemaVersion()}, {"journal", status->journal}, {"types", status->totals.types},
                {"aircraft", status->totals.aircraft}, {"compasses", status->totals.compasses}, {"swings", status->totals.swings},
                {"readings", status->readings}, {"sensor_models", status->sensorModels}, {"audit_entries", status->auditEntries},
                {"audit_head", status->chain.head}, {"audit_chained_since_utc", status->chain.sinceUtc},
                {"audit_entries_before_chain", status->chain.before}, {"file", status->chain.file}}
                .dump(2)
                .c_str());
        return kDone;
    }
    put("database       %s\nsize           %.1f MiB\nschema         %d (this program knows up to %d)\njournal        %s\ntypes          %d\n"
        "aircraft       %d\ncompasses      %d\nswings         %lld\nreadings       %lld\nsensor models  %lld\naudit entries  %lld\naudit head     %s\nchained since  %s\n",
        status->path.c_str(), static_cast<double>(status->bytes) / 1048576.0, status->schema, db::schemaVersion(), status->journal.c_str(),
        status->totals.types, status->totals.aircraft, status->totals.compasses, static_cast<long long>(status->totals.swings),
        static_cast<long long>(status->readings), static_cast<long long>(status->sensorModels),
        static_cast<long long>(status->auditEntries), status->chain.head.c_str(), status->chain.sinceUtc.c_str());
    return kDone;
}

int backupCommand(db::Database& database, const std::string& file)
{
    if (const auto done = db::backup(database, plainName(file)); !done)
        return fail(done.error());
    if (database.readAsCopy()) {
        say("wrote " + file);
        return kDone;
    }
    const auto status = db::status(database);
    if (!status)
        return fail(status.error());
    say(text("wrote %s; audit head %s after %s", file.c_str(), status->chain.head.c_str(), entriesText(status->chain.entries).c_str()));
    return kDone;
}

Result<std::vector<db::NotedHead>> notedHeads(const std::vector<std::string>& heads)
{
    constexpr std::size_t kLeast = 12, kAll = 64;
    std::vector<db::NotedHead> noted;
    for (const auto& head : heads) {
        if (head.size() < kLeast || head.size() > kAll || head.find_first_not_of("0123456789abcdef") != std::string::npos)
            return Error{ErrorCode::InvalidInput, {MARKED("app", "--head: '%1' is no head; expected 12 to 64 hexadecimal digits"), head}};
        noted.push_back({head, MARKED("app", "the command line")});
    }
    return noted;
}

int verifyCommand(db::Database& database, bool json, const std::vector<std::string>& heads)
{
    const auto noted = notedHeads(heads);
    if (!noted)
        return fail(noted.error());
    const auto report = db::verify(database, consoleProgress("verifying"), *noted);
    if (!report)
        return fail(report.error());
    if (json)
        put("%s\n",
            nlohmann::ordered_json{{"swings", report->swings}, {"readings", report->readings}, {"findings", inEnglish(report->findings)},
                {"notes", inEnglish(report->notes)}, {"audit_head", report->head}, {"audit_entries", report->entries}}
                .dump(2)
                .c_str());
    else
        for (const auto& finding : inEnglish(report->findings))
            put("%s\n", finding.c_str());
    if (!json)
        for (const auto& note : inEnglish(report->notes))
            put("note: %s\n", note.c_str());
    if (!report->findings.empty())
        return fail({ErrorCode::Corrupt,
            {MARKED_N("app", "%n finding(s) in the swings (%1); expected none"), report->findings.size(), report->swings},
            database.path().toStdString()});
    if (!json)
        put("all is well: %s with %s; audit head %s after %s\n", counted(report->swings, "swing").c_str(),
            counted(report->readings, "reading").c_str(), report->head.c_str(), entriesText(report->entries).c_str());
    return kDone;
}

} // namespace

void addDb(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<DbArguments>();
    auto* command = app.add_subcommand("db", "status, backup and verification of the database");
    command->require_subcommand(1);
    addDatabaseOption(*command, invocation);

    auto* status = command->add_subcommand("status", "what the database holds");
    status->add_flag("--json", options->json, "one JSON object on standard output");
    addDatabaseOption(*status, invocation);
    status->callback([options, &invocation] {
        invocation.action = [options, &invocation] {
            return onDatabase(invocation.database, [&](db::Database& database) { return statusCommand(database, options->json); });
        };
    });

    auto* backup = command->add_subcommand("backup", "write a whole copy, also while the window is open");
    backup->add_option("FILE", options->file, "the copy; it must not exist yet")->required()->check([](const std::string& path) {
        return isStandardStream(path) ? std::string("FILE: a database is no stream; expected the name of a file, not -") : std::string();
    });
    addDatabaseOption(*backup, invocation);
    backup->callback([options, &invocation] {
        invocation.action = [options, &invocation] {
            return onDatabase(invocation.database, [&](db::Database& database) { return backupCommand(database, options->file); });
        };
    });

    auto* verify = command->add_subcommand(
        "verify", "integrity, references, audit trail, signatures, and every kept result recomputed from its readings");
    verify->add_flag("--json", options->json, "one JSON object on standard output");
    verify->add_option("--head", options->heads, "a head of the audit trail noted earlier (report, backup): the trail must hold it");
    addDatabaseOption(*verify, invocation);
    verify->callback([options, &invocation] {
        invocation.action = [options, &invocation] {
            return onDatabase(
                invocation.database, [&](db::Database& database) { return verifyCommand(database, options->json, options->heads); });
        };
    });
}

} // namespace lubberline::app
