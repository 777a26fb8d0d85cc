#include "app/Console.h"
#include "app/commands/Command.h"
#include "core/base/WholeFile.h"
#include "core/format/exchange/ModelJson.h"
#include "core/format/results/SimulationJson.h"
#include <array>

namespace lubberline::app {

namespace {

struct SmithArguments {
    std::string model;
    bool json = false;
};

double exactOf(const ExactSmith& smith, Coefficient coefficient)
{
    return std::array{smith.A, smith.B, smith.C, smith.D, smith.E}[indexOf(coefficient)];
}

double approximateOf_rad(const ApproximateSmith& smith, Coefficient coefficient)
{
    return std::array{smith.A_rad, smith.B_rad, smith.C_rad, smith.D_rad, smith.E_rad}[indexOf(coefficient)];
}

void printTable(const PoissonSmith& smith, const MeridianField& field)
{
    put("H %.1f nT, Z %.1f nT (down +), dip %.2f deg; lambda %.6f\n\n", field.horizontal_nT, field.down_nT,
        toDegrees(field.inclination_rad()), smith.lambda);
    put("%15s%17s\n", "exact", "approx. (deg)");
    for (const Coefficient coefficient : kCoefficients) {
        put("%c %+13.6f", letterOf(coefficient), exactOf(smith.exact, coefficient));
        if (smith.approximate)
            put("%+17.4f\n", toDegrees(approximateOf_rad(*smith.approximate, coefficient)));
        else
            put("%17s\n", "-");
    }
    put("\nwhere the exact ones come from\n");
    for (const auto& term : smith.terms)
        put("%c %+13.6f  %s\n", letterOf(term.coefficient), term.value, term.cause.english().c_str());
}

int smithCommand(const SmithArguments& options)
{
    const auto setup = readModelJsonFile(options.model);
    if (!setup)
        return fail(setup.error());
    const auto field = fieldOf(*setup);
    if (!field)
        return fail({field.error().code, {MARKED("app", "field: %1"), field.error().message}, nameOfInput(options.model)});
    const auto smith = smithOf(setup->model, *field);
    if (!smith)
        return fail({smith.error().code, smith.error().message, nameOfInput(options.model)});
    if (!smith->approximate)
        warn({smith->whyNoApproximate});
    if (options.json)
        put("%s\n", toJson(*smith, *field).c_str());
    else
        printTable(*smith, *field);
    return kDone;
}

} // namespace

void addSmith(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<SmithArguments>();
    auto* command = app.add_subcommand("smith", "Smith's coefficients of a sensor model, and the iron that each comes from");
    addInputOption(
        *command, invocation, "MODEL.json,--model", options->model, "a Model JSON: field, soft and hard iron, circuits, misalignment")
        ->required();
    command->add_flag("--json", options->json, "one JSON object on standard output");
    command->callback([options, &invocation] { invocation.action = [options] { return smithCommand(*options); }; });
}

} // namespace lubberline::app
