#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>

#include "app/Console.h"
#include "app/ModelOptions.h"
#include "app/Outputs.h"
#include "app/QtSession.h"
#include "app/commands/Command.h"
#include "core/base/FileText.h"
#include "core/base/Normal.h"
#include "core/base/Number.h"
#include "core/base/OutputFile.h"
#include "core/base/WholeFile.h"
#include "core/format/exchange/ModelJson.h"
#include "core/format/results/MapJson.h"
#include "core/sensor/map/DeviationMap.h"
#include "ui/plots/base/PlotFile.h"
#include "ui/plots/map/MapPlotRendering.h"

namespace lubberline::app {

namespace {

constexpr QSize kPicture_px{1000, 680};
constexpr std::array kAxes{AttitudeAxis::Heading, AttitudeAxis::Pitch, AttitudeAxis::Roll};

struct MapArguments {
    std::string model, minus;
    Output output;
    std::vector<std::string> switches;
    AttitudeAxis x = AttitudeAxis::Heading;
    std::optional<AttitudeAxis> y; ///< pitch, or roll over pitch, when it is not given
    int columns = 361, rows = 181;
    std::optional<double> held_deg;                      ///< whichever axis is left
    std::array<std::optional<double>, 3> heldByName_deg; ///< the same, named
    std::optional<double> limit_deg;
    bool surface = false, json = false;
};

MapRequest requestOf(const MapArguments& options)
{
    const AttitudeAxis y = options.y.value_or(options.x == AttitudeAxis::Pitch ? AttitudeAxis::Roll : AttitudeAxis::Pitch);
    MapRequest request{{options.x, fullRange(options.x), options.columns}, {y, fullRange(y), options.rows}, options.held_deg.value_or(0.0)};
    if (const auto& named = options.heldByName_deg[static_cast<std::size_t>(heldAxis(request))])
        request.held_deg = *named;
    return request;
}

struct ModelMap {
    DeviationMap map;
    MapSource source;
};

/// At each point of the map, as the calibration of the model knows it.
std::vector<double> sigmaOf(const SensorSetup& setup, const MeridianField& field, const MapRequest& request)
{
    std::vector<double> sigma_rad;
    if (!setup.uncertainty)
        return sigma_rad;
    std::array<double, 3> angles_deg{};
    angles_deg[static_cast<std::size_t>(heldAxis(request))] = request.held_deg;
    for (int y = 0; y < request.y.nodes; ++y)
        for (int x = 0; x < request.x.nodes; ++x) {
            angles_deg[static_cast<std::size_t>(request.x.axis)] = request.x.at_deg(x);
            angles_deg[static_cast<std::size_t>(request.y.axis)] = request.y.at_deg(y);
            const Attitude attitude{MagneticHeading::fromDegrees(angles_deg[0]), toRadians(angles_deg[1]), toRadians(angles_deg[2])};
            sigma_rad.push_back(
                headingSigma_rad(setup.model, *setup.uncertainty, field, attitude).value_or(std::numeric_limits<double>::quiet_NaN()));
        }
    return sigma_rad;
}

/// The map of one Model JSON in its own field.
Result<ModelMap> mapOf(const std::string& path, const std::vector<std::string>& switches, const MapRequest& request)
{
    auto setup = readModelJsonFile(path);
    if (!setup)
        return setup.error();
    if (const auto switched = switchCircuits(setup->model, switches); !switched)
        return Error{switched.error().code, switched.error().message, nameOfInput(path)};
    const auto field = fieldOf(*setup);
    if (!field)
        return Error{field.error().code, {MARKED("app", "field: %1"), field.error().message}, nameOfInput(path)};
    ModelMap made;
    made.source = {std::filesystem::path(nameOfInput(path)).filename().string(), *field, {}, sigmaOf(*setup, *field, request)};
    for (const auto& circuit : setup->model.circuits)
        if (circuit.on)
            made.source.circuitsOn.push_back(circuit.name);
    computeMap(responseOf(setup->model), *field, request, made.map);
    return made;
}

struct MapAnswer {
    DeviationMap map;
    MapSource model;
    std::optional<MapSource> minus;
};

Result<MapAnswer> answerOf(const MapArguments& options)
{
    const MapRequest request = requestOf(options);
    auto map = mapOf(options.model, options.switches, request);
    if (!map)
        return map.error();
    if (options.minus.empty())
        return MapAnswer{std::move(map->map), map->source, {}};
    const auto other = mapOf(options.minus, {}, request);
    if (!other)
        return other.error();
    return MapAnswer{differenceOf(other->map, map->map), map->source, other->source};
}

/// "a.json (landing light on)".
std::string titleOf(const MapSource& source)
{
    std::string on;
    for (const auto& name : source.circuitsOn)
        on += (on.empty() ? "" : ", ") + name;
    return source.file + (on.empty() ? "" : " (" + on + " on)");
}

std::string titleOf(const MapAnswer& answer) { return titleOf(answer.model) + (answer.minus ? " − " + titleOf(*answer.minus) : ""); }

Result<void> writePicture(const MapAnswer& answer, const MapArguments& options)
{
    const auto session = makeDrawingSession();
    ui::MapPicture picture;
    picture.map = std::make_shared<const DeviationMap>(answer.map);
    picture.title = QString::fromStdString(titleOf(answer));
    picture.difference = answer.minus.has_value();
    picture.limit_deg = options.limit_deg;
    picture.extremes = extremesOf(answer.map);
    picture.vanishing = vanishingPlaces(answer.map);
    return ui::writePlotFile(
        QString::fromStdString(options.output.path), kPicture_px, picture.title,
        [&](QPainter& painter, const QRectF& target) {
            if (options.surface)
                ui::renderSurface(painter, target, picture);
            else
                ui::renderMap(painter, target, picture);
        },
        QString::fromStdString(options.output.kind.substr(1)));
}

Result<void> writeMap(const MapAnswer& answer, const MapArguments& options)
{
    if (options.output.kind == ".json")
        return writeWholeFile(options.output.path, toJson(answer.map, answer.model, answer.minus));
    if (options.output.kind == ".csv")
        return writeWholeFile(options.output.path, toCsv(answer.map));
    return writePicture(answer, options);
}

void printTable(const MapAnswer& answer)
{
    const MapRequest& request = answer.map.request;
    const char *x = nameOf(request.x.axis), *y = nameOf(request.y.axis);
    put("%s\n", titleOf(answer).c_str());
    put("%s (deg, east +), modelled, over %s and %s, %s %g deg, %d x %d points\n", answer.minus ? "difference of deviation" : "deviation",
        x, y, nameOf(heldAxis(request)), request.held_deg, request.x.nodes, request.y.nodes);
    put("H %.1f nT, dip %.2f deg\n\n", answer.model.field.horizontal_nT, toDegrees(answer.model.field.inclination_rad()));
    if (!answer.model.sigma_rad.empty()) {
        double largest = 0;
        for (const double sigma : answer.model.sigma_rad)
            largest = std::isfinite(sigma) ? std::max(largest, sigma) : largest;
        put("sure to %.2f deg (95 %%) or better, by the calibration of the model\n\n", kNormal95 * toDegrees(largest));
    }
    put("           %10s %10s  deviation\n", x, y);
    for (const auto& extreme : extremesOf(answer.map))
        put("  %s  %10.1f %10.1f  %+9.3f\n", extreme.maximum ? "maximum" : "minimum", extreme.x_deg, extreme.y_deg,
            toDegrees(extreme.deviation_rad));
    for (const auto& place : vanishingPlaces(answer.map))
        put("  vanishes %10.1f %10.1f   no horizontal field at the sensor\n", place.x_deg, place.y_deg);
}

int mapCommand(const MapArguments& options)
{
    // Before any memory is taken, or a file read.
    if (const auto checked = checkMapRequest(requestOf(options)); !checked)
        return fail(checked.error());
    const auto answer = answerOf(options);
    if (!answer)
        return fail(answer.error());
    if (!options.output.empty()) {
        if (const auto written = writeMap(*answer, options); !written)
            return fail(written.error());
        sayWritten(options.output);
    } else if (options.json) {
        putText(toJson(answer->map, answer->model, answer->minus));
    } else {
        printTable(*answer);
    }
    return kDone;
}

AttitudeAxis axisIn(const std::string& option, const std::string& text)
{
    for (const auto axis : kAxes)
        if (text == nameOf(axis))
            return axis;
    throw CLI::ValidationError(option + ": " + inQuotes(text) + " is no axis; expected heading, pitch or roll");
}

constexpr double kMostPoints = 1e9;

/// "361x181".
void takeSize(const std::string& text, MapArguments& options)
{
    const std::string_view size = text;
    const auto cross = std::min(size.find('x'), size.size());
    const auto points = [](std::string_view part) {
        const FileNumber number = readNumber(part);
        const bool whole = number.fault == NumberFault::None && number.value == std::floor(number.value);
        return whole && number.value >= 2 && number.value < kMostPoints ? static_cast<int>(number.value) : 0;
    };
    const int columns = points(size.substr(0, cross)), rows = points(size.substr(std::min(cross + 1, size.size())));
    if (columns == 0 || rows == 0)
        throw CLI::ValidationError("--size: " + inQuotes(text) + " is none; expected COLUMNSxROWS of at least 2x2, as in 361x181");
    options.columns = columns;
    options.rows = rows;
}

bool isPicture(const Output& output) { return !output.empty() && output.kind != ".csv" && output.kind != ".json"; }

/// What options say together: two different axes, the third one held, and a picture where one is styled.
void checkTogether(const MapArguments& options)
{
    const MapRequest request = requestOf(options);
    if (request.x.axis == request.y.axis)
        throw CLI::ValidationError(std::string("--x and --y are both ") + nameOf(options.x) + "; expected two of heading, pitch and roll");
    for (const auto axis : kAxes)
        if (options.heldByName_deg[static_cast<std::size_t>(axis)] && axis != heldAxis(request))
            throw CLI::ValidationError(std::string("--") + nameOf(axis) + ": " + nameOf(axis) + " is an axis of this map; expected --"
                + nameOf(heldAxis(request)));
    if (options.held_deg && options.heldByName_deg[static_cast<std::size_t>(heldAxis(request))])
        throw CLI::ValidationError(std::string("--held and --") + nameOf(heldAxis(request)) + " say the same; expected one of them");
    if ((options.surface || options.limit_deg) && !isPicture(options.output))
        throw CLI::ValidationError(
            std::string(options.surface ? "--surface" : "--limit") + " is for pictures; expected -o with a .png, .svg or .pdf file");
}

void addAxes(CLI::App& command, const std::shared_ptr<MapArguments>& options)
{
    command
        .add_option_function<std::string>(
            "--x", [options](const std::string& text) { options->x = axisIn("--x", text); }, "heading, pitch or roll")
        ->type_name("AXIS")
        ->default_str("heading");
    command
        .add_option_function<std::string>(
            "--y", [options](const std::string& text) { options->y = axisIn("--y", text); }, "heading, pitch or roll; not the same as --x")
        ->type_name("AXIS")
        ->default_str("pitch");
    command
        .add_option_function<std::string>(
            "--held", [options](const std::string& text) { options->held_deg = degreesIn("--held", text, -360, 360); },
            "the angle of the third axis [deg]")
        ->type_name("DEG")
        ->default_str("0");
    for (const auto axis : kAxes) {
        const std::string name = std::string("--") + nameOf(axis);
        const AxisRange range = fullRange(axis);
        command
            .add_option_function<std::string>(
                name,
                [options, axis, range, name](const std::string& text) {
                    options->heldByName_deg[static_cast<std::size_t>(axis)] = degreesIn(name, text, range.from_deg, range.to_deg);
                },
                std::string("the same, where ") + nameOf(axis) + " is the third [deg]")
            ->type_name("DEG");
    }
    command
        .add_option_function<std::string>(
            "--size", [options](const std::string& text) { takeSize(text, *options); }, "points along x and y")
        ->type_name("COLUMNSxROWS")
        ->default_str("361x181");
}

} // namespace

void addMap(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<MapArguments>();
    auto* command = app.add_subcommand("map", "deviation over two of heading, pitch and roll, from a sensor model");
    addInputOption(*command, invocation, "MODEL.json", options->model, "a Model JSON: field, soft and hard iron, circuits, misalignment")
        ->required();
    addAxes(*command, options);
    command->add_option("--switch", options->switches, "switch a circuit of MODEL.json")
        ->type_name("NAME=on|off")
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false);
    addInputOption(*command, invocation, "--minus", options->minus, "the difference to this Model JSON, switched as its file says")
        ->type_name("OTHER.json");
    command
        ->add_option_function<std::string>(
            "--limit", [options](const std::string& text) { options->limit_deg = degreesIn("--limit", text, 0.001, 180); },
            "in a picture: the contour of this |deviation| is heavy [deg]")
        ->type_name("DEG");
    command->add_flag("--surface", options->surface, "in a picture: the surface in 3D instead of the map");
    auto* json = command->add_flag("--json", options->json, "one JSON object on standard output");
    addOutputOption(*command, invocation, "-o,--output", options->output, "the file to write", {".png", ".svg", ".pdf", ".csv", ".json"})
        ->excludes(json);
    command->callback([options, &invocation] {
        checkTogether(*options);
        invocation.action = [options] { return mapCommand(*options); };
    });
}

} // namespace lubberline::app
