#include <algorithm>
#include <memory>

#include "app/Console.h"
#include "app/Outputs.h"
#include "app/commands/Command.h"
#include "core/angle/Circle.h"
#include "core/angle/PrintedHeading.h"
#include "core/base/Number.h"
#include "core/base/OutputFile.h"
#include "core/base/WholeFile.h"
#include "core/earth/FieldModel.h"
#include "core/earth/VariationError.h"
#include "core/format/csv/SwingCsv.h"
#include "core/format/reference/ReferenceJson.h"
#include "core/format/reference/SunCsv.h"
#include "core/procedure/SunDatum.h"
#include "core/reference/Grid.h"
#include "core/reference/VariationTable.h"
#include "core/swing/SharedDoubts.h"

namespace lubberline::app {

namespace {

struct SunArguments {
    double latitude_deg = 0, longitude_deg = 0;
    std::string time, readings;
    Output output;
    SunSighting sighting;
    std::optional<double> variation_deg, variationError_deg;
    bool json = false;
};

void printBudget(const ErrorBudget& budget)
{
    for (const ErrorPart& part : budget.parts)
        put("  %-22s %8.3f deg\n", part.what.english().c_str(), part.size_deg);
    put("  %-22s %8.3f deg (one standard deviation)\n", "in all", budget.total_deg());
}

struct SunSwing {
    SwingRecord record;
    std::vector<double> errors_deg; ///< of the sun's azimuth at each reading
    std::vector<Message> warnings;
};

struct UsedVariation {
    Variation variation;
    double error_deg = 0; ///< one standard deviation; 0: not known
};

/// That of the day and place by the model, where it is not stated.
Result<UsedVariation> variationOf(const SunArguments& options, const Place& place, Date day)
{
    if (options.variation_deg)
        return UsedVariation{Variation::fromDegrees(*options.variation_deg), options.variationError_deg.value_or(0)};
    const auto model = defaultFieldModel(yearOf(day));
    if (!model)
        return model.error();
    const auto answer = fieldForCompass(*model, place, yearOf(day));
    if (!answer)
        return answer.error();
    return UsedVariation{answer->field.variation(), options.variationError_deg.value_or(variationError_deg(*answer))};
}

Result<SunSwing> swingBySun(const SunArguments& options, const Place& place)
{
    const auto readings = readSunCsvFile(options.readings);
    if (!readings)
        return readings.error();
    if (readings->empty())
        return Error{ErrorCode::InvalidInput, MARKED("app", "no reading; expected one at least"), nameOfInput(options.readings)};
    const Date day(std::chrono::year_month_day(std::chrono::floor<std::chrono::days>(readings->front().time)));
    const auto variation = variationOf(options, place, day);
    if (!variation)
        return variation.error();
    SunSwing made;
    Swing& swing = made.record.swing;
    swing.kind = SwingKind::Check;
    swing.date = day;
    swing.variation_deg = variation->variation.degrees();
    swing.datum.instrument = readings->front().ofShadow ? "shadow pin" : "astrocompass";
    std::vector<UtcTime> times;
    std::vector<TakenHeading> taken;
    for (const SunReading& read : *readings) {
        const SunPosition sun = sunAt(place, read.time);
        const ErrorBudget budget = sunBudget(place, read.time, options.sighting);
        const SunDoubts doubts = doubtsOf(sun, read.time, budget);
        if (doubts.none)
            return Error{
                ErrorCode::InvalidInput, {MARKED("app", "%1: %2"), read.timeText, doubts.warnings.front()}, nameOfInput(options.readings)};
        for (const Message& warning : doubts.warnings)
            made.warnings.push_back({MARKED("app", "%1: %2"), read.timeText, warning});
        made.errors_deg.push_back(budget.total_deg());
        Reading reading;
        reading.trueHeading = headingBySun(sun, read.bearing_deg, read.ofShadow);
        reading.magnetic = toMagnetic(*reading.trueHeading, variation->variation);
        reading.compass = read.compass;
        reading.timeUtc = read.timeText;
        reading.extra.emplace_back(kDatumErrorColumn, figureText(budget.total_deg(), 2));
        taken.push_back({*reading.trueHeading, read.compass, read.time});
        swing.readings.push_back(std::move(reading));
        times.push_back(read.time);
    }
    swing.sharedErrors = sharedBySun(place, taken, options.sighting, variation->error_deg);
    swing.datum.readOut = "the sun; up to " + figureText(*std::max_element(made.errors_deg.begin(), made.errors_deg.end()), 2)
        + " deg out (one standard deviation)";
    std::vector<double> deviations;
    for (const Reading& reading : swing.readings)
        deviations.push_back(deviationOf(*reading.magnetic, *reading.compass).degrees());
    if (auto doubt = sunDoubt(place, times, circularMean(deviations).mean_deg); !doubt.empty())
        made.warnings.push_back(std::move(doubt));
    return made;
}

int sunSwing(const SunArguments& options, const Place& place)
{
    const auto swing = swingBySun(options, place);
    if (!swing)
        return fail(swing.error());
    if (!options.json)
        warn(swing->warnings);
    if (!options.output.empty()) {
        if (const auto written = writeWholeFile(options.output.path, writeSwingCsv(swing->record)); !written)
            return fail(written.error());
        sayWritten(options.output);
    }
    if (options.json)
        put("%s\n", toJson(swing->record.swing, swing->errors_deg, swing->warnings).c_str());
    else if (options.output.empty())
        putText(writeSwingCsv(swing->record));
    return kDone;
}

int sunCommand(const SunArguments& options)
{
    const auto place = makePlace(options.latitude_deg, options.longitude_deg);
    if (!place)
        return fail(place.error());
    if (!options.readings.empty())
        return sunSwing(options, *place);
    const auto time = readUtcTime(options.time);
    if (!time)
        return fail(time.error());
    const SunPosition sun = sunAt(*place, *time);
    const ErrorBudget budget = sunBudget(*place, *time, options.sighting);
    const SunDoubts doubts = doubtsOf(sun, *time, budget);
    if (options.json) {
        put("%s\n", toJson(sun, budget, doubts).c_str());
        return kDone;
    }
    warn(doubts.warnings);
    put("azimuth %.3f deg true, %+.3f deg a minute; elevation %.3f deg\n", printedHeading_deg(sun.azimuth_deg, 3), sun.azimuthRate_deg_min,
        sun.elevation_deg);
    if (sun.shadowRatio > 0)
        put("the shadow points to %.3f deg true and is %.2f times as long as its pin\n", printedHeading_deg(sun.azimuth_deg + 180, 3),
            sun.shadowRatio);
    printBudget(budget);
    return kDone;
}

struct AlignmentArguments {
    std::string method;
    TransferGyro gyro;
    RunwayAlignment runway;
    SynchroTransmission synchro;
    SunArguments sun;
    double variation_deg = 0;
    bool json = false;
};

Result<ErrorBudget> budgetOf(const AlignmentArguments& options)
{
    if (options.method == "gyro")
        return lubberline::budgetOf(options.gyro);
    if (options.method == "runway")
        return lubberline::budgetOf(options.runway);
    if (options.method == "synchro")
        return lubberline::budgetOf(options.synchro);
    const auto place = makePlace(options.sun.latitude_deg, options.sun.longitude_deg);
    if (!place)
        return place.error();
    const auto time = readUtcTime(options.sun.time);
    if (!time)
        return time.error();
    return lubberline::budgetOf(*place, *time, options.sun.sighting);
}

int alignmentCommand(const AlignmentArguments& options)
{
    auto budget = budgetOf(options);
    if (!budget)
        return fail(budget.error());
    if (options.variation_deg > 0)
        budget = withVariation(std::move(*budget), options.variation_deg);
    if (options.json)
        put("%s\n", toJson(*budget).c_str());
    else
        printBudget(*budget);
    return kDone;
}

struct GridArguments {
    double latitude_deg = 0, longitude_deg = 0, heading_deg = 0, reference_deg = 0, step_deg = 5;
    std::string date;
    bool json = false;
};

int gridCommand(const GridArguments& options)
{
    const auto place = makePlace(options.latitude_deg, options.longitude_deg);
    if (!place)
        return fail(place.error());
    const auto year = decimalYear(options.date);
    if (!year)
        return fail(year.error());
    const auto model = defaultFieldModel(*year);
    if (!model)
        return fail(model.error());
    const auto answer = model->evaluate(*place, *year);
    const auto between = variationTableError(*model, *place, *year, options.step_deg, TableReading::Between);
    const auto nearest = variationTableError(*model, *place, *year, options.step_deg, TableReading::Nearest);
    for (const auto* error : {&between, &nearest})
        if (!*error)
            return fail(error->error());
    const Variation variation = answer->field.variation();
    const double grid = gridHeading_deg(TrueHeading::fromDegrees(options.heading_deg), *place, options.reference_deg);
    if (!options.json) {
        warn(answer->warnings);
        put("grid heading %.2f deg (true %.2f, convergence %+.2f, grid variation %+.2f deg)\n", grid, options.heading_deg,
            convergence_deg(*place, options.reference_deg), grivation_deg(variation, *place, options.reference_deg));
        put("variation %+.2f deg; of a table in steps of %g deg %+.2f read between entries (up to %.2f out in this cell), "
            "%+.2f by the nearest (up to %.2f out)\n",
            variation.degrees(), options.step_deg, between->tabled_deg, between->largest_deg, nearest->tabled_deg, nearest->largest_deg);
        return kDone;
    }
    std::string warnings;
    for (const Message& warning : answer->warnings)
        warnings += (warnings.empty() ? "\"" : ", \"") + warning.english() + "\"";
    const auto table = [](const TableError& error) {
        return "{\"variation_deg\": " + shortestNumber(error.tabled_deg) + ", \"error_deg\": " + shortestNumber(error.error_deg)
            + ", \"largest_error_deg\": " + shortestNumber(error.largest_deg) + "}";
    };
    put("{\"grid_heading_deg\": %s, \"convergence_deg\": %s, \"grid_variation_deg\": %s, \"variation_deg\": %s,\n"
        " \"table\": {\"step_deg\": %s, \"between\": %s, \"nearest\": %s},\n \"warnings\": [%s]}\n",
        shortestNumber(grid).c_str(), shortestNumber(convergence_deg(*place, options.reference_deg)).c_str(),
        shortestNumber(grivation_deg(variation, *place, options.reference_deg)).c_str(), shortestNumber(variation.degrees()).c_str(),
        shortestNumber(options.step_deg).c_str(), table(*between).c_str(), table(*nearest).c_str(), warnings.c_str());
    return kDone;
}

void addPlace(CLI::App& command, double& latitude_deg, double& longitude_deg, bool required)
{
    command.add_option("--lat", latitude_deg, "geodetic latitude [deg, north positive]")->required(required);
    command.add_option("--lon", longitude_deg, "longitude [deg, east positive]")->required(required);
}

void addSighting(CLI::App& command, SunSighting& sighting)
{
    const auto add = [&](const char* name, double& size, const char* what) {
        command.add_option(name, size, what)->check(CLI::Range(0.0, 1e6))->capture_default_str();
    };
    add("--clock-error-s", sighting.clock_s, "standard deviation of the clock [s]");
    add("--position-error-km", sighting.position_km, "of the position [km]");
    add("--plumb-error-deg", sighting.plumb_deg, "of pin or level from the vertical [deg]");
    add("--pointing-error-deg", sighting.pointing_deg, "of reading shadow or sight [deg]");
}

} // namespace

void addSun(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<SunArguments>();
    auto* command = app.add_subcommand("sun", "the sun's true azimuth, and what a shadow pin or astrocompass makes of it");
    addPlace(*command, options->latitude_deg, options->longitude_deg, true);
    command->add_option("--time", options->time, "YYYY-MM-DDTHH:MM:SSZ, or with an offset as +02:00");
    auto* readings = addInputOption(*command, invocation, "--readings", options->readings,
        "a swing by the sun: columns time_utc, compass_heading_deg, and shadow_bearing_deg or sun_bearing_deg from the nose");
    command->add_option("--variation", options->variation_deg, "with --readings [deg, east positive] (default: the model's)")
        ->check(CLI::Range(-180.0, 180.0))
        ->needs(readings);
    command
        ->add_option(
            "--variation-error-deg", options->variationError_deg, "of it (default: what the model states; 0 of one that is stated)")
        ->check(CLI::Range(0.0, 90.0))
        ->needs(readings);
    addOutputOption(*command, invocation, "-o,--output", options->output, "with --readings: write them as a Swing CSV", {".csv"})
        ->needs(readings);
    addSighting(*command, options->sighting);
    command->add_flag("--json", options->json, "one JSON object on standard output");
    command->callback([options, &invocation] {
        if (options->time.empty() == options->readings.empty())
            throw CLI::ValidationError("expected --time, or --readings, and not both");
        if (options->json && options->output.toStandardOutput())
            throw CLI::ValidationError("--json and -o - would both write to standard output; expected one of them");
        invocation.action = [options] { return sunCommand(*options); };
    });
}

void addAlignment(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<AlignmentArguments>();
    auto* command = app.add_subcommand("alignment", "what a heading is worth that is carried to an aircraft: the parts of its error");
    command->add_option("METHOD", options->method, "gyro (transfer gyro), runway, astro (the sun) or synchro")
        ->required()
        ->check(CLI::IsMember({"gyro", "runway", "astro", "synchro"}));
    const auto add = [&](const char* name, double& size, const char* what) {
        command->add_option(name, size, what)->check(CLI::Range(0.0, 1e6))->capture_default_str();
    };
    add("--setting-error-deg", options->gyro.setting_deg, "gyro: of setting it on the base");
    add("--reading-error-deg", options->gyro.reading_deg, "gyro: of reading it on the aircraft");
    add("--drift-deg-h", options->gyro.drift_deg_h, "gyro: free drift");
    add("--minutes", options->gyro.minutes, "gyro: since it was set");
    add("--published-error-deg", options->runway.published_deg, "runway: of its published direction");
    add("--off-centre-m", options->runway.offCentre_m, "runway: nose and tail from the line, each");
    add("--wheelbase-m", options->runway.wheelbase_m, "runway: between the points that are lined up");
    add("--one-cycle-deg", options->synchro.oneCycle_deg, "synchro: amplitude of the one-cycle error");
    add("--two-cycle-deg", options->synchro.twoCycle_deg, "synchro: amplitude of the two-cycle error");
    addPlace(*command, options->sun.latitude_deg, options->sun.longitude_deg, false);
    command->add_option("--time", options->sun.time, "astro: YYYY-MM-DDTHH:MM:SSZ");
    addSighting(*command, options->sun.sighting);
    add("--variation-error-deg", options->variation_deg, "of the variation, where a true heading is made magnetic");
    command->add_flag("--json", options->json, "one JSON object on standard output");
    command->callback([options, command, &invocation] {
        if (options->method == "astro" && (!command->count("--lat") || !command->count("--lon") || !command->count("--time")))
            throw CLI::ValidationError("astro needs --lat, --lon and --time");
        invocation.action = [options] { return alignmentCommand(*options); };
    });
}

void addGrid(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<GridArguments>();
    auto* command = app.add_subcommand("grid", "grid heading near a pole, and what a coarse table of variation misses");
    addPlace(*command, options->latitude_deg, options->longitude_deg, true);
    command->add_option("--true-heading", options->heading_deg, "true heading [deg]")->check(CLI::Range(0.0, 360.0))->required();
    command->add_option("--date", options->date, "YYYY-MM-DD, or a year as 2026.5")->required();
    command->add_option("--reference-meridian", options->reference_deg, "longitude whose meridian is grid north [deg, east positive]")
        ->check(CLI::Range(-180.0, 180.0))
        ->capture_default_str();
    command->add_option("--table-step", options->step_deg, "of the table of variation [deg]")
        ->check(CLI::Range(0.1, 30.0))
        ->capture_default_str();
    command->add_flag("--json", options->json, "one JSON object on standard output");
    command->callback([options, &invocation] { invocation.action = [options] { return gridCommand(*options); }; });
}

} // namespace lubberline::app
