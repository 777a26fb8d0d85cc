#include <nlohmann/json.hpp>

#include "app/Console.h"
#include "app/SwingList.h"
#include "app/commands/Command.h"
#include "core/base/TerminalText.h"
#include "core/record/RecordWords.h"
#include "db/transfer/Maintenance.h"

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

/// With a question mark where the record says signed and no signatures stand over it.
std::string stateOf(const ListedSwing& swing)
{
    return std::string(fileWord(swing.row.state)) + (swing.mark == db::SignedMark::ByStateAlone ? "?" : "");
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
            {"max_abs_deviation_deg", largest}, {"status", nameOf(swing.row.status)}, {"radio", std::string(fileWord(swing.radio))},
            {"signed", swing.mark == db::SignedMark::Stands}});
    }
    return nlohmann::ordered_json{{"swings", array}}.dump(2);
}

/// What can be shown is shown; that it is not all as it should be is told, too.
int sayDamages(db::Stores& stores)
{
    const auto damages = db::listDamages(stores.database());
    if (damages.empty())
        return kDone;
    warn(damages);
    return fail({ErrorCode::Corrupt,
        {MARKED(
             "app", "%1 of what is listed is damaged; expected a whole database: `lubberline db verify` lists all, a backup has what was"),
            damages.size()},
        stores.location().toStdString()});
}

int swingsCommand(db::Stores& stores, const SwingsArguments& options)
{
    const auto swings = listSwings(stores, options.aircraft);
    if (!swings)
        return fail(swings.error());
    if (options.json) {
        put("%s\n", jsonOf(*swings).c_str());
        return sayDamages(stores);
    }
    put("%-36s  %-10s %-10s %-18s %-10s %-8s %8s  %9s  %-13s  %s\n", "record", "type", "aircraft", "compass", "date", "state", "readings",
        "max (deg)", "status", "radio");
    for (const auto& swing : *swings)
        put("%-36s  %-10s %-10s %-18s %-10s %-8s %8d  %9s  %-13s  %s\n", swing.record.c_str(), inOneLine(swing.type).c_str(),
            inOneLine(swing.aircraft).c_str(), inOneLine(swing.compass).c_str(), swing.row.date.text().c_str(), stateOf(swing).c_str(),
            swing.row.readings, swing.row.maxAbsDeviation_deg ? text("%.1f", *swing.row.maxAbsDeviation_deg).c_str() : "-",
            nameOf(swing.row.status), std::string(fileWord(swing.radio)).c_str());
    return sayDamages(stores);
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
