#include "app/LogOptions.h"

#include <cmath>

#include "app/Console.h"
#include "core/base/WholeFile.h"
#include "core/earth/FieldModel.h"

namespace lubberline::app {

void addLogOptions(CLI::App& command, Invocation& invocation, LogArguments& options)
{
    addInputOption(command, invocation, "LOG.csv", options.file,
        "a sensor log: time_s, bx_nT, by_nT, bz_nT (or _uT, _mG, _G, none for counts), heading_deg, pitch_deg, roll_deg, current_A:NAME")
        ->required();
    command
        .add_option_function<std::vector<std::string>>(
            "--columns",
            [&options](const std::vector<std::string>& choices) {
                for (const auto& choice : choices) {
                    const auto equals = choice.find('=');
                    if (equals == std::string::npos)
                        throw CLI::ValidationError(
                            "--columns: \"" + choice + "\"; expected KEY=NAME, KEY of time, bx, by, bz, heading, pitch, roll");
                    options.reading.columns[choice.substr(0, equals)] = choice.substr(equals + 1);
                }
            },
            "which column of the file is which, as bx=\"Feld X\"; several times")
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false);
    command
        .add_option_function<std::string>(
            "--unit",
            [&options](const std::string& unit) {
                for (const FieldUnit known :
                    {FieldUnit::Nanotesla, FieldUnit::Microtesla, FieldUnit::Milligauss, FieldUnit::Gauss, FieldUnit::Counts})
                    if (unit == nameOf(known))
                        options.reading.unit = known;
            },
            "what the field is counted in, over what the columns say")
        ->check(CLI::IsMember({"nT", "uT", "mG", "G", "counts"}));
    command.add_option("--from", options.from, "use the log from this time on [s; rows, where it has no time]");
    command.add_option("--to", options.to, "use the log to this time [s; rows]");
}

Result<SensorLog> readLog(const LogArguments& options)
{
    auto log = readSensorLogFile(options.file, options.reading, consoleProgress("reading " + nameOfInput(options.file)));
    if (!log)
        return log.error();
    if (options.from == std::numeric_limits<double>::lowest() && options.to == std::numeric_limits<double>::max())
        return log;
    SensorLog part = partOf(*log, options.from, options.to);
    if (part.size() == 0)
        return Error{ErrorCode::InvalidInput, MARKED("app", "has no samples between --from and --to"), nameOfInput(options.file)};
    return part;
}

void addKnownFieldOptions(CLI::App& command, KnownFieldArguments& options)
{
    auto* field = command.add_option("--field-nT", options.field_nT, "the Earth's field where the log was taken [nT]")
                      ->check(CLI::Range(1000.0, 200000.0));
    command.add_option("--dip-deg", options.dip_deg, "its dip [deg, down positive]")->check(CLI::Range(-90.0, 90.0))->needs(field);
    auto* latitude = command.add_option("--lat", options.latitude_deg, "instead: latitude [deg, north positive]")->excludes(field);
    auto* longitude = command.add_option("--lon", options.longitude_deg, "longitude [deg, east positive]")->needs(latitude);
    auto* date = command.add_option("--date", options.date, "YYYY-MM-DD, or a year as 2026.5")->needs(latitude);
    command.add_option("--alt", options.altitude_m, "height above the WGS84 ellipsoid [m]")->needs(latitude);
    latitude->needs(longitude)->needs(date);
}

Result<KnownField> knownField(const KnownFieldArguments& options)
{
    KnownField known;
    if (options.latitude_deg) {
        const auto place = makePlace(*options.latitude_deg, options.longitude_deg.value_or(kNoValue), options.altitude_m);
        if (!place)
            return place.error();
        const auto year = decimalYear(options.date);
        if (!year)
            return year.error();
        const auto model = defaultFieldModel(*year);
        if (!model)
            return model.error();
        const auto answer = model->evaluate(*place, *year);
        if (!answer)
            return answer.error();
        known.total_nT = answer->field.total_nT();
        known.meridian = answer->field.meridian();
        known.variation = answer->field.variation();
        return known;
    }
    known.total_nT = options.field_nT;
    if (options.field_nT && options.dip_deg) {
        const double dip_rad = toRadians(*options.dip_deg);
        known.meridian = MeridianField{*options.field_nT * std::cos(dip_rad), *options.field_nT * std::sin(dip_rad)};
    }
    return known;
}

} // namespace lubberline::app
