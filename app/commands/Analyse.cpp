#include "app/Console.h"
#include "app/LogOptions.h"
#include "app/SwingSource.h"
#include "app/Tables.h"
#include "app/commands/Command.h"
#include "core/base/WholeFile.h"
#include "core/coil/CoilHistory.h"
#include "core/format/results/AnalysisJson.h"
#include "core/swing/CardRemarks.h"
#include "core/swing/Removal.h"

namespace lubberline::app {

namespace {

struct AnalyseArguments {
    std::string file, bench;
    CoefficientSet removed;
    int orders = -1;
    bool json = false;
};

/// None where none is given.
Result<std::optional<SensorBench>> benchIn(const std::string& file)
{
    if (file.empty())
        return std::optional<SensorBench>();
    LogArguments what;
    what.file = file;
    const auto log = readLog(what);
    if (!log)
        return log.error();
    auto record = coilRecordOf(*log);
    if (!record)
        return Error{record.error().code, record.error().message, nameOfInput(file)};
    const auto bench = sensorBenchOf(*record);
    return bench ? Result<std::optional<SensorBench>>(*bench) : bench.error();
}

int analyseCommand(const AnalyseArguments& options)
{
    auto swing = swingFromCsv(options.file);
    if (!swing)
        return fail(swing.error());
    const auto bench = benchIn(options.bench);
    if (!bench)
        return fail(bench.error());
    auto tilted = wordsOf(attitudeOf(swing->record.swing));
    auto analysis = analyseOnly(*swing, {options.orders}, *bench);
    if (!analysis)
        return fail(analysis.error());
    const auto removal = removeComponents(*analysis, options.removed);
    if (!removal)
        return fail({removal.error().code, removal.error().message, swing->source});
    if (!tilted.empty())
        analysis->warnings.push_back(std::move(tilted));
    const bool removes = options.removed.any();
    warn(swing->warnings);
    if (options.json) {
        analysis->warnings.insert(analysis->warnings.begin(), swing->warnings.begin(), swing->warnings.end());
        writeJson(*analysis, removes ? &*removal : nullptr, putText);
        putText("\n");
        return kDone;
    }
    warn(analysis->warnings);
    putText(tableOf(*analysis));
    if (removes)
        putText(tableOf(*analysis, *removal, options.removed));
    return kDone;
}

} // namespace

void addAnalyse(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<AnalyseArguments>();
    auto* command = app.add_subcommand("analyse", "coefficients, residuals and harmonics of a swing");
    addInputOption(*command, invocation, "SWING.csv", options->file, "a Swing CSV")->required();
    command->add_option("--orders", options->orders, "highest harmonic wanted (default: all that the headings resolve)")
        ->check(CLI::Range(0, 1'000'000));
    addInputOption(*command, invocation, "--bench", options->bench,
        "the sensor's coil bench (as of `coil`): its noise, hysteresis and nonlinearity in the field of the swing are in the errors");
    addRemoveOption(*command, options->removed, "show what would remain without these components, as in B,C");
    command->add_flag("--json", options->json, "one JSON object on standard output");
    command->callback([options, &invocation] { invocation.action = [options] { return analyseCommand(*options); }; });
}

} // namespace lubberline::app
