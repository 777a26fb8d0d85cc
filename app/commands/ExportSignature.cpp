#include "app/commands/ExportSignature.h"

#include <filesystem>
#include <optional>

#include "app/Console.h"
#include "core/base/OutputFile.h"
#include "core/base/WholeFile.h"
#include "core/record/RecordWords.h"

namespace lubberline::app {

namespace {

struct SignatureFile {
    std::string path;
    Signature signature;
};

/// Those that are asked for, with the files that they go to.
std::vector<SignatureFile> filesOf(const std::vector<Signature>& all, std::optional<SignatureRole> role, const std::string& path)
{
    std::vector<SignatureFile> files;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (!role || all[i].role == *role) {
            const std::filesystem::path named(path);
            const std::string stem = named.stem().string() + "-" + std::to_string(i + 1) + "-" + std::string(fileWord(all[i].role));
            files.push_back({(named.parent_path() / (stem + named.extension().string())).string(), all[i]});
        }
    if (role && !files.empty())
        files.erase(files.begin(), files.end() - 1);
    if (files.size() == 1 || isStandardStream(path))
        for (auto& file : files)
            file.path = path;
    return files;
}

Result<void> writeSignature(const SignatureFile& file, const std::string& content)
{
    auto done = writeWholeFile(file.path, content);
    if (isStandardStream(file.path))
        return done;
    if (done && !file.signature.openPgp.empty())
        done = writeWholeFile(file.path + ".asc", file.signature.openPgp);
    if (done && !file.signature.publicKey.empty())
        done = writeWholeFile(file.path + ".key.asc", file.signature.publicKey);
    if (done)
        say("wrote " + file.path
            + (file.signature.openPgp.empty() ? ": a name only, no key has signed it" : ", " + file.path + ".asc and its key"));
    return done;
}

} // namespace

int exportSignatures(db::Stores& stores, const std::string& record, const std::string& roleWord, const std::string& path)
{
    const auto role = choiceOf<SignatureRole>(roleWord);
    if (!role && !roleWord.empty())
        return fail(Error{
            ErrorCode::InvalidInput, {MARKED("app", "--role: '%1' is not known; expected %2"), roleWord, allowedWords<SignatureRole>()}});
    const auto id = stores.swings.named(record);
    if (!id)
        return fail(id.error());
    const auto swing = stores.swings.swing(*id);
    if (!swing)
        return fail(swing.error());
    const auto files = filesOf(swing->signatures, role, path);
    if (files.empty())
        return fail(
            Error{ErrorCode::NotFound, {MARKED("app", "the swing %1 has no such signature; expected a signed one"), swing->record}});
    for (const SignatureFile& file : files) {
        const auto content = stores.signing.contentOf(*id, file.signature);
        if (!content)
            return fail(content.error());
        if (const auto written = writeSignature(file, *content); !written)
            return fail(written.error());
    }
    return kDone;
}

} // namespace lubberline::app
