#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "app/Console.h"
#include "app/ModelOptions.h"
#include "app/Outputs.h"
#include "app/commands/Command.h"
#include "core/angle/PrintedHeading.h"
#include "core/base/FileText.h"
#include "core/base/Number.h"
#include "core/base/OutputFile.h"
#include "core/base/WholeFile.h"
#include "core/format/csv/SwingCsv.h"
#include "core/format/exchange/ModelJson.h"
#include "core/format/results/SimulationJson.h"

namespace lubberline::app {

namespace {

struct SimulateArguments {
    std::string model;
    Output output;
    std::vector<double> headings_deg;
    double pitch_deg = 0, roll_deg = 0;
    bool json = false;
};

/// More would be a map, which has a command of its own.
constexpr double kMostHeadings = 100'000;

std::vector<std::string> parts(const std::string& text, char separator)
{
    std::vector<std::string> found(1);
    for (const char c : text)
        if (c == separator)
            found.emplace_back();
        else
            found.back() += c;
    return found;
}

/// FROM:STEP:TO, both ends included, or a list with commas.
std::vector<double> takeHeadings(const std::string& text)
{
    const std::string option = "--headings";
    std::vector<double> headings_deg;
    const auto range = parts(text, ':');
    if (range.size() == 1) {
        for (const auto& one : parts(text, ','))
            headings_deg.push_back(degreesIn(option, one, 0, 360));
        return headings_deg;
    }
    if (range.size() != 3)
        throw CLI::ValidationError(
            option + ": " + inQuotes(text) + " is no range; expected FROM:STEP:TO, as in 0:15:345, or headings with commas");
    const double from_deg = degreesIn(option, range[0], 0, 360), step_deg = degreesIn(option, range[1], 0, 360),
                 to_deg = degreesIn(option, range[2], 0, 360);
    if (!(step_deg > 0) || to_deg < from_deg)
        throw CLI::ValidationError(option + ": " + inQuotes(text) + " leads nowhere; expected a STEP above 0 and TO not below FROM");
    // What rounding leaves of 0.1 + 0.1 + 0.1 must not lose the last heading.
    const double steps = std::floor((to_deg - from_deg) / step_deg + 1e-9);
    if (steps >= kMostHeadings)
        throw CLI::ValidationError(option + ": " + inQuotes(text) + " has more than 100000 headings; expected a wider STEP");
    for (int i = 0; i <= static_cast<int>(steps); ++i)
        headings_deg.push_back(std::round((from_deg + i * step_deg) * 1e9) / 1e9);
    return headings_deg;
}

void printTable(const std::vector<SensorReading>& points, const SimulateArguments& options)
{
    put("pitch %g deg (nose up +), roll %g deg (starboard wing down +)\n", options.pitch_deg, options.roll_deg);
    put("magnetic   compass    deviation  horizontal field\n   (deg)     (deg)    (deg, E+)   at sensor (nT)\n");
    for (const auto& point : points) {
        put("%8.2f  ", printedHeading_deg(point.attitude.heading.degrees(), 2));
        if (point.compass)
            put("%8.3f     %+8.3f  %15.1f\n", point.compass->degrees(), point.deviation->degrees(), point.horizontal_nT);
        else
            put("%8s     %8s  %15.1f\n", "-", "-", point.horizontal_nT);
    }
}

/// What vanishes has no heading, and so no row.
SwingRecord swingOf(const std::vector<SensorReading>& points, const SensorSetup& setup, const SimulateArguments& options)
{
    SwingRecord record;
    Swing& swing = record.swing;
    swing.kind = SwingKind::Calibration;
    swing.stage = SwingStage::NotStated;
    swing.datum.instrument = "simulation";
    swing.note = "simulated from " + std::filesystem::path(nameOfInput(options.model)).filename().string();
    if (const auto* place = std::get_if<PlaceAndDate>(&setup.field))
        swing.date = Date::read(place->date).value_or(Date()); // none for a decimal year
    for (const auto& point : points) {
        Reading reading;
        reading.magnetic = point.attitude.heading;
        reading.compass = point.compass;
        reading.pitch_deg = options.pitch_deg;
        reading.roll_deg = options.roll_deg;
        swing.readings.push_back(std::move(reading));
    }
    return record;
}

int writeFile(
    const std::vector<SensorReading>& points, const SensorSetup& setup, const MeridianField& field, const SimulateArguments& options)
{
    const bool none = std::none_of(points.begin(), points.end(), [](const SensorReading& point) { return point.compass.has_value(); });
    if (none && options.output.kind != ".json")
        return fail({ErrorCode::Numeric,
            {MARKED("app",
                 "the horizontal field at the sensor vanishes on every heading, which leaves no readings for %1; expected a compass that points"),
                options.output.path},
            nameOfInput(options.model)});
    const std::string content
        = options.output.kind == ".json" ? toJson(points, field) + "\n" : writeSwingCsv(swingOf(points, setup, options));
    if (const auto written = writeWholeFile(options.output.path, content); !written)
        return fail(written.error());
    sayWritten(options.output);
    return kDone;
}

void warnOfVanished(const std::vector<SensorReading>& points)
{
    for (const auto& point : points)
        if (!point.compass)
            warn({{MARKED("app", "the horizontal field at the sensor vanishes on heading %1: no compass heading there"),
                shortestNumber(point.attitude.heading.degrees())}});
}

int simulateCommand(const SimulateArguments& options)
{
    const auto setup = readModelJsonFile(options.model);
    if (!setup)
        return fail(setup.error());
    const auto field = fieldOf(*setup);
    if (!field)
        return fail({field.error().code, {MARKED("app", "field: %1"), field.error().message}, nameOfInput(options.model)});
    const SensorResponse response = responseOf(setup->model);
    std::vector<SensorReading> points;
    for (const double heading_deg : options.headings_deg)
        points.push_back(readSensor(
            response, *field, {MagneticHeading::fromDegrees(heading_deg), toRadians(options.pitch_deg), toRadians(options.roll_deg)}));
    warnOfVanished(points);
    if (!options.output.empty())
        return writeFile(points, *setup, *field, options);
    if (options.json)
        put("%s\n", toJson(points, *field).c_str());
    else
        printTable(points, options);
    return kDone;
}

} // namespace

void addSimulate(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<SimulateArguments>();
    options->headings_deg = takeHeadings("0:15:345");
    auto* command = app.add_subcommand("simulate", "what a sensor model reads on headings, at a pitch and a roll");
    addInputOption(*command, invocation, "MODEL.json", options->model, "a Model JSON: field, soft and hard iron, circuits, misalignment")
        ->required();
    command
        ->add_option_function<std::string>(
            "--headings", [options](const std::string& text) { options->headings_deg = takeHeadings(text); },
            "magnetic headings [deg]: FROM:STEP:TO, or a list with commas")
        ->default_str("0:15:345");
    command
        ->add_option_function<std::string>(
            "--pitch", [options](const std::string& text) { options->pitch_deg = degreesIn("--pitch", text, -90, 90); },
            "nose up positive [deg]")
        ->default_str("0");
    command
        ->add_option_function<std::string>(
            "--roll", [options](const std::string& text) { options->roll_deg = degreesIn("--roll", text, -180, 180); },
            "starboard wing down positive [deg]")
        ->default_str("0");
    auto* json = command->add_flag("--json", options->json, "one JSON object on standard output");
    addOutputOption(*command, invocation, "-o,--output", options->output, "write a Swing CSV, or the JSON", {".csv", ".json"})
        ->excludes(json);
    command->callback([options, &invocation] { invocation.action = [options] { return simulateCommand(*options); }; });
}

} // namespace lubberline::app
