#include "core/format/exchange/BenchJson.h"

#include "core/angle/Angle.h"
#include "core/angle/WrittenDegrees.h"
#include "core/base/WholeFile.h"
#include "core/format/json/JsonWriter.h"
#include "core/format/json/ReadObject.h"
#include "core/iron/BenchCheck.h"
#include "core/record/Ranges.h"

namespace lubberline {

namespace {

constexpr Pattern kExpectedBench = MARKED("core", "a Bench JSON (parts and wires round a sensor)");

constexpr NumberRange kPlace{-kBenchReach_m, kBenchReach_m};
constexpr NumberRange kLength{1e-9, kBenchReach_m};

Eigen::Vector3d readVector(JsonObject& object, std::string_view key, NumberRange range)
{
    Eigen::Vector3d vector = Eigen::Vector3d::Zero();
    if (!object.has(key))
        object.missing(key, MARKED("core", "[x, y, z]"));
    object.numbers(key, {vector.data(), 3}, range);
    return vector;
}

Shape readShape(JsonObject& object)
{
    const auto kind = object.requiredText("shape", MARKED("core", "box, cylinder, ellipsoid or sphere"));
    if (kind == "box" || kind == "ellipsoid") {
        object.only({"name", "shape", "size_m", "susceptibility", "remanence_T", "coercivity_A_per_m", "group", "placements"});
        const Eigen::Vector3d size_m = readVector(object, "size_m", kLength);
        return kind == "box" ? Shape(Box{size_m}) : Shape(Ellipsoid{size_m});
    }
    if (kind == "cylinder") {
        object.only(
            {"name", "shape", "diameter_m", "length_m", "susceptibility", "remanence_T", "coercivity_A_per_m", "group", "placements"});
        return Cylinder{object.requiredNumber("diameter_m", kLength), object.requiredNumber("length_m", kLength)};
    }
    if (kind != "sphere")
        object.fault("shape", {MARKED("core", "is “%1”; expected box, cylinder, ellipsoid or sphere"), kind});
    object.only({"name", "shape", "diameter_m", "susceptibility", "remanence_T", "coercivity_A_per_m", "group", "placements"});
    return Sphere{object.requiredNumber("diameter_m", kLength)};
}

Placement readPlacement(JsonObject& object)
{
    object.only({"state", "centre_m", "roll_deg", "pitch_deg", "yaw_deg"});
    const auto angle_rad = [&](std::string_view key) { return toRadians(object.number(key, kFigureRange).value_or(0)); };
    return {
        object.text("state"), readVector(object, "centre_m", kPlace), angle_rad("roll_deg"), angle_rad("pitch_deg"), angle_rad("yaw_deg")};
}

FerrousPart readPart(JsonObject& object)
{
    FerrousPart part;
    part.shape = readShape(object);
    part.name = object.requiredText("name");
    part.susceptibility = object.number("susceptibility", {0, 1e9}).value_or(0);
    object.numbers("remanence_T", {part.remanence_T.data(), 3}, {-10, 10});
    part.coercivity_A_per_m = object.number("coercivity_A_per_m", {0, 1e8});
    part.group = object.text("group");
    object.objects("placements", [&](JsonObject& placement) { part.placements.push_back(readPlacement(placement)); });
    if (const auto checked = checkPart(part); !checked)
        object.fault("placements", checked.error().message);
    return part;
}

CurrentLoop readLoop(JsonObject& object)
{
    object.only({"kind", "centre_m", "normal", "diameter_m", "turns"});
    return {readVector(object, "centre_m", kPlace), readVector(object, "normal", kPlace), object.requiredNumber("diameter_m", kLength),
        object.integer("turns", {1, 1e6}).value_or(1)};
}

WirePath readWire(JsonObject& object, FirstFault& fault)
{
    object.only({"kind", "points_m"});
    if (!object.has("points_m"))
        object.missing("points_m", MARKED("core", "[[x, y, z], [x, y, z], …]"));
    WirePath path;
    object.array("points_m", [&](const nlohmann::json& value, const JsonPath& here) {
        Eigen::Vector3d point_m = Eigen::Vector3d::Zero();
        readNumbers(value, here, fault, {point_m.data(), 3}, kPlace);
        path.points_m.push_back(point_m);
    });
    return path;
}

BenchCircuit readCircuit(JsonObject& object, FirstFault& fault)
{
    object.only({"name", "current_A", "on", "conductors"});
    BenchCircuit circuit;
    circuit.name = object.requiredText("name");
    circuit.current_A = object.requiredNumber("current_A", {-1e6, 1e6});
    if (!object.has("on"))
        object.missing("on", MARKED("core", "true or false"));
    circuit.on = object.boolean("on");
    object.objects("conductors", [&](JsonObject& conductor) {
        const auto kind = conductor.requiredText("kind", MARKED("core", "loop or wire"));
        if (kind == "loop")
            circuit.conductors.emplace_back(readLoop(conductor));
        else if (kind == "wire")
            circuit.conductors.emplace_back(readWire(conductor, fault));
        else
            conductor.fault("kind", {MARKED("core", "is “%1”; expected loop or wire"), kind});
    });
    if (const auto checked = checkCircuit(circuit); !checked)
        object.fault("conductors", checked.error().message);
    return circuit;
}

void writeVector(JsonWriter& json, std::string_view key, const Eigen::Vector3d& vector) { json.numbers(key, {vector.data(), 3}); }

struct ShapeWriter {
    JsonWriter& json;
    void operator()(const Box& box) const { sized("box", box.size_m); }
    void operator()(const Ellipsoid& ellipsoid) const { sized("ellipsoid", ellipsoid.size_m); }
    void operator()(const Cylinder& cylinder) const
    {
        json.text("shape", "cylinder");
        json.number("diameter_m", cylinder.diameter_m);
        json.number("length_m", cylinder.length_m);
    }
    void operator()(const Sphere& sphere) const
    {
        json.text("shape", "sphere");
        json.number("diameter_m", sphere.diameter_m);
    }
    void sized(std::string_view kind, const Eigen::Vector3d& size_m) const
    {
        json.text("shape", kind);
        writeVector(json, "size_m", size_m);
    }
};

void writePlacement(JsonWriter& json, const Placement& placement)
{
    json.beginObject({}, true);
    if (!placement.state.empty())
        json.text("state", placement.state);
    writeVector(json, "centre_m", placement.centre_m);
    json.number("roll_deg", writtenDegrees(placement.roll_rad));
    json.number("pitch_deg", writtenDegrees(placement.pitch_rad));
    json.number("yaw_deg", writtenDegrees(placement.yaw_rad));
    json.end();
}

void writePart(JsonWriter& json, const FerrousPart& part)
{
    json.beginObject();
    json.text("name", part.name);
    std::visit(ShapeWriter{json}, part.shape);
    json.number("susceptibility", part.susceptibility);
    writeVector(json, "remanence_T", part.remanence_T);
    if (part.coercivity_A_per_m)
        json.number("coercivity_A_per_m", *part.coercivity_A_per_m);
    if (!part.group.empty())
        json.text("group", part.group);
    json.beginArray("placements");
    for (const auto& placement : part.placements)
        writePlacement(json, placement);
    json.end();
    json.end();
}

struct ConductorWriter {
    JsonWriter& json;
    void operator()(const CurrentLoop& loop) const
    {
        json.text("kind", "loop");
        writeVector(json, "centre_m", loop.centre_m);
        writeVector(json, "normal", loop.normal);
        json.number("diameter_m", loop.diameter_m);
        json.integer("turns", loop.turns);
    }
    void operator()(const WirePath& path) const
    {
        json.text("kind", "wire");
        json.beginArray("points_m", true);
        for (const auto& point_m : path.points_m)
            writeVector(json, {}, point_m);
        json.end();
    }
};

void writeCircuit(JsonWriter& json, const BenchCircuit& circuit)
{
    json.beginObject();
    json.text("name", circuit.name);
    json.number("current_A", circuit.current_A);
    json.boolean("on", circuit.on);
    json.beginArray("conductors");
    for (const auto& conductor : circuit.conductors) {
        json.beginObject({}, true);
        std::visit(ConductorWriter{json}, conductor);
        json.end();
    }
    json.end();
    json.end();
}

} // namespace

IronBench readBench(JsonObject& object, FirstFault& fault)
{
    object.only({"sensor_m", "parts", "circuits"});
    IronBench bench;
    bench.sensor_m = readVector(object, "sensor_m", kPlace);
    object.objects("parts", [&](JsonObject& part) { bench.parts.push_back(readPart(part)); });
    object.objects("circuits", [&](JsonObject& circuit) { bench.circuits.push_back(readCircuit(circuit, fault)); });
    if (const auto checked = checkBench(bench); !checked)
        object.fault("parts", checked.error().message);
    return bench;
}

Result<IronBench> readBenchJson(std::string_view text, const std::string& name)
{
    return readJsonObject<IronBench>(text, name, kExpectedBench, readBench);
}

Result<IronBench> readBenchJsonFile(const std::string& path)
{
    const auto text = readWholeFile(path, kExpectedBench);
    if (!text)
        return text.error();
    return readBenchJson(*text, nameOfInput(path));
}

void writeBench(JsonWriter& json, const IronBench& bench)
{
    writeVector(json, "sensor_m", bench.sensor_m);
    json.beginArray("parts");
    for (const auto& part : bench.parts)
        writePart(json, part);
    json.end();
    json.beginArray("circuits");
    for (const auto& circuit : bench.circuits)
        writeCircuit(json, circuit);
    json.end();
}

std::string writeBenchJson(const IronBench& bench)
{
    JsonWriter json;
    json.beginObject();
    writeBench(json, bench);
    json.end();
    return json.take();
}

} // namespace lubberline
