#include <cstdio>

#include <nlohmann/json.hpp>

#include "app/Console.h"
#include "app/commands/Command.h"
#include "core/base/WholeFile.h"
#include "db/openpgp/Gpg.h"
#include "db/stores/Stores.h"

namespace lubberline::app {

namespace {

struct KeysArguments {
    std::string file, holder, fingerprint;
    bool json = false;
};

int listKeys(db::Stores& stores, bool json)
{
    const auto keys = stores.keys.all();
    if (!keys)
        return fail(keys.error());
    if (json) {
        auto array = nlohmann::ordered_json::array();
        for (const auto& one : *keys)
            array.push_back({{"fingerprint", one.fingerprint}, {"holder", one.holder}, {"added_utc", one.addedUtc}});
        put("%s\n", nlohmann::ordered_json{{"keys", array}}.dump(2).c_str());
        return kDone;
    }
    for (const auto& one : *keys)
        put("%s  %s  %s\n", one.fingerprint.c_str(), one.addedUtc.c_str(), one.holder.c_str());
    return kDone;
}

int addKey(db::Stores& stores, const KeysArguments& options)
{
    const auto text = readWholeFile(options.file, MARKED("app", "an OpenPGP public key"));
    if (!text)
        return fail(text.error());
    const auto keys = db::keysIn(*text, consoleProgress("reading"));
    if (!keys) {
        Error error = keys.error();
        error.file = nameOfInput(options.file);
        return fail(error);
    }
    if (keys->size() != 1)
        return fail(Error{ErrorCode::InvalidInput, {MARKED("app", "%1 keys are in it; expected one, of one person"), keys->size()},
            nameOfInput(options.file)});
    const auto& key = keys->front();
    if (const auto added = stores.keys.put({key.fingerprint, options.holder, *text, {}}); !added)
        return fail(added.error());
    put("%s  %s%s\n", key.fingerprint.c_str(), options.holder.c_str(), key.revoked ? "  (revoked)" : "");
    return kDone;
}

int removeKey(db::Stores& stores, const std::string& fingerprint)
{
    const auto removed = stores.keys.remove(fingerprint);
    if (!removed)
        return fail(removed.error());
    say("removed " + removed->fingerprint + " of " + removed->holder);
    return kDone;
}

} // namespace

void addKeys(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<KeysArguments>();
    auto* command = app.add_subcommand("keys", "the OpenPGP keys that this station knows: whose signatures count as verified");
    command->require_subcommand(1);
    addDatabaseOption(*command, invocation);
    auto* list = command->add_subcommand("list", "fingerprint, since when it is known, and whose it is");
    list->add_flag("--json", options->json, "one JSON object on standard output");
    actOnStores(*list, invocation, db::OpenMode::ReadOnly, [options](db::Stores& stores) { return listKeys(stores, options->json); });
    auto* add = command->add_subcommand("add", "take a key in, or a newer copy of it (which may say that it was revoked)");
    addInputOption(*add, invocation, "KEY.asc", options->file, "the public key, as `gpg --armor --export` writes it")->required();
    add->add_option("--name", options->holder, "whose it is: the name as he signs")->required();
    actOnStores(*add, invocation, db::OpenMode::ReadWriteCreate, [options](db::Stores& stores) { return addKey(stores, *options); });
    auto* remove = command->add_subcommand("remove", "a key that counts no more");
    remove->add_option("FINGERPRINT", options->fingerprint, "or the end of it, eight digits or more")->required();
    actOnStores(*remove, invocation, db::OpenMode::ReadWriteCreate,
        [options](db::Stores& stores) { return removeKey(stores, options->fingerprint); });
}

} // namespace lubberline::app
