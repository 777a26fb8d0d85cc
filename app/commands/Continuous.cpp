#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/Console.h"
#include "app/Outputs.h"
#include "app/Paths.h"
#include "app/QtSession.h"
#include "app/commands/Command.h"
#include "core/base/OutputFile.h"
#include "core/base/WholeFile.h"
#include "core/format/csv/InflightCsv.h"
#include "core/format/csv/SwingCsv.h"
#include "core/format/results/InflightJson.h"
#include "core/inflight/InflightSwing.h"
#include "ui/plots/base/PlotFile.h"
#include "ui/plots/inflight/InflightDrawing.h"
#include "ui/report/forms/InflightSheets.h"

namespace lubberline::app {

namespace {

struct ContinuousArguments {
    std::string file, state;
    Output output, swing;
    ContinuousOptions filter;
    bool json = false, whole = false;
};

void printContinuous(const ContinuousResult& result)
{
    put("%s", counted(result.updates, "update").c_str());
    if (result.nisMean)
        put(", innovations %.2f of what the errors allow", *result.nisMean);
    if (result.noise_deg)
        put(", a pair of headings scatters by %.2f deg", *result.noise_deg);
    put("\n");
    for (std::size_t i = 0; i < result.names.size(); ++i)
        if (result.state_deg[i])
            put("%-16s %+8.3f +- %.3f\n", result.names[i].c_str(), *result.state_deg[i], *result.standardError_deg[i]);
        else
            put("%-16s %8s\n", result.names[i].c_str(), "-");
    if (const auto& whole = result.whole) {
        if (const auto& model = whole->model)
            put("hard iron P %+.0f, Q %+.0f, R %+.0f nT\n", model->hardIron_nT.x(), model->hardIron_nT.y(), model->hardIron_nT.z());
        put("level where H is %.0f nT:", whole->field.horizontal_nT);
        for (std::size_t c = 0; c < whole->level_deg.size(); ++c)
            if (whole->level_deg[c])
                put("  %c %+.2f +- %.2f", "ABCDE"[c], *whole -> level_deg[c], *whole -> levelError_deg[c]);
            else
                put("  %c -", "ABCDE"[c]);
        put(" deg\n");
    }
    for (const auto& direction : result.nullDirections)
        put("%s\n", direction.english().c_str());
    for (const auto& alarm : result.alarms) {
        put("alarm at %.0f s: %s by %+.2f +- %.2f deg since %.0f s (between %.0f and %.0f s)", alarm.time_s, alarm.coefficient.c_str(),
            alarm.change_deg, alarm.standardError_deg, alarm.since_s, alarm.from_s, alarm.to_s);
        for (const auto& other : alarm.orElse)
            put("%s%s", &other == &alarm.orElse.front() ? ", if it is not " : ", ", other.c_str());
        put("\n");
    }
}

/// The state of the last flight; none where there is no such file yet.
Result<std::optional<ContinuousState>> lastState(const std::string& path)
{
    if (path.empty() || !std::filesystem::exists(path))
        return std::optional<ContinuousState>();
    const auto content = readWholeFile(path, MARKED("app", "the state of a continuous swing"));
    if (!content)
        return content.error();
    auto state = readStateJson(*content, path);
    if (!state)
        return state.error();
    return std::optional(std::move(state.value()));
}

Result<void> writeHistory(const ContinuousArguments& options, const ContinuousResult& result, const std::vector<Message>& warnings)
{
    if (options.output.kind == ".csv")
        return writeWholeFile(options.output.path, historyCsv(result));
    const auto session = makeDrawingSession();
    const QString path = QString::fromStdString(options.output.path);
    if (options.output.kind == ".pdf") {
        ui::ReferenceSheet sheet = ui::continuousSheet(result, ui::sourceName(options.file), ui::printableAll(warnings));
        sheet.madeAtUtc = nowUtc();
        return ui::writeReferenceSheet(sheet, path);
    }
    return ui::writePlotFile(
        path, {1000, 600}, QStringLiteral("Continuous swing"),
        [picture = ui::convergence(result)](QPainter& painter, const QRectF& target) { ui::renderDrawn(painter, target, picture); },
        QString::fromStdString(options.output.kind.substr(1)));
}

Result<void> writeContinuous(const ContinuousArguments& options, const ContinuousResult& result, const std::vector<Message>& warnings)
{
    if (!options.output.empty()) {
        if (auto written = writeHistory(options, result, warnings); !written)
            return written;
        sayWritten(options.output);
    }
    if (!options.swing.empty()) {
        SwingRecord record;
        record.swing = swingOf(result.legs);
        if (auto written = writeWholeFile(options.swing.path, writeSwingCsv(record)); !written)
            return written;
        sayWritten(options.swing);
    }
    if (!options.state.empty() && result.told)
        return writeWholeFile(options.state, stateJson(result.state), {options.file});
    return {};
}

int continuousCommand(const ContinuousArguments& arguments)
{
    ContinuousArguments options = arguments;
    auto start = lastState(options.state);
    if (!start)
        return fail(start.error());
    options.filter.start = std::move(start.value());
    if (options.whole)
        options.filter.wholeModelOver_nT = 0; // that of the log
    const auto file = readContinuousCsvFile(options.file, options.filter, consoleProgress("reading " + nameOfInput(options.file)));
    if (!file)
        return fail(file.error());
    std::vector<Message> warnings = file->warnings;
    if (!options.state.empty() && !file->result.told)
        warnings.push_back(MARKED("app", "the state is not told yet, and not kept"));
    if (const auto written = writeContinuous(options, file->result, warnings); !written)
        return fail(written.error());
    if (!options.json)
        warn(warnings);
    if (options.json) {
        ContinuousResult told = file->result;
        told.warnings = warnings;
        put("%s\n", toJson(told).c_str());
    } else if (!options.output.toStandardOutput() && !options.swing.toStandardOutput()) {
        printContinuous(file->result);
    }
    return kDone;
}

} // namespace

void addContinuous(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<ContinuousArguments>();
    auto* command
        = app.add_subcommand("continuous", "the continuous swing: A to E followed through flights, with an alarm when the iron changed");
    addInputOption(*command, invocation, "LOG.csv", options->file,
        "time_s, compass_heading_deg, reference_heading_deg (magnetic) or deviation_deg; reference_error_deg, leg, current_A:NAME")
        ->required();
    command
        ->add_option(
            "--noise", options->filter.noise_deg, "of a pair of headings where the log states none [deg]; without it, as they scatter")
        ->check(CLI::Range(0.001, 90.0));
    command->add_option("--drift", options->filter.drift_deg, "random walk of each coefficient over the square root of a day [deg]")
        ->check(CLI::Range(0.0, 90.0))
        ->capture_default_str();
    command->add_flag("--whole-model", options->whole,
        "follow the whole sensor model (soft and hard iron) in place of A to E: the log has pitch_deg, roll_deg, horizontal_nT and dip_deg");
    command->add_option("--state", options->state, "goes on from this file of the last flight, and keeps the state in it")
        ->type_name("FILE");
    auto* json = command->add_flag("--json", options->json, "one JSON object on standard output");
    addOutputOption(*command, invocation, "-o,--output", options->output, "the history of the coefficients, its plot, or the report",
        {".csv", ".png", ".svg", ".pdf"})
        ->excludes(json);
    addOutputOption(*command, invocation, "--swing", options->swing, "the means of the legs as a swing in flight (Swing CSV)", {".csv"})
        ->excludes(json);
    command->callback([options, &invocation] { invocation.action = [options] { return continuousCommand(*options); }; });
}

} // namespace lubberline::app
