// locate, distances and site-check: where a sensor may stand, and what disturbs it there.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "app/Console.h"
#include "app/SheetOutput.h"
#include "app/SwingSource.h"
#include "app/commands/Command.h"
#include "core/base/Number.h"
#include "core/base/WholeFile.h"
#include "core/check/History.h"
#include "core/deviation/TurnedBothWays.h"
#include "core/format/csv/StrayCsv.h"
#include "core/format/results/SensorTestsJson.h"
#include "core/swing/Observations.h"
#include "ui/report/forms/InflightSheets.h"
#include "ui/report/forms/InstallationSheet.h"

namespace lubberline::app {

namespace {

struct LocateArguments {
    std::string file;
    double length_m = 0;
    Output output;
    bool json = false;
};

int locateCommand(const LocateArguments& options)
{
    const auto readings = readStrayCsvFile(options.file);
    if (!readings)
        return fail(readings.error());
    const auto source = locateDipole(*readings, options.length_m);
    if (!source)
        return fail({source.error().code, source.error().message, nameOfInput(options.file)});
    if (options.json)
        put("%s\n", toJson(*source).c_str());
    else
        warn(source->warnings);
    if (!options.output.empty())
        return writeSheet(ui::dipoleSheet(*source, readings->size(), ui::sourceName(options.file)), options.output);
    if (options.json)
        return kDone;
    put("source at %.3f, %.3f, %.3f m (+- %.3f, %.3f, %.3f)\n", source->at_m.x(), source->at_m.y(), source->at_m.z(), source->atError_m.x(),
        source->atError_m.y(), source->atError_m.z());
    put("moment %.3f A m2 (+- %.3f): %+.3f, %+.3f, %+.3f\n", source->moment_A_m2.norm(), source->momentError_A_m2, source->moment_A_m2.x(),
        source->moment_A_m2.y(), source->moment_A_m2.z());
    put("uniform field %.0f, %.0f, %.0f nT (+- %.0f, %.0f, %.0f); %.1f nT rms are left; nearest reading at %.2f m\n",
        source->uniform_nT.x(), source->uniform_nT.y(), source->uniform_nT.z(), source->uniformError_nT.x(), source->uniformError_nT.y(),
        source->uniformError_nT.z(), source->rms_nT, source->nearest_m);
    return kDone;
}

struct SiteCheckArguments {
    std::string clockwise, counterClockwise;
    double limit_deg = 1;
    Output output;
    bool json = false;
};

int siteCheckCommand(const SiteCheckArguments& options)
{
    const auto first = swingFromCsv(options.clockwise);
    if (!first)
        return fail(first.error());
    const auto second = swingFromCsv(options.counterClockwise);
    if (!second)
        return fail(second.error());
    const SourcedRecord runs[] = {{nameOfInput(options.clockwise), first->record}, {nameOfInput(options.counterClockwise), second->record}};
    if (const auto one = checkHistory(runs); !one)
        return fail(one.error());
    const auto both = turnedBothWays(observationsOf(first->record.swing), observationsOf(second->record.swing), options.limit_deg);
    if (!both)
        return fail({both.error().code, both.error().message, nameOfInput(options.clockwise)});
    if (options.json)
        put("%s\n", toJson(*both).c_str());
    else {
        warn(first->warnings);
        warn(second->warnings);
    }
    if (!options.output.empty())
        return writeSheet(
            ui::siteCheckSheet(*both, ui::sourceName(options.clockwise) + ", " + ui::sourceName(options.counterClockwise)), options.output);
    if (options.json)
        return kDone;
    put("clockwise - counter-clockwise: constant %+.2f (+- %.2f), sin %+.2f (+- %.2f), cos %+.2f (+- %.2f) deg; %.2f deg rms are left\n",
        both->difference_deg[0], both->standardError_deg[0], both->difference_deg[1], both->standardError_deg[1], both->difference_deg[2],
        both->standardError_deg[2], both->residual_deg);
    for (const Message& finding : both->findings)
        put("%s\n", finding.english().c_str());
    put("largest difference %.2f deg: %s %.2f\n", both->largest_deg, both->within() ? "within" : "MORE THAN", both->limit_deg);
    if (both->within() && !both->passes)
        put("does not pass: the runs are not one each way round over all headings\n");
    return kDone;
}

struct DistancesArguments {
    std::vector<std::string> measured;
    Output output;
};

/// "2=1.30": the second of the list stands 1.30 m away. What is not named was not looked at.
Result<std::vector<std::optional<double>>> measuredDistances(const std::vector<std::string>& typed)
{
    std::vector<std::optional<double>> measured(installationDistances().size());
    for (const std::string& one : typed) {
        const std::string_view whole = one;
        const auto equals = std::min(whole.find('='), whole.size());
        const auto number = readNumber(whole.substr(0, equals)), metres = readNumber(whole.substr(std::min(equals + 1, whole.size())));
        const bool read = number.fault == NumberFault::None && metres.fault == NumberFault::None;
        if (!read || metres.value < 0 || metres.value > 1000 || number.value != std::floor(number.value) || number.value < 1
            || number.value > static_cast<double>(measured.size()))
            return Error{ErrorCode::InvalidInput,
                {MARKED("app", "--measured %1: expected the number of a thing, 1 to %2, and metres, 0 to 1000, as 2=1.30"), one,
                    measured.size()}};
        auto& place = measured[static_cast<std::size_t>(number.value) - 1];
        if (place)
            return Error{ErrorCode::InvalidInput, {MARKED("app", "--measured %1: that thing is named twice"), one}};
        place = metres.value;
    }
    return measured;
}

int distancesCommand(const DistancesArguments& options)
{
    const auto measured = measuredDistances(options.measured);
    if (!measured)
        return fail(measured.error());
    if (!options.output.empty())
        return writeSheet(ui::distancesSheet(*measured), options.output);
    put("least distance of a flux gate from\n");
    const auto asked = installationDistances();
    for (std::size_t i = 0; i < asked.size(); ++i) {
        put("%zu  %4.1f m  %s", i + 1, asked[i].least_m, Message(asked[i].thing).english().c_str());
        if (const auto metres = (*measured)[i])
            put(": %.2f m, %s", *metres,
                *metres < asked[i].least_m ? text("TOO NEAR by %.2f m", asked[i].least_m - *metres).c_str() : "kept");
        else if (!options.measured.empty())
            put(": not looked at");
        put("\n");
    }
    return kDone;
}

} // namespace

void addInstallation(CLI::App& app, Invocation& invocation)
{
    auto locating = std::make_shared<LocateArguments>();
    auto* locate = app.add_subcommand("locate", "a source of stray field located and sized as a dipole, from readings around it");
    addInputOption(*locate, invocation, "READINGS.csv", locating->file,
        "x_m, y_m, z_m, bx_nT, by_nT, bz_nT; a uniform field is found beside the source")
        ->required();
    locate->add_option("--length", locating->length_m, "of the source [m]: nearer than three of them it is no dipole")
        ->check(CLI::Range(0.0, 100.0));
    addOutputOption(*locate, invocation, "-o,--output", locating->output, "the report", {".pdf"});
    locate->add_flag("--json", locating->json, "one JSON object on standard output");
    locate->callback([locating, &invocation] { invocation.action = [locating] { return locateCommand(*locating); }; });

    auto checking = std::make_shared<SiteCheckArguments>();
    auto* check = app.add_subcommand(
        "site-check", "a run clockwise held against one counter-clockwise: lag, hysteresis, a site that is not uniform");
    addInputOption(*check, invocation, "CLOCKWISE.csv", checking->clockwise, "Swing CSV of the run clockwise")->required();
    addInputOption(*check, invocation, "COUNTERCLOCKWISE.csv", checking->counterClockwise, "Swing CSV of the run the other way")
        ->required();
    check->add_option("--limit", checking->limit_deg, "of the largest difference [deg]")
        ->check(CLI::Range(0.01, 180.0))
        ->capture_default_str();
    addOutputOption(*check, invocation, "-o,--output", checking->output, "the report", {".pdf"});
    check->add_flag("--json", checking->json, "one JSON object on standard output");
    check->callback([checking, &invocation] { invocation.action = [checking] { return siteCheckCommand(*checking); }; });

    auto* distances = app.add_subcommand("distances", "how far a flux gate is to stand from motors, iron and wires, by its maker");
    auto measuring = std::make_shared<DistancesArguments>();
    distances->add_option("--measured", measuring->measured, "NUMBER=METRES of a thing in the list, once for each that was looked at");
    addOutputOption(*distances, invocation, "-o,--output", measuring->output, "the checklist", {".pdf"});
    distances->callback([measuring, &invocation] { invocation.action = [measuring] { return distancesCommand(*measuring); }; });
}

} // namespace lubberline::app
