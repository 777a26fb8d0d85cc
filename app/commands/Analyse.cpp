#include <cstdio>

#include "app/Console.h"
#include "app/SwingSource.h"
#include "app/Tables.h"
#include "app/commands/Command.h"
#include "core/format/AnalysisJson.h"

namespace lubberline::app {

namespace {

struct Options {
    std::string file;
    int orders = -1;
    bool json = false;
};

int analyseCommand(const Options& options)
{
    const auto swing = swingFromCsv(options.file);
    if (!swing)
        return fail(swing.error());
    auto analysis = analyseSwing(*swing, {options.orders});
    if (!analysis)
        return fail(analysis.error());
    warn(swing->warnings);
    if (options.json) {
        analysis->warnings.insert(analysis->warnings.begin(), swing->warnings.begin(), swing->warnings.end());
        std::printf("%s\n", toJson(*analysis).c_str());
        return kDone;
    }
    warn(analysis->warnings);
    std::fputs(tableOf(*analysis).c_str(), stdout);
    return kDone;
}

} // namespace

void addAnalyse(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<Options>();
    auto* command = app.add_subcommand("analyse", "coefficients, residuals and harmonics of a swing");
    command->add_option("SWING.csv", options->file, "a Swing CSV")->required();
    command->add_option("--orders", options->orders, "highest harmonic wanted (default: all that the headings resolve)")
        ->check(CLI::Range(0, 1'000'000));
    command->add_flag("--json", options->json, "one JSON object on standard output");
    command->callback([options, &invocation] { invocation.action = [options] { return analyseCommand(*options); }; });
}

} // namespace lubberline::app
