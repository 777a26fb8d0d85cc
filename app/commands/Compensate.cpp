#include "app/Console.h"
#include "app/LogOptions.h"
#include "app/Outputs.h"
#include "app/Paths.h"
#include "app/QtSession.h"
#include "core/base/OutputFile.h"
#include "core/base/WholeFile.h"
#include "core/format/exchange/ModelJson.h"
#include "core/format/results/CompensationJson.h"
#include "ui/report/forms/CalibrationSheets.h"
#include "ui/report/forms/InflightSheets.h"

namespace lubberline::app {

namespace {

struct CompensateArguments {
    LogArguments log;
    std::string model;
    CompensationOptions options;
    Output output;
    bool json = false;
};

void printErrors(const char* when, const HeadingErrors& errors)
{
    put("%-8s%+10.2f%10.2f%10.2f%10.2f\n", when, errors.mean_deg, errors.rms_deg, errors.p95_deg, errors.max_deg);
}

void printTable(const CompensatedLog& compensated, const SensorLog& log)
{
    if (compensated.before && compensated.after) {
        put("heading error, read - magnetic (deg)\n%-8s%10s%10s%10s%10s\n", "", "mean", "rms", "95 %", "max");
        printErrors("before", *compensated.before);
        printErrors("after", *compensated.after);
    } else {
        put("no reference heading: heading errors are not known\n");
    }
    const std::string unit(log.figureUnit());
    put("the field's size spreads by %.1f %s before and %.1f %s after\n\nhelmet systems ask\n", compensated.spreadBefore, unit.c_str(),
        compensated.spreadAfter, unit.c_str());
    for (const auto& demand : compensated.demands)
        put("%-40s %s %-6g %-4s %s\n", demand.name.english().c_str(), demand.atLeast ? ">=" : "<=", demand.limit, demand.unit.c_str(),
            !demand.value ? "not known" : text("%.3g: %s", *demand.value, *demand.met() ? "met" : "not met").c_str());
}

/// The report of the log: deviation before and after.
int writeReport(const CompensatedLog& compensated, const SensorLog& log, const CompensateArguments& options)
{
    const auto session = makeDrawingSession();
    ui::ReferenceSheet sheet = ui::compensationSheet(compensated, log, ui::sourceName(options.log.file));
    sheet.madeAtUtc = nowUtc();
    if (const auto written = ui::writeReferenceSheet(sheet, QString::fromStdString(options.output.path)); !written)
        return fail(written.error());
    sayWritten(options.output);
    return kDone;
}

int compensateCommand(CompensateArguments options)
{
    const auto setup = readModelJsonFile(options.model);
    if (!setup)
        return fail(setup.error());
    const auto field = fieldOf(*setup);
    if (field)
        options.options.field = *field;
    options.options.uncertainty = setup->uncertainty;
    const auto log = readLog(options.log);
    if (!log)
        return fail(log.error());
    const auto compensated = compensate(*log, setup->model, options.options);
    if (!compensated)
        return fail({compensated.error().code, compensated.error().message, nameOfInput(options.log.file)});
    if (!options.json || !options.output.empty()) {
        warn(log->warnings);
        warn(compensated->warnings);
    }
    if (options.output.kind == ".pdf") {
        if (const int written = writeReport(*compensated, *log, options); written != kDone)
            return written;
    } else if (!options.output.empty()) {
        if (const auto written
            = writeWholeFile(options.output.path, writeCompensatedCsv(*log, *compensated), {options.log.file, options.model});
            !written)
            return fail(written.error());
        sayWritten(options.output);
        if (options.output.toStandardOutput())
            return kDone;
    }
    if (options.json)
        put("%s\n", toJson(*compensated, *log).c_str());
    else
        printTable(*compensated, *log);
    return kDone;
}

} // namespace

void addCompensate(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<CompensateArguments>();
    auto* command = app.add_subcommand(
        "compensate", "a log with its sensor model taken out: headings before and after, and what a helmet system asks");
    addLogOptions(*command, invocation, options->log);
    addInputOption(*command, invocation, "--model", options->model, "a Model JSON, as calibrate writes it")->required();
    command
        ->add_option("--latency-ms", options->options.latency_ms, "of the sensor, as its maker states it; not stated: latency is not known")
        ->check(CLI::Range(0.0, 10000.0));
    command->add_option("--filter-ms", options->options.filter_ms, "delay of a filter behind it")->check(CLI::Range(0.0, 10000.0));
    command->add_flag("--json", options->json, "one JSON object on standard output");
    addOutputOption(*command, invocation, "-o,--output", options->output, "write the compensated log, or the report", {".csv", ".pdf"});
    command->callback([options, &invocation] { invocation.action = [options] { return compensateCommand(*options); }; });
}

} // namespace lubberline::app
