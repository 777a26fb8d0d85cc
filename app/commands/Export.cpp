#include "app/Console.h"
#include "app/Outputs.h"
#include "app/commands/Command.h"
#include "app/commands/ExportSignature.h"
#include "core/base/OutputFile.h"
#include "core/format/exchange/Exchange.h"
#include "db/transfer/Transfer.h"

namespace lubberline::app {

namespace {

struct ExportArguments {
    std::vector<std::string> aircraft;
    std::string signature, role;
    Output output;
};

int exportCommand(db::Stores& stores, const ExportArguments& options)
{
    if (!options.signature.empty())
        return exportSignatures(stores, options.signature, options.role, options.output.path);
    if (!options.output.toStandardOutput() && options.output.kind != ".json") {
        say("export: a .txt is what a signature stands for; expected --signature RECORD with it");
        return kUsage;
    }
    std::vector<AircraftId> aircraft;
    for (const auto& registration : options.aircraft) {
        const auto id = stores.fleet.aircraftNamed(registration);
        if (!id)
            return fail(id.error());
        aircraft.push_back(*id);
    }
    const auto fleet = db::exportFleet(stores.database(), aircraft, consoleProgress("exporting"));
    if (!fleet)
        return fail(fleet.error());
    if (const auto written = writeWholeFile(options.output.path, writeExchange(*fleet)); !written)
        return fail(written.error());
    say(text("wrote %s of %zu aircraft to %s", counted(std::ssize(fleet->swings), "swing").c_str(), fleet->aircraft.size(),
        options.output.toStandardOutput() ? "standard output" : options.output.path.c_str()));
    return kDone;
}

} // namespace

void addExport(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<ExportArguments>();
    auto* command = app.add_subcommand("export", "write aircraft with all their swings as exchange JSON (.lubberline.json)");
    command->add_option("--aircraft", options->aircraft, "registrations (default: the whole fleet)");
    command->add_option("--signature", options->signature,
        "instead: what the signatures of this swing stand for, as text, with FILE.asc by each key, for `gpg --verify` and `lubberline verify`");
    command->add_option("--role", options->role, "of these only the last by a performer, an inspector or an authority");
    addOutputOption(*command, invocation, "-o,--output", options->output, "the file to write", {".json", ".txt"})->required();
    actOnStores(*command, invocation, db::OpenMode::ReadOnly, [options](db::Stores& stores) { return exportCommand(stores, *options); });
}

} // namespace lubberline::app
