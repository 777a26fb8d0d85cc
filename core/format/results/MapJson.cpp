#include "core/format/results/MapJson.h"

#include <cmath>

#include "core/base/Number.h"
#include "core/format/json/JsonWriter.h"
#include "core/format/results/ResultFigures.h"

namespace lubberline {

namespace {

void writeNodes(JsonWriter& json, const char* key, const MapAxis& axis)
{
    json.beginArray(key, true);
    for (int i = 0; i < axis.nodes; ++i)
        json.number({}, toTenDecimals(axis.at_deg(i)));
    json.end();
}

void writeRows(JsonWriter& json, const DeviationMap& map)
{
    json.beginArray("deviation_deg");
    for (int y = 0; y < map.request.y.nodes; ++y) {
        json.beginArray({}, true);
        for (int x = 0; x < map.request.x.nodes; ++x) {
            const std::size_t at = map.index(x, y);
            if (map.defined[at])
                json.number({}, toTenDecimals(toDegrees(map.deviation_rad[at])));
            else
                json.null({});
        }
        json.end();
    }
    json.end();
}

void writeSigma(JsonWriter& json, const DeviationMap& map, const std::vector<double>& sigma_rad)
{
    json.beginArray("standard_deviation_deg");
    for (int y = 0; y < map.request.y.nodes; ++y) {
        json.beginArray({}, true);
        for (int x = 0; x < map.request.x.nodes; ++x)
            if (const double sigma = sigma_rad[map.index(x, y)]; std::isfinite(sigma))
                json.number({}, toTenDecimals(toDegrees(sigma)));
            else
                json.null({});
        json.end();
    }
    json.end();
}

void writeExtremes(JsonWriter& json, const DeviationMap& map)
{
    json.beginArray("extremes");
    for (const auto& extreme : extremesOf(map)) {
        json.beginObject({}, true);
        json.text("kind", extreme.maximum ? "maximum" : "minimum");
        json.number("x_deg", toTenDecimals(extreme.x_deg));
        json.number("y_deg", toTenDecimals(extreme.y_deg));
        json.number("deviation_deg", toTenDecimals(toDegrees(extreme.deviation_rad)));
        json.end();
    }
    json.end();
}

void writeVanishing(JsonWriter& json, const DeviationMap& map)
{
    json.beginArray("vanishing");
    for (const auto& place : vanishingPlaces(map)) {
        json.beginObject({}, true);
        json.number("x_deg", toTenDecimals(place.x_deg));
        json.number("y_deg", toTenDecimals(place.y_deg));
        json.end();
    }
    json.end();
}

void writeSource(JsonWriter& json, const char* key, const MapSource& source)
{
    json.beginObject(key, true);
    json.text("file", source.file);
    json.number("H_nT", source.field.horizontal_nT);
    json.number("Z_nT", source.field.down_nT);
    json.number("dip_deg", toTenDecimals(toDegrees(source.field.inclination_rad())));
    json.beginArray("circuits_on");
    for (const auto& name : source.circuitsOn)
        json.text({}, name);
    json.end();
    json.end();
}

} // namespace

const char* nameOf(AttitudeAxis axis) { return axis == AttitudeAxis::Heading ? "heading" : axis == AttitudeAxis::Pitch ? "pitch" : "roll"; }

std::string toJson(const DeviationMap& map, const MapSource& model, const std::optional<MapSource>& minus)
{
    const MapRequest& request = map.request;
    JsonWriter json;
    json.beginObject();
    json.text("kind", "modelled");
    json.text("x", nameOf(request.x.axis));
    json.text("y", nameOf(request.y.axis));
    json.beginObject("held", true);
    json.text("axis", nameOf(heldAxis(request)));
    json.number("deg", request.held_deg);
    json.end();
    writeSource(json, "model", model);
    if (minus)
        writeSource(json, "minus", *minus);
    else
        json.null("minus");
    writeExtremes(json, map);
    writeVanishing(json, map);
    writeNodes(json, "x_deg", request.x);
    writeNodes(json, "y_deg", request.y);
    writeRows(json, map);
    if (!model.sigma_rad.empty())
        writeSigma(json, map, model.sigma_rad);
    json.end();
    return json.take();
}

std::string toCsv(const DeviationMap& map)
{
    const MapRequest& request = map.request;
    std::string csv = "heading_deg,pitch_deg,roll_deg,deviation_deg\n";
    for (int y = 0; y < request.y.nodes; ++y)
        for (int x = 0; x < request.x.nodes; ++x) {
            double angles[3] = {};
            angles[static_cast<int>(heldAxis(request))] = request.held_deg;
            angles[static_cast<int>(request.x.axis)] = request.x.at_deg(x);
            angles[static_cast<int>(request.y.axis)] = request.y.at_deg(y);
            for (const double angle : angles)
                csv += shortestNumber(toTenDecimals(angle)) + ',';
            const std::size_t at = map.index(x, y);
            csv += (map.defined[at] ? shortestNumber(toTenDecimals(toDegrees(map.deviation_rad[at]))) : std::string()) + '\n';
        }
    return csv;
}

} // namespace lubberline
