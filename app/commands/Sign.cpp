#include <algorithm>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "app/Console.h"
#include "app/OpenStores.h"
#include "app/QtSession.h"
#include "app/commands/Command.h"
#include "core/base/TerminalText.h"
#include "core/record/RecordWords.h"
#include "db/openpgp/KeyCheck.h"

namespace lubberline::app {

namespace {

struct SignArguments {
    std::string record, role, name, licence, key, reason, howDayIsKnown;
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
    put("%s  %s  %s\n", record->swing.record.c_str(), inOneLine(record->aircraft.registration).c_str(),
        std::string(fileWord(record->swing.state)).c_str());
    return kDone;
}

/// Prepared, and signed by a key of the user's ring. gpg asks for the pass phrase or the card.
Result<Signature> withKey(db::Stores& stores, SwingId swing, Signature signature, const std::string& wanted)
{
    const Progress progress = consoleProgress("signing");
    const auto keys = db::secretKeys(progress);
    if (!keys)
        return keys.error();
    const auto isWanted
        = [&](const db::OpenPgpKey& one) { return one.fingerprint.ends_with(wanted) || one.userId.find(wanted) != std::string::npos; };
    const auto found = std::count_if(keys->begin(), keys->end(), isWanted);
    if (found != 1)
        return Error{ErrorCode::NotFound,
            {found == 0 ? MARKED("app", "--key: the key ring has no secret key %1; expected one of `gpg --list-secret-keys`")
                        : MARKED("app", "--key: several secret keys are called %1; expected its fingerprint"),
                wanted}};
    signature.key = std::find_if(keys->begin(), keys->end(), isWanted)->fingerprint;
    const auto prepared = stores.signing.prepare(swing, std::move(signature));
    if (!prepared)
        return prepared.error();
    const auto content = stores.signing.contentOf(swing, *prepared);
    return content ? db::signedBy(*prepared, *content, progress) : content.error();
}

int sign(db::Stores& stores, SwingId swing, const SignArguments& options)
{
    const auto role = choiceOf<SignatureRole>(options.role);
    if (!role)
        return fail(Error{ErrorCode::InvalidInput,
            {MARKED("app", "--role: '%1' is not known; expected %2"), options.role, allowedWords<SignatureRole>()}});
    if (const auto last = stores.signing.clockStandsBefore(); last && !last->empty())
        say("the clock of this machine stands before the last entry of the audit trail (" + *last
            + "): what is signed now would seem older");
    Signature signature{*role, options.name, options.licence, {}, {}};
    if (options.key.empty())
        return told(stores.signing.sign(swing, std::move(signature)), stores, swing);
    const auto byKey = withKey(stores, swing, std::move(signature), options.key);
    return told(byKey ? stores.signing.add(swing, *byKey) : Result<void>(byKey.error()), stores, swing);
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
        put("%s\n", nlohmann::ordered_json{{"record", *record}, {"entries", array}}.dump(2).c_str());
        return kDone;
    }
    for (const auto& row : *rows)
        put("%s  %s  %s\n", row.timeUtc.c_str(), inOneLine(row.what).c_str(), inOneLine(row.detail).c_str());
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
    auto* completing = add(app, invocation, "complete", "close a draft swing: its readings and particulars are whole", options, kWrite,
        [](db::Stores& stores, SwingId swing, const SignArguments& given) {
            return told(stores.signing.complete(swing, given.howDayIsKnown), stores, swing);
        });
    completing->add_option("--day-known", options->howDayIsKnown,
        "of a swing on a day from which clocks count that do not know the day (1980-01-06): how it is known that it was that day");
    auto* reopen = add(app, invocation, "reopen", "make a complete swing a draft again", options, kWrite,
        [](db::Stores& stores, SwingId swing, const SignArguments& given) {
            return told(stores.signing.reopen(swing, given.reason), stores, swing);
        });
    reopen->add_option("--reason", options->reason, "why")->required();
    auto* signing = add(
        app, invocation, "sign", "sign a complete swing; a performer's and an inspector's signature freeze it", options, kWrite, sign);
    signing->add_option("--role", options->role, "performer, inspector or authority")->required();
    signing->add_option("--name", options->name, "who signs")->required();
    signing->add_option("--key", options->key,
        "an OpenPGP key of yours: its fingerprint, the end of that, or the user it names; without one nobody has verified the name");
    signing->add_option("--licence", options->licence, "licence, stamp or service number");
    auto* amending = add(app, invocation, "amend", "begin a new revision of a signed swing", options, kWrite, amend);
    amending->add_option("--reason", options->reason, "why")->required();
    auto* trail = add(app, invocation, "audit", "everything that was done to a swing", options, db::OpenMode::ReadOnly, audit);
    trail->add_flag("--json", options->json, "one JSON object on standard output");
}

} // namespace lubberline::app
