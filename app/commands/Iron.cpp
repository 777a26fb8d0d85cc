#include "app/Console.h"
#include "app/Outputs.h"
#include "app/commands/Command.h"
#include "core/base/OutputFile.h"
#include "core/base/WholeFile.h"
#include "core/format/exchange/BenchJson.h"
#include "core/format/exchange/ModelJson.h"
#include "core/format/results/BenchModelJson.h"

namespace lubberline::app {

namespace {

struct IronArguments {
    std::string bench;
    Output output;
    std::vector<std::string> states;
    std::optional<double> latitude_deg, longitude_deg, horizontal_nT, dip_deg;
    double altitude_m = 0;
    std::string date;
    bool json = false;
};

/// "gear=extended" …; the check of the option has seen the sign.
BenchStates chosenStates(const IronArguments& options, const IronBench& bench)
{
    BenchStates states;
    for (const auto& [group, all] : groupsOf(bench))
        states[group] = all.front();
    for (const auto& text : options.states) {
        const auto sign = text.find('=');
        states[text.substr(0, sign)] = text.substr(sign + 1);
    }
    return states;
}

Result<std::variant<MeridianField, PlaceAndDate, TotalField>> fieldOf(const IronArguments& options)
{
    if (options.horizontal_nT)
        return std::variant<MeridianField, PlaceAndDate, TotalField>(
            MeridianField::fromDip(*options.horizontal_nT, toRadians(*options.dip_deg)));
    const auto place = makePlace(*options.latitude_deg, *options.longitude_deg, options.altitude_m);
    if (!place)
        return place.error();
    if (const auto year = decimalYear(options.date); !year)
        return year.error();
    return std::variant<MeridianField, PlaceAndDate, TotalField>(PlaceAndDate{*place, options.date});
}

Result<void> writeModel(const IronArguments& options, const BenchModel& model, const BenchStates& states)
{
    const auto field = fieldOf(options);
    if (!field)
        return field.error();
    std::string note = "from the iron bench";
    for (const auto& [group, state] : states)
        note += ", " + group + " " + state;
    return writeWholeFile(options.output.path, writeModelJson({*field, model.model, note}));
}

void printMatrix(const Eigen::Matrix3d& matrix)
{
    for (int row = 0; row < 3; ++row)
        put("  %+11.6f %+11.6f %+11.6f\n", matrix(row, 0), matrix(row, 1), matrix(row, 2));
}

void printTable(const BenchModel& model, const BenchStates& states)
{
    for (const auto& [group, state] : states)
        put("%s: %s\n", group.c_str(), state.c_str());
    put("soft iron S [a b c; d e f; g h k]\n");
    printMatrix(model.model.softIron);
    const auto& p = model.model.hardIron_nT;
    put("hard iron P, Q, R (nT)\n  %+11.1f %+11.1f %+11.1f\n", p.x(), p.y(), p.z());
    if (!model.model.circuits.empty())
        put("circuits (nT per A)\n");
    for (const auto& circuit : model.model.circuits)
        put("  %+11.3f %+11.3f %+11.3f  %s, %g A, %s\n", circuit.field_nT_per_A.x(), circuit.field_nT_per_A.y(), circuit.field_nT_per_A.z(),
            circuit.name.c_str(), circuit.current_A, circuit.on ? "on" : "off");
    put("\n%12s %10s %10s %10s %10s %10s %10s  part\n", "distance (m)", "by", "P (nT)", "Q (nT)", "R (nT)", "c", "f");
    for (const auto& part : model.parts)
        put("%12.3f %10s %+10.1f %+10.1f %+10.1f %+10.5f %+10.5f  %s\n", part.distance_m, part.dipole ? "dipole" : "tensor",
            part.hardIron_nT.x(), part.hardIron_nT.y(), part.hardIron_nT.z(), part.softIron(0, 2), part.softIron(1, 2), part.part.c_str());
}

int ironCommand(const IronArguments& options)
{
    const auto bench = readBenchJsonFile(options.bench);
    if (!bench)
        return fail(bench.error());
    const auto states = chosenStates(options, *bench);
    const auto model = benchModel(*bench, states, consoleProgress("iron bench"));
    if (!model)
        return fail({model.error().code, model.error().message, nameOfInput(options.bench)});
    if (!options.output.empty()) {
        if (const auto written = writeModel(options, *model, states); !written)
            return fail(written.error());
        sayWritten(options.output);
        if (options.output.toStandardOutput())
            return kDone;
    }
    if (options.json) {
        put("%s\n", toJson(*model, states).c_str());
        return kDone;
    }
    warn(model->warnings);
    printTable(*model, states);
    return kDone;
}

/// The field of the model file: both of H and dip, or place and date; asked for before anything is computed.
void checkField(const IronArguments& options)
{
    const bool given = options.horizontal_nT || options.dip_deg;
    const bool placed = options.latitude_deg || options.longitude_deg || !options.date.empty();
    if (given && !(options.horizontal_nT && options.dip_deg))
        throw CLI::ValidationError("--H-nT and --dip-deg belong together");
    if (placed && !(options.latitude_deg && options.longitude_deg && !options.date.empty()))
        throw CLI::ValidationError("--lat, --lon and --date belong together");
    if (given && placed)
        throw CLI::ValidationError("the field is given twice; expected --H-nT and --dip-deg, or --lat, --lon and --date");
    if (!options.output.empty() && !given && !placed)
        throw CLI::ValidationError("-o: a model file has a field; expected --H-nT and --dip-deg, or --lat, --lon and --date");
}

} // namespace

void addIron(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<IronArguments>();
    auto* command = app.add_subcommand("iron", "what ferrous parts, loops and wires around a sensor do to the field there");
    addInputOption(*command, invocation, "BENCH.json", options->bench, "a Bench JSON: parts, loops and wires round a sensor")->required();
    command->add_option("--state", options->states, "where a moving group is, as gear=extended (default: the first state of each group)")
        ->type_name("GROUP=STATE")
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false)
        ->check([](const std::string& text) {
            const auto sign = text.find('=');
            return sign != std::string::npos && sign > 0 && sign + 1 < text.size() ? std::string()
                                                                                   : "--state: “" + text + "”; expected GROUP=STATE";
        });
    command->add_flag("--json", options->json, "one JSON object on standard output");
    addOutputOption(*command, invocation, "-o,--output", options->output, "write a Model JSON with the field below", {".json"});
    command->add_option("--H-nT", options->horizontal_nT, "horizontal field [nT]")->check(CLI::Range(0.0, 1e9));
    command->add_option("--dip-deg", options->dip_deg, "inclination, down positive [deg]")->check(CLI::Range(-89.999, 89.999));
    command->add_option("--lat", options->latitude_deg, "geodetic latitude [deg, north positive]");
    command->add_option("--lon", options->longitude_deg, "longitude [deg, east positive]");
    command->add_option("--alt", options->altitude_m, "height above the WGS84 ellipsoid [m]")->capture_default_str();
    command->add_option("--date", options->date, "YYYY-MM-DD, or a year as 2026.5");
    command->callback([options, &invocation] {
        checkField(*options);
        invocation.action = [options] { return ironCommand(*options); };
    });
}

} // namespace lubberline::app
