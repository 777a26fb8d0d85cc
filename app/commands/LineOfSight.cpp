// line-of-sight: what makes the line of sight of a helmet wrong, from the sensors to the turret.
#include <memory>

#include "app/Console.h"
#include "app/LogOptions.h"
#include "app/Outputs.h"
#include "app/Paths.h"
#include "app/QtSession.h"
#include "core/angle/Angle.h"
#include "core/angle/PrintedHeading.h"
#include "core/format/exchange/ModelJson.h"
#include "core/format/results/LineOfSightJson.h"
#include "ui/report/forms/LineOfSightSheet.h"

namespace lubberline::app {

namespace {

struct SightArguments {
    KnownFieldArguments field;
    std::string aircraftModel, helmetModel;
    std::vector<double> aircraft_deg{0, 0, 0}, look_deg{0, 0, 0}, turret_deg{0, 0, 0}, cockpit_nT{0, 0, 0};
    std::vector<double> noise_nT{0, 0}, tiltError_deg{0, 0};
    double turretError_deg = 0;
    Output output;
    bool json = false;
};

Result<SensorModel> ironOf(const std::string& file)
{
    if (file.empty())
        return SensorModel();
    const auto setup = readModelJsonFile(file);
    if (!setup)
        return setup.error();
    return setup->model;
}

void printError(const std::string& name, const char* kind, const SightError& error)
{
    put("%-32s%-10s%+10.3f%+10.3f%12.3f%+10.3f\n", name.c_str(), kind, error.aircraft.azimuth_deg, error.aircraft.elevation_deg,
        error.turret.azimuth_deg, error.turret.elevation_deg);
}

void printBudget(const SightBudget& budget)
{
    put("looking: azimuth %+.1f, elevation %+.1f deg in the aircraft; %+.1f, %+.1f for the turret\n", budget.truth.aircraft.azimuth_deg,
        budget.truth.aircraft.elevation_deg, budget.truth.turret.azimuth_deg, budget.truth.turret.elevation_deg);
    put("helmet: heading %.1f, pitch %+.1f, roll %+.1f deg\n\n", printedHeading_deg(budget.helmet.heading.degrees(), 1),
        toDegrees(budget.helmet.pitch_rad), toDegrees(budget.helmet.roll_rad));
    put("%-42s%20s%22s\n%-42s%10s%10s%12s%10s\n", "error (deg)", "aircraft's axes", "turret's axes", "", "azimuth", "elevation", "azimuth",
        "elevation");
    for (const SightCause& cause : budget.causes)
        printError(cause.name.english(), cause.byChance ? "sigma" : "stays", cause.error);
    printError("all that stays", "stays", budget.stays);
    printError("all by chance", "sigma", budget.byChance);
    printError("together", "rms", budget.whole);
}

int sightCommand(const SightArguments& options)
{
    const auto known = knownField(options.field);
    if (!known)
        return fail(known.error());
    if (!known->meridian)
        return fail({ErrorCode::InvalidInput,
            MARKED("app", "a line of sight needs the field: --field-nT and --dip-deg, or --lat, --lon and --date")});
    const auto aircraftIron = ironOf(options.aircraftModel), helmetIron = ironOf(options.helmetModel);
    if (!aircraftIron || !helmetIron)
        return fail(aircraftIron ? helmetIron.error() : aircraftIron.error());
    SightCase given{.field = *known->meridian};
    given.aircraft = {*aircraftIron, options.noise_nT[0], options.tiltError_deg[0]};
    given.helmet = {*helmetIron, options.noise_nT[1], options.tiltError_deg[1]};
    given.aircraftAttitude
        = {MagneticHeading::fromDegrees(options.aircraft_deg[0]), toRadians(options.aircraft_deg[1]), toRadians(options.aircraft_deg[2])};
    given.turret = {toRadians(options.turret_deg[0]), toRadians(options.turret_deg[1]), toRadians(options.turret_deg[2])};
    given.turretError_deg = options.turretError_deg;
    given.cockpit_nT = {options.cockpit_nT[0], options.cockpit_nT[1], options.cockpit_nT[2]};
    const SightBudget budget = sightBudget(given, {options.look_deg[0], options.look_deg[1]}, options.look_deg[2]);
    if (!options.json || !options.output.empty())
        warn(budget.warnings);
    if (!options.output.empty()) {
        const auto session = makeDrawingSession();
        ui::ReferenceSheet sheet = ui::sightSheet(given, budget);
        sheet.madeAtUtc = nowUtc();
        if (const auto written = ui::writeReferenceSheet(sheet, QString::fromStdString(options.output.path)); !written)
            return fail(written.error());
        sayWritten(options.output);
    }
    if (options.json)
        put("%s\n", toJson(budget, sightSweep(given)).c_str());
    else
        printBudget(budget);
    return kDone;
}

} // namespace

void addLineOfSight(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<SightArguments>();
    auto* command = app.add_subcommand("line-of-sight",
        "what makes the line of sight of a helmet wrong: by the aircraft's sensor, the helmet's, the cockpit and the turret's mount");
    addKnownFieldOptions(*command, options->field);
    const auto triple = [command](const char* name, std::vector<double>& values, double most, const char* what) {
        command->add_option(name, values, what)->delimiter(',')->expected(3)->check(CLI::Range(-most, most))->capture_default_str();
    };
    const auto pair = [command](const char* name, std::vector<double>& values, double most, const char* what) {
        command->add_option(name, values, what)->delimiter(',')->expected(2)->check(CLI::Range(0.0, most))->capture_default_str();
    };
    triple("--aircraft-deg", options->aircraft_deg, 360, "HEADING,PITCH,ROLL of the aircraft, magnetic");
    triple("--look-deg", options->look_deg, 180, "AZIMUTH,ELEVATION,ROLL of the helmet in the aircraft's axes");
    triple("--turret-deg", options->turret_deg, 180, "ROLL,PITCH,YAW of the turret's mount in the aircraft's axes");
    triple("--cockpit-nT", options->cockpit_nT, 1e6, "X,Y,Z of a constant field of the cockpit at the helmet, in the aircraft's axes");
    pair("--noise-nT", options->noise_nT, 1e6, "AIRCRAFT,HELMET: standard deviation of one axis of each sensor");
    pair("--tilt-error-deg", options->tiltError_deg, 45, "AIRCRAFT,HELMET: standard deviation of the pitch and of the roll of each");
    command->add_option("--turret-error-deg", options->turretError_deg, "standard deviation of each angle of the turret's mount")
        ->check(CLI::Range(0.0, 45.0));
    addInputOption(*command, invocation, "--aircraft-model", options->aircraftModel, "Model JSON: iron left at the aircraft's sensor");
    addInputOption(*command, invocation, "--helmet-model", options->helmetModel, "Model JSON: iron left at the helmet's sensor");
    command->add_flag("--json", options->json, "one JSON object on standard output, with a sweep over where one looks");
    addOutputOption(*command, invocation, "-o,--output", options->output, "write the report", {".pdf"});
    command->callback([options, &invocation] { invocation.action = [options] { return sightCommand(*options); }; });
}

} // namespace lubberline::app
