#include <cstdio>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "app/Console.h"
#include "app/OpenStores.h"
#include "app/Paths.h"
#include "app/QtSession.h"
#include "app/commands/Command.h"
#include "core/base/WholeFile.h"
#include "core/format/exchange/SignedContent.h"
#include "core/record/RecordWords.h"
#include "db/openpgp/KeyCheck.h"

namespace lubberline::app {

namespace {

struct VerifyArguments {
    std::string text, signature, key;
    bool json = false;
};

const char* wordOf(KeyState state)
{
    switch (state) {
    case KeyState::NameOnly: return "name_only";
    case KeyState::Good: return "good";
    case KeyState::NotKnown: return "not_known";
    case KeyState::OtherHolder: return "other_holder";
    case KeyState::Expired: return "expired";
    case KeyState::Revoked: return "revoked";
    case KeyState::Bad: return "bad";
    case KeyState::NotChecked: return "not_checked";
    }
    return "";
}

/// Of the database, where there is one: without any no key is known.
Result<std::vector<StationKey>> stationKeys(const std::string& option)
{
    const auto path = databasePath(option);
    if (!path)
        return path.error();
    if (option.empty() && !std::filesystem::exists(path->toStdString()))
        return std::vector<StationKey>();
    auto stores = openStores(option, db::OpenMode::ReadOnly);
    return stores ? (*stores)->keys.all() : stores.error();
}

int verifyFiles(const VerifyArguments& options, const std::string& database)
{
    const auto session = makeDrawingSession();
    const auto text = readWholeFile(options.text, MARKED("app", "signed content"));
    if (!text)
        return fail(text.error());
    const std::string signature = options.signature.empty() ? options.text + ".asc" : options.signature;
    const auto detached = readWholeFile(signature, MARKED("app", "a detached OpenPGP signature"));
    if (!detached)
        return fail(detached.error());
    const std::string beside = options.text + ".key.asc";
    std::string key;
    if (const std::string file = !options.key.empty() ? options.key
            : std::filesystem::exists(beside)         ? beside
                                                      : std::string();
        !file.empty()) {
        auto read = readWholeFile(file, MARKED("app", "an OpenPGP public key"));
        if (!read)
            return fail(read.error());
        key = std::move(read.value());
    }
    const auto signer = signerIn(*text, nameOfInput(options.text));
    if (!signer)
        return fail(signer.error());
    const auto keys = stationKeys(database);
    if (!keys)
        return fail(keys.error());
    Signature claimed = *signer;
    claimed.openPgp = *detached;
    claimed.publicKey = key;
    const KeyVerdict verdict = claimed.key.empty()
        ? KeyVerdict{KeyState::Bad, MARKED("app", "the text is of a signature by name only, and this key is not its")}
        : db::verdictOn(claimed, *text, *keys, consoleProgress("verifying"));
    if (options.json)
        put("%s\n",
            nlohmann::ordered_json{{"state", wordOf(verdict.state)}, {"words", verdict.words.english()}, {"key", claimed.key},
                {"role", std::string(fileWord(signer->role))}, {"name", signer->name}, {"licence", signer->licence},
                {"time_utc", signer->timeUtc}, {"audit_head", signer->fileHead}}
                .dump(2)
                .c_str());
    else if (isVerified(verdict))
        put("%s: %s %s, %s: %s\n", std::string(fileWord(signer->role)).c_str(), signer->name.c_str(), signer->licence.c_str(),
            signer->timeUtc.c_str(), verdict.words.english().c_str());
    return isVerified(verdict) ? static_cast<int>(kDone) : fail(Error{ErrorCode::Corrupt, verdict.words, nameOfInput(options.text)});
}

} // namespace

void addVerify(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<VerifyArguments>();
    auto* command = app.add_subcommand(
        "verify", "check a signature that `export --signature` has written: the key, and whether the station knows it");
    addInputOption(*command, invocation, "TEXT.txt", options->text, "what was signed")->required();
    addInputOption(*command, invocation, "SIGNATURE.asc", options->signature, "the detached signature (default: TEXT.txt.asc)");
    addInputOption(*command, invocation, "--key", options->key, "the public key (default: TEXT.txt.key.asc, and the keys of the station)");
    command->add_flag("--json", options->json, "one JSON object on standard output");
    addDatabaseOption(*command, invocation);
    command->callback(
        [options, &invocation] { invocation.action = [options, &invocation] { return verifyFiles(*options, invocation.database); }; });
}

} // namespace lubberline::app
