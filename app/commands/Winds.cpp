#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/Console.h"
#include "app/Outputs.h"
#include "app/Paths.h"
#include "app/QtSession.h"
#include "app/commands/Command.h"
#include "core/base/OutputFile.h"
#include "core/base/TerminalText.h"
#include "core/base/WholeFile.h"
#include "core/format/csv/WindCsv.h"
#include "core/format/results/WindsJson.h"
#include "ui/report/forms/WindSheet.h"

namespace lubberline::app {

namespace {

struct WindsArguments {
    std::string file;
    Output output;
    WindOptions winds;
    WindReading reading;
    bool json = false;
};

std::string figureOrDash(bool told, double value) { return told ? text("%+8.2f", value) : text("%8s", "-"); }

void printWinds(const WindResult& result)
{
    put("%s, %lld used; indication error (read - true) = offset + in phase sin + quadrature cos\n",
        counted(result.observations, "report").c_str(), static_cast<long long>(result.used));
    put("%-12s %7s %9s  %8s %8s %8s %6s  %9s %9s\n", "aircraft", "flights", "used", "in phase", "quadr.", "offset", "+-", "across kt",
        "after kt");
    for (const auto& one : result.aircraft) {
        const ClusteredFit& fit = one.fit.fit;
        put("%-12s %7d %9lld  %s %s %s %6s  %9s %9s\n", inOneLine(one.aircraft).c_str(), one.flights, static_cast<long long>(one.used),
            figureOrDash(fit.told[1], fit.value(1)).c_str(), figureOrDash(fit.told[2], fit.value(2)).c_str(),
            figureOrDash(fit.told[0], fit.value(0)).c_str(),
            fit.told[1] && fit.errorsTold ? text("%.2f", fit.standardError(1)).c_str() : "-",
            one.squaresBefore.count > 0 ? text("%.1f", one.before.transverse_kt).c_str() : "-",
            one.after ? text("%.1f", one.after->transverse_kt).c_str() : "-");
    }
}

void warnOfAircraft(const WindFile& file)
{
    warn(file.warnings);
    for (const auto& one : file.result.aircraft)
        for (const auto& warning : one.warnings)
            warn({one.aircraft.empty() ? warning : Message{MARKED("app", "%1: %2"), one.aircraft, warning}});
}

Result<void> writeWinds(const WindsArguments& options, const WindFile& file)
{
    if (options.output.kind == ".csv")
        return writeWholeFile(options.output.path, windTableCsv(file.result, options.winds.factor));
    const auto session = makeDrawingSession();
    return ui::writeWindSheet({file.result, options.winds.factor,
                                  QString::fromStdString(std::filesystem::path(nameOfInput(options.file)).filename().string()), nowUtc()},
        QString::fromStdString(options.output.path));
}

int windsCommand(const WindsArguments& options)
{
    const auto file
        = readWindCsvFile(options.file, options.winds, options.reading, consoleProgress("reading " + nameOfInput(options.file)));
    if (!file)
        return fail(file.error());
    if (!options.json || !options.output.empty())
        warnOfAircraft(*file);
    if (!options.output.empty()) {
        if (const auto written = writeWinds(options, *file); !written)
            return fail(written.error());
        sayWritten(options.output);
    } else if (options.json) {
        WindResult told = file->result;
        told.warnings = file->warnings;
        put("%s\n", toJson(told, options.winds.factor).c_str());
    } else {
        printWinds(file->result);
    }
    return kDone;
}

/// "from", "toward": which way a wind is given.
void addSense(
    CLI::App& command, const std::string& name, bool& toward, const std::shared_ptr<WindsArguments>& options, const std::string& whose)
{
    command
        .add_option_function<std::string>(
            name,
            [&toward, options](const std::string& sense) {
                toward = sense == "toward";
                options->winds.believed = true;
            },
            "which way " + whose + " are given, where their column is wrong; also takes the question back")
        ->check(CLI::IsMember({"from", "toward"}));
}

void addUnit(
    CLI::App& command, const std::string& name, double& factor, const std::shared_ptr<WindsArguments>& options, const std::string& whose)
{
    command
        .add_option_function<std::string>(
            name,
            [&factor, options](const std::string& unit) {
                factor = unit == "m/s" ? 3600.0 / 1852.0 : 1.0;
                options->winds.believed = true;
            },
            "the unit of " + whose + " where a column _kt holds another")
        ->check(CLI::IsMember({"kt", "m/s"}));
}

} // namespace

void addWinds(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<WindsArguments>();
    auto* command = app.add_subcommand("winds", "deviation of a fleet from its wind reports beside a reference wind");
    addInputOption(*command, invocation, "OBS.csv", options->file,
        "ground_speed_kt, track_deg, wind_speed_kt, wind_from_deg, ref_wind_speed_kt, ref_wind_from_deg; tas_kt, aircraft, flight, time_utc, "
        "latitude_deg, longitude_deg, altitude_m, roll_deg, heading_deg, source, group; without ground speed and track: by positions and times")
        ->required();
    command
        ->add_option("--factor", options->winds.factor,
            "of the table's sine: paper (1.05), exact (1.0530, so that straight lines between eight points hold the sine), none (1)")
        ->transform(CLI::CheckedTransformer(
            std::map<std::string, TableFactor>{{"paper", TableFactor::Paper}, {"exact", TableFactor::Exact}, {"none", TableFactor::None}}))
        ->default_str("paper");
    command->add_flag("--remove-common", options->winds.removeCommon, "take out the sine that the fleet has in common");
    command->add_option("--control", options->winds.control,
        "a group (column group) or an aircraft whose headings are held to be right, as by laser gyros: the others are told in its errors, and "
        "what it has in common is the reference's error");
    addSense(*command, "--winds", options->reading.toward, options, "reported winds");
    addSense(*command, "--reference-winds", options->reading.referenceToward, options, "reference winds");
    addUnit(*command, "--wind-unit", options->reading.windFactor, options, "reported winds");
    addUnit(*command, "--reference-unit", options->reading.referenceFactor, options, "reference winds");
    command->add_option("--max-roll", options->winds.mostRoll_deg, "beyond, a report is left out [deg]")
        ->check(CLI::Range(0.0, 90.0))
        ->capture_default_str();
    command->add_option("--max-climb", options->winds.mostClimb_m_s, "climbing faster, it is left out [m/s]")
        ->check(CLI::Range(0.0, 100.0))
        ->capture_default_str();
    auto* json = command->add_flag("--json", options->json, "one JSON object on standard output");
    addOutputOption(*command, invocation, "-o,--output", options->output, "the tables to upload, or the report", {".csv", ".pdf"})
        ->excludes(json);
    command->callback([options, &invocation] { invocation.action = [options] { return windsCommand(*options); }; });
}

} // namespace lubberline::app
