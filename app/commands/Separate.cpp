#include "app/Console.h"
#include "app/PlacedSwings.h"
#include "app/QtSession.h"
#include "app/commands/Command.h"
#include "core/format/results/PredictionJson.h"

namespace lubberline::app {

namespace {

struct SeparateArguments {
    std::vector<std::string> swings;
    bool json = false;
};

void printRow(const char* name, const char* unit, const Estimate& estimate, int decimals)
{
    put("  %-28s %+12.*f", name, decimals, estimate.value);
    if (estimate.standardError > 0)
        put(" +/- %.*f", decimals, estimate.standardError);
    put("  %s\n", unit);
}

int separateCommand(const SeparateArguments& options, const std::string& database)
{
    const auto session = makeDrawingSession();
    const auto placed = placedSwings(database, options.swings);
    if (!placed)
        return fail(placed.error());
    const auto separation = separateIron(placed->swings);
    if (!separation)
        return fail(separation.error());
    const auto knowledge = whatSwingsTell(placed->swings.front(), *separation);
    if (options.json) {
        put("%s\n", toJson(*separation, knowledge).c_str());
        return kDone;
    }
    warn(separation->warnings);
    put("%zu swings; all as parts of lambda\n", placed->swings.size());
    printRow("vertical soft iron c", "", separation->c, 4);
    printRow("vertical soft iron f", "", separation->f, 4);
    printRow("hard iron P", "nT", separation->P_nT, 0);
    printRow("hard iron Q", "nT", separation->Q_nT, 0);
    put("  correlation of c and P %+.2f; condition number %.1f (alike above %.0f)\n", separation->correlation, separation->conditionNumber,
        kAlikePlaces);
    for (const auto& each : knowledge)
        put("%s %s\n", each.known ? "known:    " : "not known:", each.what.english().c_str());
    return kDone;
}

} // namespace

void addSeparate(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<SeparateArguments>();
    auto* command
        = app.add_subcommand("separate", "hard iron told from vertical soft iron by swings of one compass where H and dip differ");
    command->add_option("--swing", options->swings, "a swing of the database (record id or its beginning); two at least")->required();
    command->add_flag("--json", options->json, "one JSON object on standard output");
    addDatabaseOption(*command, invocation);
    command->callback(
        [options, &invocation] { invocation.action = [options, &invocation] { return separateCommand(*options, invocation.database); }; });
}

} // namespace lubberline::app
