#include "app/Console.h"
#include "app/SwingSource.h"
#include "app/Tables.h"
#include "app/commands/Command.h"
#include "core/format/results/AnalysisJson.h"
#include "core/swing/Observations.h"

namespace lubberline::app {

namespace {

struct CorrectArguments {
    std::string file;
    bool json = false;
};

int correctCommand(const CorrectArguments& options)
{
    const auto swing = swingFromCsv(options.file);
    if (!swing)
        return fail(swing.error());
    const auto correction = correctionSteps(observationsOf(swing->record.swing));
    if (!correction) {
        Error error = correction.error();
        error.file = swing->source;
        return fail(error);
    }
    warn(swing->warnings);
    if (options.json)
        put("%s\n", toJson(*correction).c_str());
    else
        putText(tableOf(*correction));
    return kDone;
}

} // namespace

void addCorrect(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<CorrectArguments>();
    auto* command = app.add_subcommand("correct", "what to make the compass read on the cardinals (correction swing)");
    addInputOption(*command, invocation, "SWING.csv", options->file, "a Swing CSV with N, E, S and W among its readings")->required();
    command->add_flag("--json", options->json, "one JSON object on standard output");
    command->callback([options, &invocation] { invocation.action = [options] { return correctCommand(*options); }; });
}

} // namespace lubberline::app
