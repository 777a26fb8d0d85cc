#include <cmath>
#include <memory>
#include <span>

#include "app/Console.h"
#include "app/Outputs.h"
#include "app/QtSession.h"
#include "app/commands/Command.h"
#include "core/angle/PrintedHeading.h"
#include "core/base/OutputFile.h"
#include "core/base/WholeFile.h"
#include "core/format/reference/ReferenceJson.h"
#include "core/format/reference/ScenarioJson.h"
#include "core/reference/LevellingLoop.h"
#include "ui/plots/base/PlotFile.h"
#include "ui/plots/reference/TimePicture.h"

namespace lubberline::app {

namespace {

struct ReferenceArguments {
    std::string scenario;
    Output output;
    std::size_t every = 1;
    bool json = false;
};

double worst(std::span<const double> errors_rad)
{
    double most = 0;
    for (const double error : errors_rad)
        most = std::max(most, std::abs(error));
    return toDegrees(most);
}

/// [deg], of which what rounds to zero has no sign.
double shown_deg(double error_rad)
{
    const double error_deg = toDegrees(error_rad);
    return std::abs(error_deg) < 0.0005 ? 0.0 : error_deg;
}

void printTable(const Scenario& scenario, const ReferenceRun& run)
{
    put("error of the heading shown = read - magnetic (deg); a share is the run with all less the run without it\n");
    put("%10s %9s %9s %9s", "time (s)", "heading", "vertical", "error");
    for (const ErrorShare& share : run.shares)
        put(" %9s", nameOf(share.source));
    put("\n");
    for (const std::size_t i : pointsOf(run, std::max<std::size_t>(1, run.time_s.size() / 24))) {
        put("%10.1f %9.2f %9.3f %+9.3f", run.time_s[i], printedHeading_deg(toDegrees(run.heading_rad[i]), 2),
            toDegrees(std::hypot(run.tilt[i].forward_rad, run.tilt[i].starboard_rad)), shown_deg(run.headingError_rad[i]));
        for (const ErrorShare& share : run.shares)
            put(" %+9.3f", shown_deg(share.error_rad[i]));
        put("\n");
    }
    put("%10s %9s %9s %9.3f", "largest", "", "", worst(run.headingError_rad));
    for (const ErrorShare& share : run.shares)
        put(" %9.3f", worst(share.error_rad));
    put("\n");
    if (scenario.vertical) {
        const LoopCharacter loop = characterOf(*scenario.vertical);
        put("levelling loop: natural period %.1f s, damping %.3f, largest gain %.3f%s; standoff %.4f deg to rates and drift (Coriolis, in the curve, not in it)\n",
            2 * kPi / loop.natural_rad_s, loop.damping, loop.largestGain, loop.stable ? "" : ", unstable", toDegrees(*run.standoff_rad));
    }
    if (run.slavingStandoff_rad)
        put("slaving: standoff %+.4f deg\n", toDegrees(*run.slavingStandoff_rad));
}

/// Error and shares against time above, the loops' gains beneath.
Result<void> writePicture(const Output& output, const Scenario& scenario, const ReferenceRun& run)
{
    const auto session = makeDrawingSession();
    const auto time = ui::timeDrawing(std::make_shared<const ui::TimePicture>(ui::pictureOf(run)));
    const bool loops = scenario.vertical || (scenario.gyro && scenario.gyro->slavingTau_s);
    const auto paint = [&](QPainter& painter, const QRectF& target) {
        const double height = loops ? 0.6 * target.height() : target.height();
        ui::renderDrawn(painter, QRectF(target.left(), target.top(), target.width(), height), time);
        if (loops)
            ui::renderDrawn(
                painter, QRectF(target.left(), target.top() + height, target.width(), target.height() - height), ui::gainDrawing(scenario));
    };
    return ui::writePlotFile(QString::fromStdString(output.path), {900, loops ? 900 : 540}, QStringLiteral("Heading references in flight"),
        paint, QString::fromStdString(output.kind.substr(1)));
}

Result<void> writeRun(const ReferenceArguments& options, const Scenario& scenario, const ReferenceRun& run)
{
    if (options.output.kind != ".csv" && options.output.kind != ".json")
        return writePicture(options.output, scenario, run);
    return writeWholeFile(
        options.output.path, options.output.kind == ".csv" ? toCsv(run, options.every) : toJson(scenario, run, options.every) + "\n");
}

int referenceCommand(const ReferenceArguments& options)
{
    const auto scenario = readScenarioFile(options.scenario);
    if (!scenario)
        return fail(scenario.error());
    const auto run = runScenario(*scenario, consoleProgress("flying " + nameOfInput(options.scenario)));
    if (!run)
        return fail({run.error().code, run.error().message, nameOfInput(options.scenario)});
    if (!options.json)
        warn(run->warnings);
    if (!options.output.empty()) {
        if (const auto written = writeRun(options, *scenario, *run); !written)
            return fail(written.error());
        sayWritten(options.output);
    }
    if (options.json)
        put("%s\n", toJson(*scenario, *run, options.every).c_str());
    else if (options.output.empty())
        printTable(*scenario, *run);
    return kDone;
}

} // namespace

void addReference(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<ReferenceArguments>();
    auto* command = app.add_subcommand("reference", "what turns, accelerations and gusts do to a vertical and a heading reference");
    addInputOption(*command, invocation, "SCENARIO.json", options->scenario,
        "a Scenario JSON, or a Scenario CSV: a table of manoeuvres with # key: value lines above it")
        ->required();
    command->add_option("--every", options->every, "write only each of so many steps, and the last")
        ->check(CLI::Range(std::size_t{1}, std::size_t{10'000'000}));
    auto* json = command->add_flag("--json", options->json, "one JSON object on standard output");
    addOutputOption(*command, invocation, "-o,--output", options->output, "the file to write", {".csv", ".json", ".png", ".svg", ".pdf"})
        ->excludes(json);
    command->callback([options, &invocation] { invocation.action = [options] { return referenceCommand(*options); }; });
}

} // namespace lubberline::app
