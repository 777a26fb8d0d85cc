#include <memory>

#include "app/Console.h"
#include "app/Outputs.h"
#include "app/commands/Command.h"
#include "core/base/OutputFile.h"
#include "core/base/WholeFile.h"
#include "core/format/exchange/ModelJson.h"
#include "core/format/results/SimulationJson.h"

namespace lubberline::app {

namespace {

struct CompensatorArguments {
    std::string model;
    AttitudeRange range;
    std::vector<double> magnets_nT{10000, 10000, 10000}, soft{0.1, 0.1};
    double limit_deg = 3;
    Output output;
    bool json = false;
};

void printRange(const char* what, const RangeResidual& residual)
{
    put("%-28s largest %7.2f deg (heading %03.0f, pitch %+.0f, roll %+.0f), rms %6.2f deg\n", what, residual.largest_deg,
        residual.heading_deg, residual.pitch_deg, residual.roll_deg, residual.rms_deg);
}

void printSetting(const char* what, const CompensatorSetting& setting)
{
    put("%-28s magnets %+.0f, %+.0f, %+.0f nT; soft iron %+.4f fore and aft, %+.4f athwart\n", what, setting.magnets_nT.x(),
        setting.magnets_nT.y(), setting.magnets_nT.z(), setting.foreAft, setting.athwart);
}

int compensatorCommand(const CompensatorArguments& options)
{
    const auto setup = readModelJsonFile(options.model);
    if (!setup)
        return fail(setup.error());
    const auto field = fieldOf(*setup);
    if (!field)
        return fail({field.error().code, {MARKED("app", "field: %1"), field.error().message}, nameOfInput(options.model)});
    const CompensatorReach reach{{options.magnets_nT[0], options.magnets_nT[1], options.magnets_nT[2]}, options.soft[0], options.soft[1]};
    const CompensatorResult result = bestCompensator(setup->model, *field, options.range, reach);
    if (!options.output.empty()) {
        SensorSetup set = *setup;
        set.model = withCompensator(set.model, result.best);
        if (const auto written = writeWholeFile(options.output.path, writeModelJson(set)); !written)
            return fail(written.error());
        sayWritten(options.output);
    }
    if (options.json) {
        put("%s\n", toJson(result, options.range, options.limit_deg).c_str());
        return kDone;
    }
    warn(result.warnings);
    put("pitch within %g, roll within %g deg\n", options.range.pitch_deg, options.range.roll_deg);
    printRange("as it is", result.before);
    printSetting("set on level ground", result.level);
    printRange("", result.afterLevel);
    printSetting("set for the range", result.best);
    printRange("", result.after);
    put("%g deg %s\n", options.limit_deg, result.after.largest_deg <= options.limit_deg ? "is kept" : "IS NOT KEPT");
    return kDone;
}

} // namespace

void addCompensator(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<CompensatorArguments>();
    auto* command = app.add_subcommand("compensator",
        "the setting of a compensator (magnets, soft-iron correctors) that is best over a range of attitudes, not only level");
    addInputOption(*command, invocation, "MODEL.json", options->model, "the sensor and its field")->required();
    command->add_option("--pitch", options->range.pitch_deg, "of the range, either way [deg]")
        ->check(CLI::Range(0.0, 89.0))
        ->capture_default_str();
    command->add_option("--roll", options->range.roll_deg, "of the range, either way [deg]")
        ->check(CLI::Range(0.0, 89.0))
        ->capture_default_str();
    command->add_option("--magnets-nT", options->magnets_nT, "X,Y,Z: how far the magnets reach, either way; 0: there is none")
        ->delimiter(',')
        ->expected(3)
        ->check(CLI::Range(0.0, 1e6))
        ->capture_default_str();
    command->add_option("--soft", options->soft, "A,E: how far soft-iron correctors reach, fore and aft and athwart; 0: there is none")
        ->delimiter(',')
        ->expected(2)
        ->check(CLI::Range(0.0, 1.0))
        ->capture_default_str();
    command->add_option("--limit", options->limit_deg, "that the residual is held against [deg]")
        ->check(CLI::Range(0.01, 180.0))
        ->capture_default_str();
    command->add_flag("--json", options->json, "one JSON object on standard output");
    addOutputOption(*command, invocation, "-o,--output", options->output, "the model with its compensator set", {".json"});
    command->callback([options, &invocation] { invocation.action = [options] { return compensatorCommand(*options); }; });
}

} // namespace lubberline::app
