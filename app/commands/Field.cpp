#include "app/Console.h"
#include "app/commands/Command.h"
#include "core/format/results/FieldJson.h"
#include <cmath>

namespace lubberline::app {

namespace {

struct FieldArguments {
    double latitude_deg = 0, longitude_deg = 0, altitude_m = 0;
    std::string date, model;
    bool json = false;
};

void printRow(const char* name, const char* unit, double value, double rate, const std::optional<double>& uncertainty, int decimals)
{
    put("  %-12s %12.*f %+10.*f", name, decimals, value, decimals, rate);
    if (uncertainty)
        put("   +/- %.*f", decimals, *uncertainty);
    put("  %s\n", unit);
}

void printTable(const FieldAnswer& answer)
{
    const auto& f = answer.field;
    const auto& u = answer.uncertainty;
    const auto part = [&u](double FieldUncertainty::*member) { return u ? std::optional((*u).*member) : std::nullopt; };
    const Place& place = answer.place;
    put("%s, %.2f %c %.2f %c, %.0f m above the ellipsoid, %.3f\n", answer.model.c_str(), std::abs(place.latitude_deg),
        place.latitude_deg < 0 ? 'S' : 'N', std::abs(place.longitude_deg), place.longitude_deg < 0 ? 'W' : 'E', place.height_m,
        answer.year);
    put("  %-12s %12s %10s\n", "", "value", "a year");
    printRow("X (north)", "nT", f.north_nT, answer.rate.north_nT, part(&FieldUncertainty::north_nT), 1);
    printRow("Y (east)", "nT", f.east_nT, answer.rate.east_nT, part(&FieldUncertainty::east_nT), 1);
    printRow("Z (down)", "nT", f.down_nT, answer.rate.down_nT, part(&FieldUncertainty::down_nT), 1);
    printRow("H", "nT", f.horizontal_nT(), answer.horizontalRate_nT, part(&FieldUncertainty::horizontal_nT), 1);
    printRow("F", "nT", f.total_nT(), answer.totalRate_nT, part(&FieldUncertainty::total_nT), 1);
    printRow(
        "declination", "deg, east +", f.variation().degrees(), answer.declinationRate_deg, part(&FieldUncertainty::declination_deg), 3);
    printRow("inclination", "deg, down +", toDegrees(f.inclination_rad()), answer.inclinationRate_deg,
        part(&FieldUncertainty::inclination_deg), 3);
}

int fieldCommand(const FieldArguments& options)
{
    const auto place = makePlace(options.latitude_deg, options.longitude_deg, options.altitude_m);
    if (!place)
        return fail(place.error());
    const auto year = decimalYear(options.date);
    if (!year)
        return fail(year.error());
    const auto model = options.model.empty() ? defaultFieldModel(*year) : fieldModelByName(options.model);
    if (!model)
        return fail(model.error());
    const auto answer = model->evaluate(*place, *year); // near a pole, too: with its warning
    if (!answer)
        return fail(answer.error());
    if (options.json) {
        put("%s\n", toJson(*answer).c_str());
        return kDone;
    }
    warn(answer->warnings);
    printTable(*answer);
    return kDone;
}

} // namespace

void addField(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<FieldArguments>();
    auto* command = app.add_subcommand("field", "the Earth's magnetic field at a place and date");
    command->add_option("--lat", options->latitude_deg, "geodetic latitude [deg, north positive]")->required();
    command->add_option("--lon", options->longitude_deg, "longitude [deg, east positive]")->required();
    command->add_option("--alt", options->altitude_m, "height above the WGS84 ellipsoid [m]")->capture_default_str();
    command->add_option("--date", options->date, "YYYY-MM-DD, or a year as 2026.5")->required();
    addInputOption(*command, invocation, "--model", options->model,
        "wmm2025, igrf14, or a coefficient file (WMM .COF, IGRF table); default: WMM where the date is inside its years, else IGRF-14");
    command->add_flag("--json", options->json, "one JSON object on standard output");
    command->callback([options, &invocation] { invocation.action = [options] { return fieldCommand(*options); }; });
}

} // namespace lubberline::app
