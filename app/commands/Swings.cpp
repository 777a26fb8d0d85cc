#include <cstdio>

#include <nlohmann/json.hpp>

#include "app/Console.h"
#include "app/SwingList.h"
#include "app/commands/Command.h"
#include "core/record/RecordWords.h"

namespace lubberline::app {

namespace {

struct SwingsArguments {
    std::string aircraft;
    bool json = false;
};

const char* nameOf(Status status)
{
    switch (status) {
    case Status::NotKnown: return "not known";
    case Status::InLimits: return "in limits";
    case Status::OutOfLimits: return "out of limits";
    }
    return "";
}

std::string jsonOf(const std::vector<ListedSwing>& swings)
{
    nlohmann::ordered_json array = nlohmann::ordered_json::array();
    for (const auto& swing : swings) {
        nlohmann::ordered_json largest;
        if (swing.row.maxAbsDeviation_deg)
            largest = *swing.row.maxAbsDeviation_deg;
        array.push_back({{"record", swing.record}, {"type", swing.type}, {"aircraft", swing.aircraft}, {"compass", swing.compass},
            {"date", swing.row.date.text()}, {"state", std::string(fileWord(swing.row.state))}, {"readings", swing.row.readings},
            {"max_abs_deviation_deg", largest}, {"status", nameOf(swing.row.status)}});
    }
    return nlohmann::ordered_json{{"swings", array}}.dump(2);
}

int swingsCommand(db::Stores& stores, const SwingsArguments& options)
{
    const auto swings = listSwings(stores, options.aircraft);
    if (!swings)
        return fail(swings.error());
    if (options.json) {
        std::printf("%s\n", jsonOf(*swings).c_str());
        return kDone;
    }
    std::printf("%-36s  %-10s %-10s %-18s %-10s %-8s %8s  %9s  %s\n", "record", "type", "aircraft", "compass", "date", "state", "readings",
        "max (deg)", "status");
    for (const auto& swing : *swings)
        std::printf("%-36s  %-10s %-10s %-18s %-10s %-8s %8d  %9s  %s\n", swing.record.c_str(), swing.type.c_str(), swing.aircraft.c_str(),
            swing.compass.c_str(), swing.row.date.text().c_str(), std::string(fileWord(swing.row.state)).c_str(), swing.row.readings,
            swing.row.maxAbsDeviation_deg ? text("%.1f", *swing.row.maxAbsDeviation_deg).c_str() : "-", nameOf(swing.row.status));
    return kDone;
}

} // namespace

void addSwings(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<SwingsArguments>();
    auto* command = app.add_subcommand("swings", "list the swings of the database with their record ids");
    command->add_option("--aircraft", options->aircraft, "of this registration only");
    command->add_flag("--json", options->json, "one JSON object on standard output");
    actOnStores(*command, invocation, db::OpenMode::ReadOnly, [options](db::Stores& stores) { return swingsCommand(stores, *options); });
}

} // namespace lubberline::app
