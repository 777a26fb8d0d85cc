#include "app/Console.h"
#include "app/OpenStores.h"
#include "app/Outputs.h"
#include "app/PlacedSwings.h"
#include "app/QtSession.h"
#include "app/commands/Command.h"
#include "core/angle/PrintedHeading.h"
#include "core/base/FileText.h"
#include "core/base/Number.h"
#include "core/base/OutputFile.h"
#include "core/earth/FieldModel.h"
#include "core/format/exchange/ModelJson.h"
#include "core/format/results/PredictionJson.h"
#include "core/swing/ModelBand.h"
#include "core/swing/Prediction.h"

namespace lubberline::app {

namespace {

struct PredictArguments {
    std::string model, date;
    Output output;
    std::vector<std::string> swings;
    double latitude_deg = 0, longitude_deg = 0, altitude_m = 0;
    AssumedIron assumed;
    bool json = false;
};

struct PredictAnswer {
    Prediction there;
    std::optional<LimitsProfile> limits;
};

Result<MeridianField> fieldThere(const PredictArguments& options)
{
    const auto place = makePlace(options.latitude_deg, options.longitude_deg, options.altitude_m);
    if (!place)
        return place.error();
    const auto year = decimalYear(options.date);
    if (!year)
        return year.error();
    const auto model = defaultFieldModel(*year);
    if (!model)
        return model.error();
    const auto answer = fieldForCompass(*model, *place, *year);
    return answer ? Result<MeridianField>(answer->field.meridian()) : Result<MeridianField>(answer.error());
}

Result<PredictAnswer> fromModel(const std::string& path, const MeridianField& there)
{
    const auto setup = readModelJsonFile(path);
    if (!setup)
        return setup.error();
    const auto here = fieldOf(*setup); // the model's own place is the one to compare with
    auto prediction = predict(setup->model, {here ? std::optional(*here) : std::nullopt, there});
    if (!prediction)
        return prediction.error();
    if (!here)
        prediction->warnings.push_back({MARKED("app", "what changes from here is not told: %1"), here.error().message});
    if (setup->uncertainty)
        addModelBand(*prediction, setup->model, *setup->uncertainty);
    return PredictAnswer{std::move(prediction.value()), {}};
}

Result<PredictAnswer> fromSwings(const PlacedSwings& swings, const PredictArguments& options, const MeridianField& there)
{
    auto prediction = predict(swings.swings, {swings.swings.back().field, there}, options.assumed);
    if (!prediction)
        return prediction.error();
    return PredictAnswer{std::move(prediction.value()), swings.limits};
}

void printTable(const PredictAnswer& answer)
{
    const Prediction& there = answer.there;
    put("expected with H %.0f nT, dip %+.1f deg; from %s\n", there.there.horizontal_nT, toDegrees(there.there.inclination_rad()),
        there.basis.english().c_str());
    if (there.assumed)
        put("the whole curve lies between lowest and highest with a probability of %.0f %%, assuming %s\n", 100 * kBoundProbability,
            sayAssumed(*there.assumed).english().c_str());
    put("magnetic   deviation     lowest    highest\n   (deg)  (deg, E +)      (deg)      (deg)\n");
    for (std::size_t i = 0; i < there.points.size(); i += 6) {
        const auto& point = there.points[i];
        if (point.deviation)
            put("%8.0f  %+10.2f %+10.2f %+10.2f\n", point.magnetic.degrees(), point.deviation->degrees(), toDegrees(*point.lowest_rad),
                toDegrees(*point.highest_rad));
        else
            put("%8.0f  %10s\n", printedHeading_deg(point.magnetic.degrees(), 0), "vanishes");
    }
    put("verdict: %s\n", nameOf(judge(there, answer.limits)));
    if (const auto again = swingAgainAfterMove(there, answer.limits))
        put("swing again: %s, %s\n", again->needed ? "yes" : "no", again->reason.english().c_str());
}

int tell(const PredictArguments& options, const PredictAnswer& answer)
{
    const PredictionContext context{answer.limits, swingAgainAfterMove(answer.there, answer.limits)};
    if (!options.json)
        warn(answer.there.warnings);
    if (!options.output.empty()) {
        const bool csv = options.output.kind == ".csv";
        if (const auto written = writeWholeFile(options.output.path, csv ? toCsv(answer.there) : toJson(answer.there, context) + "\n");
            !written)
            return fail(written.error());
        sayWritten(options.output);
    } else if (options.json) {
        put("%s\n", toJson(answer.there, context).c_str());
    } else {
        printTable(answer);
    }
    return kDone;
}

int predictCommand(const PredictArguments& options, const std::string& database)
{
    if (options.model.empty() == options.swings.empty()) {
        say("predict: expected a Model JSON or --swing ID, and not both");
        return kUsage;
    }
    const auto there = fieldThere(options);
    if (!there)
        return fail(there.error());
    if (!options.model.empty()) {
        const auto answer = fromModel(options.model, *there);
        return answer ? tell(options, *answer) : fail(answer.error());
    }
    const auto session = makeDrawingSession();
    const auto swings = placedSwings(database, options.swings);
    if (!swings)
        return fail(swings.error());
    const auto answer = fromSwings(*swings, options, *there);
    return answer ? tell(options, *answer) : fail(answer.error());
}

void addAssumed(CLI::App& command, AssumedIron& assumed)
{
    const auto add = [&](const char* name, double& size, double most, const char* what) {
        command.add_option(name, size, what)->capture_default_str()->check([most](const std::string& text) {
            const FileNumber number = readNumber(text);
            return number.fault == NumberFault::None && number.value > 0 && number.value <= most
                ? std::string()
                : inQuotes(text) + "; expected a number above 0, " + shortestNumber(most) + " at most";
        });
    };
    add("--assume-soft", assumed.verticalSoft, kMostAssumed.verticalSoft,
        "plausible size of the vertical soft iron c and f; this and the next: standard deviations");
    add("--assume-hard-nT", assumed.hardIron_nT, kMostAssumed.hardIron_nT, "plausible size of the hard iron P and Q [nT]");
    add("--assume-magnets-nT", assumed.compensator_nT, kMostAssumed.compensator_nT, "plausible size of the compensating magnets [nT]");
    add("--assume-one-cycle-deg", assumed.compassOneCycle_deg, kMostAssumed.compassOneCycle_deg,
        "plausible one-cycle error of the compass itself [deg]");
}

} // namespace

void addPredict(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<PredictArguments>();
    auto* command
        = app.add_subcommand("predict", "what a compass will read at another base: the curve expected there, with its uncertainty");
    addInputOption(*command, invocation, "MODEL.json", options->model, "a Model JSON");
    command->add_option("--swing", options->swings,
        "a swing of the database (record id or its beginning); several at different places tell hard from soft iron");
    command->add_option("--lat", options->latitude_deg, "geodetic latitude there [deg, north positive]")->required();
    command->add_option("--lon", options->longitude_deg, "longitude there [deg, east positive]")->required();
    command->add_option("--alt", options->altitude_m, "height above the WGS84 ellipsoid [m]")->capture_default_str();
    command->add_option("--date", options->date, "YYYY-MM-DD, or a year as 2026.5")->required();
    addAssumed(*command, options->assumed);
    auto* json = command->add_flag("--json", options->json, "one JSON object on standard output");
    addOutputOption(*command, invocation, "-o,--output", options->output, "the file to write", {".csv", ".json"})->excludes(json);
    addDatabaseOption(*command, invocation);
    command->callback(
        [options, &invocation] { invocation.action = [options, &invocation] { return predictCommand(*options, invocation.database); }; });
}

} // namespace lubberline::app
