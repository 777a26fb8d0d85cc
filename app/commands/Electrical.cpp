#include <nlohmann/json.hpp>

#include "app/Console.h"
#include "app/Outputs.h"
#include "app/Paths.h"
#include "app/QtSession.h"
#include "app/commands/Command.h"
#include "core/base/WholeFile.h"
#include "core/format/exchange/ElectricalJson.h"
#include "core/procedure/ElectricalChecks.h"
#include "ui/report/forms/ElectricalSheet.h"

namespace lubberline::app {

namespace {

struct ElectricalArguments {
    std::string file;
    Output output;
    bool json = false;
};

nlohmann::ordered_json jsonOf(const FourPointErrors& errors)
{
    return {{"error_deg", errors.error_deg}, {"north_south_deg", errors.northSouth_deg}, {"east_west_deg", errors.eastWest_deg},
        {"index_deg", errors.index_deg}, {"pair_0_180_deg", errors.pair0_180_deg}, {"pair_90_270_deg", errors.pair90_270_deg},
        {"pairs_agree", errors.pairsAgree}};
}

void print(const char* name, const FourPointErrors& errors)
{
    put("%-7s N-S %+.2f  E-W %+.2f  index %+.2f deg; pairs 0/180 %.2f, 90/270 %.2f: %s\n", name, errors.northSouth_deg, errors.eastWest_deg,
        errors.index_deg, errors.pair0_180_deg, errors.pair90_270_deg, errors.pairsAgree ? "agree within 0.2" : "do not agree within 0.2");
}

int electricalCommand(const ElectricalArguments& options)
{
    const auto text = readWholeFile(options.file, MARKED("app", "an Electrical JSON"));
    if (!text)
        return fail(text.error());
    const auto swing = readElectricalJson(*text, nameOfInput(options.file));
    if (!swing)
        return fail(swing.error());
    if (!options.output.empty()) {
        const auto session = makeDrawingSession();
        const ui::ElectricalSheet sheet{*swing, {}, {}, nowUtc()};
        if (const auto written = ui::writeElectricalSheet(sheet, QString::fromStdString(options.output.path)); !written)
            return fail(written.error());
        sayWritten(options.output);
        if (options.output.toStandardOutput())
            return kDone;
    }
    nlohmann::ordered_json object;
    object["sign"] = "indicated - selected";
    for (const auto& [name, table] : {std::pair{"before", &swing->before}, {"after", &swing->after}})
        if (const auto errors = errorsOf(*table)) {
            object[name] = jsonOf(*errors);
            if (!options.json)
                print(name, *errors);
        }
    if (const auto errors = electricalErrorsOf(*swing)) {
        object["headings"] = {{"read", errors->read}, {"largest_error_deg", errors->largest_deg},
            {"at_selected_deg", errors->largestAt_deg}, {"mean_error_deg", errors->mean_deg}};
        if (!options.json)
            put("headings: largest error %+.2f deg with %g selected, mean %+.2f, of %d read\n", errors->largest_deg, errors->largestAt_deg,
                errors->mean_deg, errors->read);
    }
    if (const auto check = selfCheckOf(*swing)) {
        object["self_check"] = {{"largest_deg", check->largest_deg}, {"mean_deg", check->mean_deg}, {"passed", check->passed}};
        if (!options.json)
            put("self-check: largest %.1f', mean %.1f': %s\n", check->largest_deg * 60, check->mean_deg * 60,
                check->passed ? "passed" : "not passed");
    }
    object["open"] = inEnglish(openPoints(*swing));
    if (options.json)
        put("%s\n", object.dump(2).c_str());
    else
        for (const auto& point : inEnglish(openPoints(*swing)))
            put("open: %s\n", point.c_str());
    return kDone;
}

} // namespace

void addElectrical(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<ElectricalArguments>();
    auto* command = app.add_subcommand("electrical", "the errors of an electrical swing's data sheet, and whether it passes");
    addInputOption(
        *command, invocation, "SHEET.json", options->file, "an Electrical JSON: table F1 before and after, 24 headings, self-check")
        ->required();
    addOutputOption(*command, invocation, "-o,--output", options->output, "write the record of the swing", {".pdf"});
    command->add_flag("--json", options->json, "one JSON object on standard output");
    command->callback([options, &invocation] { invocation.action = [options] { return electricalCommand(*options); }; });
}

} // namespace lubberline::app
