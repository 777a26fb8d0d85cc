#include <cstdio>

#include <nlohmann/json.hpp>

#include "app/Console.h"
#include "app/OpenStores.h"
#include "app/QtSession.h"
#include "app/commands/Command.h"
#include "core/record/RecordWords.h"

namespace lubberline::app {

namespace {

struct SignArguments {
    std::string record, role, name, licence, reason;
    bool json = false;
};

using Act = std::function<int(db::Stores& stores, SwingId swing, const SignArguments& options)>;

int onSwing(const SignArguments& options, const std::string& database, db::OpenMode mode, const Act& act)
{
    const auto session = makeDrawingSession();
    auto stores = openStores(database, mode);
    if (!stores)
        return fail(stores.error());
    const auto swing = (*stores)->swings.named(options.record);
    return swing ? act(**stores, *swing, options) : fail(swing.error());
}

int told(const Result<void>& done, db::Stores& stores, SwingId swing)
{
    if (!done)
        return fail(done.error());
    const auto record = stores.swings.record(swing);
    if (!record)
        return fail(record.error());
    std::printf("%s  %s  %s\n", record->swing.record.c_str(), record->aircraft.registration.c_str(),
        std::string(fileWord(record->swing.state)).c_str());
    return kDone;
}

int sign(db::Stores& stores, SwingId swing, const SignArguments& options)
{
    const auto role = choiceOf<SignatureRole>(options.role);
    if (!role)
        return fail(Error{ErrorCode::InvalidInput,
            {MARKED("app", "--role: '%1' is not known; expected %2"), options.role, allowedWords<SignatureRole>()}});
    return told(stores.signing.sign(swing, Signature{*role, options.name, options.licence, {}, {}}), stores, swing);
}

int amend(db::Stores& stores, SwingId swing, const SignArguments& options)
{
    const auto made = stores.signing.amend(swing, options.reason);
    return made ? told({}, stores, *made) : fail(made.error());
}

int audit(db::Stores& stores, SwingId swing, const SignArguments& options)
{
    const auto record = stores.swings.recordOf(swing);
    if (!record)
        return fail(record.error());
    const auto rows = stores.signing.auditOf(*record);
    if (!rows)
        return fail(rows.error());
    if (options.json) {
        nlohmann::ordered_json array = nlohmann::ordered_json::array();
        for (const auto& row : *rows)
            array.push_back({{"time_utc", row.timeUtc}, {"what", row.what}, {"detail", row.detail}});
        std::printf("%s\n", nlohmann::ordered_json{{"record", *record}, {"entries", array}}.dump(2).c_str());
        return kDone;
    }
    for (const auto& row : *rows)
        std::printf("%s  %s  %s\n", row.timeUtc.c_str(), row.what.c_str(), row.detail.c_str());
    return kDone;
}

CLI::App* add(CLI::App& app, Invocation& invocation, const char* name, const char* help, const std::shared_ptr<SignArguments>& options,
    db::OpenMode mode, Act act)
{
    auto* command = app.add_subcommand(name, help);
    command->add_option("RECORD", options->record, "the swing's record id, or its beginning")->required();
    addDatabaseOption(*command, invocation);
    command->callback([options, mode, act = std::move(act), &invocation] {
        invocation.action = [options, mode, act, &invocation] { return onSwing(*options, invocation.database, mode, act); };
    });
    return command;
}

} // namespace

void addSign(CLI::App& app, Invocation& invocation)
{
    constexpr auto kWrite = db::OpenMode::ReadWriteCreate;
    auto options = std::make_shared<SignArguments>();
    add(app, invocation, "complete", "close a draft swing: its readings and particulars are whole", options, kWrite,
        [](db::Stores& stores, SwingId swing, const SignArguments&) { return told(stores.signing.complete(swing), stores, swing); });
    auto* reopen = add(app, invocation, "reopen", "make a complete swing a draft again", options, kWrite,
        [](db::Stores& stores, SwingId swing, const SignArguments& given) {
            return told(stores.signing.reopen(swing, given.reason), stores, swing);
        });
    reopen->add_option("--reason", options->reason, "why")->required();
    auto* signing = add(
        app, invocation, "sign", "sign a complete swing; a performer's and an inspector's signature freeze it", options, kWrite, sign);
    signing->add_option("--role", options->role, "performer, inspector or authority")->required();
    signing->add_option("--name", options->name, "who signs")->required();
    signing->add_option("--licence", options->licence, "licence, stamp or service number");
    auto* amending = add(app, invocation, "amend", "begin a new revision of a signed swing", options, kWrite, amend);
    amending->add_option("--reason", options->reason, "why")->required();
    auto* trail = add(app, invocation, "audit", "everything that was done to a swing", options, db::OpenMode::ReadOnly, audit);
    trail->add_flag("--json", options->json, "one JSON object on standard output");
}

} // namespace lubberline::app
