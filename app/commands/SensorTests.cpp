// spectrum and interference: what a log of a sensor tells beside its calibration.
#include "app/Console.h"
#include "app/LogOptions.h"
#include "app/Outputs.h"
#include "app/QtSession.h"
#include "app/SheetOutput.h"
#include "core/base/Number.h"
#include "core/base/OutputFile.h"
#include "core/base/TerminalText.h"
#include "core/base/WholeFile.h"
#include "core/format/csv/ActionsCsv.h"
#include "core/format/results/SensorTestsJson.h"
#include "ui/plots/base/PlotFile.h"
#include "ui/plots/calibration/SensorTestDrawing.h"
#include "ui/report/forms/InflightSheets.h"
#include "ui/report/forms/SensorTestSheets.h"

namespace lubberline::app {

namespace {

struct SensorTestArguments {
    LogArguments log;
    SpectrumOptions spectrum;
    std::string actions;
    std::vector<double> limits_nT{kInterferenceLimits_nT.x(), kInterferenceLimits_nT.y(), kInterferenceLimits_nT.z()};
    Output output;
    bool json = false;
};

int failIn(const Error& error, const SensorTestArguments& options)
{
    return fail({error.code, error.message, nameOfInput(options.log.file)});
}

std::string foldedFrom(const SpectralLine& line)
{
    std::string all;
    for (const auto& one : line.sources)
        if (one.aliasOf_hz)
            all += (all.empty() ? "" : " or ") + text("%g", std::round(*one.aliasOf_hz * 10) / 10);
    return all;
}

void printSpectrum(const LogSpectrum& spectrum, const SensorLog& log)
{
    const std::string unit(log.figureUnit());
    put("%s: %.3f samples a second, %s of %zu\n", spectrum.column.c_str(), spectrum.rate_hz,
        counted(static_cast<std::int64_t>(spectrum.segments), "segment").c_str(), spectrum.segment);
    if (spectrum.lines.empty())
        put("no lines\n");
    for (const auto& line : spectrum.lines)
        put("%10.3f Hz  %10.2f %s  %s%s\n", line.frequency_hz, line.amplitude, unit.c_str(), line.source.english().c_str(),
            line.aliasOf_hz ? text(", folded down from %s Hz", foldedFrom(line).c_str()).c_str() : "");
    if (const auto& filter = spectrum.filter) {
        std::string notches;
        for (const double notch : filter->notches_hz)
            notches += text(" %.2f", notch);
        put("filter of %.2f ms: notches%s Hz, low-pass %s; leaves %.2f of %.2f %s rms above %.1f Hz\n", filter->delay_ms,
            notches.empty() ? " -" : notches.c_str(), filter->lowPass_hz ? text("%.1f Hz", *filter->lowPass_hz).c_str() : "-",
            filter->left_rms, filter->before_rms, unit.c_str(), filter->from_hz);
    }
}

bool isSpectrumPlot(const Output& output) { return output.kind == ".png" || output.kind == ".svg"; }

/// The spectrum, and beneath it how its lines come and go.
Result<void> writeSpectrumPlot(const LogSpectrum& spectrum, const SensorLog& log, const Output& output)
{
    const auto session = makeDrawingSession();
    const QString unit = QString::fromStdString(std::string(log.figureUnit()));
    const auto spectrogram = spectrogramOf(log, spectrum.column, spectrum.segment);
    const bool both = spectrogram && spectrogram->density.size() > 1;
    const auto paint = [&](QPainter& painter, const QRectF& target) {
        const double height = both ? 0.55 * target.height() : target.height();
        ui::renderDrawn(painter, QRectF(target.topLeft(), QSizeF(target.width(), height)), ui::spectrumDrawing(spectrum, unit));
        if (both)
            ui::renderDrawn(painter, QRectF(target.left(), target.top() + height, target.width(), target.height() - height),
                ui::spectrogramDrawing(*spectrogram, unit));
    };
    return ui::writePlotFile(QString::fromStdString(output.path), {1000, both ? 900 : 560}, QStringLiteral("Spectrum"), paint,
        QString::fromStdString(output.kind.substr(1)));
}

int spectrumCommand(const SensorTestArguments& options)
{
    const auto log = readLog(options.log);
    if (!log)
        return fail(log.error());
    const auto spectrum = spectrumOf(*log, options.spectrum);
    if (!spectrum)
        return failIn(spectrum.error(), options);
    if (!options.json || !options.output.empty()) {
        warn(log->warnings);
        warn(spectrum->warnings);
    }
    if (options.output.kind == ".pdf") {
        const int written = writeSheet(ui::spectrumSheet(*spectrum, *log, ui::sourceName(options.log.file)), options.output);
        if (written != kDone || !options.json)
            return written;
    } else if (isSpectrumPlot(options.output)) {
        if (const auto written = writeSpectrumPlot(*spectrum, *log, options.output); !written)
            return fail(written.error());
        sayWritten(options.output);
        if (!options.json)
            return kDone;
    } else if (!options.output.empty()) {
        std::string rows = log->unit == FieldUnit::Counts ? "frequency_hz,density_per_hz\n" : "frequency_hz,density_nT2_per_hz\n";
        for (std::size_t k = 0; k < spectrum->density.size(); ++k)
            rows += shortestNumber(spectrum->frequency_hz[k]) + "," + shortestNumber(spectrum->density[k]) + "\n";
        if (const auto written = writeWholeFile(options.output.path, rows, {options.log.file}); !written)
            return fail(written.error());
        sayWritten(options.output);
        if (options.output.toStandardOutput())
            return kDone;
    }
    if (options.json)
        put("%s\n", toJson(*spectrum, *log).c_str());
    else
        printSpectrum(*spectrum, *log);
    return kDone;
}

int interferenceCommand(const SensorTestArguments& options)
{
    const auto actions = readActionsFile(options.actions);
    if (!actions)
        return fail(actions.error());
    const auto log = readLog(options.log);
    if (!log)
        return fail(log.error());
    const auto result = interferenceTest(*log, *actions, {options.limits_nT[0], options.limits_nT[1], options.limits_nT[2]});
    if (!result)
        return failIn(result.error(), options);
    if (options.json)
        put("%s\n", toJson(*result, *log).c_str());
    else {
        warn(log->warnings);
        warn(result->warnings);
    }
    if (!options.output.empty())
        return writeSheet(ui::interferenceSheet(*result, *log, ui::sourceName(options.log.file)), options.output);
    if (options.json)
        return kDone;
    put("limits %.0f, %.0f, %.0f nT\n%-32s%10s%27s%29s\n", result->limits_nT.x(), result->limits_nT.y(), result->limits_nT.z(), "action",
        "from (s)", "worst x, y, z (nT)", "at (s)");
    for (const auto& action : result->actions)
        put("%-32s%10.1f%9.0f%9.0f%9.0f%9.1f%9.1f%9.1f  %s\n", inOneLine(action.action).c_str(), action.from_s, action.worst_nT.x(),
            action.worst_nT.y(), action.worst_nT.z(), action.worstAt_s.x(), action.worstAt_s.y(), action.worstAt_s.z(),
            action.passes ? "passes" : "FAILS");
    for (const auto& circuit : result->circuits)
        put("%s: %+.2f, %+.2f, %+.2f nT per ampere\n", inOneLine(circuit.name).c_str(), circuit.field_nT_per_A.x(),
            circuit.field_nT_per_A.y(), circuit.field_nT_per_A.z());
    put("%s\n", result->passes ? "passes" : "does not pass");
    return kDone;
}

/// The part that both share.
CLI::App* addTest(CLI::App& app, Invocation& invocation, const std::shared_ptr<SensorTestArguments>& options, const char* name,
    const char* what, int (*run)(const SensorTestArguments&))
{
    auto* command = app.add_subcommand(name, what);
    addLogOptions(*command, invocation, options->log);
    command->add_flag("--json", options->json, "one JSON object on standard output");
    command->callback([options, run, &invocation] { invocation.action = [options, run] { return run(*options); }; });
    return command;
}

} // namespace

void addSensorTests(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<SensorTestArguments>();
    auto* spectrum = addTest(app, invocation, options, "spectrum",
        "lines in a log's spectrum by name, those folded down by sampling, and filters", spectrumCommand);
    spectrum->add_option("--column", options->spectrum.column, "bx, by, bz or another column; default: the axis with the strongest line");
    spectrum->add_option("--segment", options->spectrum.segment, "samples of a segment; default: an eighth of the log")
        ->check(CLI::Range(8, 1 << 22));
    spectrum->add_option("--tachometer", options->spectrum.tachometer, "a column of rev/min: orders of a rotor");
    spectrum->add_option("--max-delay-ms", options->spectrum.maxDelay_ms, "choose notches and a low-pass within this delay")
        ->check(CLI::Range(0.01, 10000.0));
    addOutputOption(*spectrum, invocation, "-o,--output", options->output, "write frequency and density, the plot, or the report",
        {".csv", ".png", ".svg", ".pdf"});

    options = std::make_shared<SensorTestArguments>();
    auto* interference = addTest(
        app, invocation, options, "interference", "what switching things changes at a sensor that stands still", interferenceCommand);
    addInputOption(*interference, invocation, "--actions", options->actions, "a CSV: time_s, action")->required();
    interference->add_option("--limits-nT", options->limits_nT, "X,Y,Z: the largest change that passes")
        ->delimiter(',')
        ->expected(3)
        ->capture_default_str();
    addOutputOption(*interference, invocation, "-o,--output", options->output, "the report", {".pdf"});
}

} // namespace lubberline::app
