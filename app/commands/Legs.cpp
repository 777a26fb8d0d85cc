#include <memory>

#include "app/Console.h"
#include "app/Outputs.h"
#include "app/Paths.h"
#include "app/QtSession.h"
#include "app/commands/Command.h"
#include "core/angle/AngleText.h"
#include "core/angle/PrintedHeading.h"
#include "core/base/OutputFile.h"
#include "core/base/TerminalText.h"
#include "core/base/WholeFile.h"
#include "core/format/csv/InflightCsv.h"
#include "core/format/csv/SwingCsv.h"
#include "core/format/results/InflightJson.h"
#include "core/inflight/InflightSwing.h"
#include "ui/report/forms/InflightSheets.h"

namespace lubberline::app {

namespace {

struct LegsArguments {
    std::string file;
    Output output;
    LegsOptions legs;
    bool json = false;
};

void printLegs(const LegsSolution& solution)
{
    put("wind from %03.0f at %.1f kt (+- %.1f), airspeed %.1f kt (+- %.1f)\n", printedHeading_deg(solution.air.from_deg(), 0),
        solution.air.speed_kt(), solution.air.standardError_kt(), solution.air.airspeed_kt, solution.air.airspeedError_kt);
    put("%-10s %8s %8s %9s %6s %10s %10s\n", "leg", "track", "gs kt", "true hdg", "+-", "compass", "deviation");
    for (const auto& one : solution.legs)
        put("%-10s %8.1f %8.1f %9.1f %6.2f %10s %10s\n", inOneLine(one.leg.name).c_str(), printedHeading_deg(one.leg.track_deg, 1),
            one.leg.groundSpeed_kt, one.trueHeading_deg, one.standardError_deg,
            one.leg.compassHeading_deg ? text("%.1f", printedHeading_deg(*one.leg.compassHeading_deg, 1)).c_str() : "-",
            one.deviation_deg ? text("%+.2f", *one.deviation_deg).c_str() : "-");
}

int legsCommand(const LegsArguments& options)
{
    const auto file = readLegsCsvFile(options.file, consoleProgress("reading " + nameOfInput(options.file)));
    if (!file)
        return fail(file.error());
    auto solution = solveLegs(file->legs, options.legs);
    if (!solution)
        return fail(Error{solution.error().code, solution.error().message, nameOfInput(options.file)});
    solution->warnings.insert(solution->warnings.begin(), file->warnings.begin(), file->warnings.end());
    if (!options.json || !options.output.empty())
        warn(solution->warnings);
    if (options.output.kind == ".pdf") {
        const auto session = makeDrawingSession();
        ui::ReferenceSheet sheet = ui::legsSheet(*solution, ui::sourceName(options.file), ui::printableAll(solution->warnings));
        sheet.madeAtUtc = nowUtc();
        if (const auto written = ui::writeReferenceSheet(sheet, QString::fromStdString(options.output.path)); !written)
            return fail(written.error());
        sayWritten(options.output);
    } else if (!options.output.empty()) {
        SwingRecord record;
        record.swing = swingOf(*solution);
        if (record.swing.readings.empty())
            return fail(Error{ErrorCode::InvalidInput,
                MARKED("app",
                    "no leg has both a compass heading and a variation; expected compass_heading_deg and variation_deg (or --variation)"),
                nameOfInput(options.file)});
        if (const auto written = writeWholeFile(options.output.path, writeSwingCsv(record)); !written)
            return fail(written.error());
        sayWritten(options.output);
    } else if (options.json) {
        put("%s\n", toJson(*solution).c_str());
    } else {
        printLegs(*solution);
    }
    return kDone;
}

} // namespace

void addLegs(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<LegsArguments>();
    auto* command = app.add_subcommand("legs", "wind, airspeed and deviation from three or more legs by GPS alone");
    addInputOption(*command, invocation, "LEGS.csv", options->file, "track_deg, ground_speed_kt; leg, compass_heading_deg, variation_deg")
        ->required();
    command->add_option_function<std::string>(
        "--variation",
        [options](const std::string& given) {
            const auto variation_deg = parseSignedAngle_deg(given);
            if (!variation_deg)
                throw CLI::ValidationError("--variation: " + describe(variation_deg.error()));
            options->legs.variation_deg = *variation_deg;
        },
        "east positive, for legs that state none");
    command->add_option("--variation-error", options->legs.variationError_deg, "of the variation, one standard deviation [deg]")
        ->check(CLI::Range(0.0, 90.0))
        ->capture_default_str();
    command->add_option("--speed-error", options->legs.speedError_kt, "of the mean ground velocity of a leg [kt]")
        ->check(CLI::Range(0.001, 100.0))
        ->capture_default_str();
    auto* json = command->add_flag("--json", options->json, "one JSON object on standard output");
    addOutputOption(
        *command, invocation, "-o,--output", options->output, "the legs as a swing in flight (Swing CSV), or the report", {".csv", ".pdf"})
        ->excludes(json);
    command->callback([options, &invocation] { invocation.action = [options] { return legsCommand(*options); }; });
}

} // namespace lubberline::app
