#include "core/format/exchange/ExchangeParts.h"

#include "core/base/FileText.h"
#include "core/format/exchange/BenchJson.h"
#include "core/format/exchange/ModelJson.h"
#include "core/format/exchange/SwingJson.h"
#include "core/record/Ranges.h"

namespace lubberline::exchange {

namespace {

void readStates(JsonObject& object, BenchStates& states)
{
    object.objects("bench_states", [&](JsonObject& one) {
        one.only({"group", "state"});
        const std::string group = one.requiredText("group");
        if (!states.emplace(group, one.requiredText("state")).second)
            one.fault("group", {MARKED("core", "%1 is there twice; expected each group once"), inQuotes(group)});
    });
}

void writeStates(JsonWriter& json, const BenchStates& states)
{
    if (states.empty())
        return;
    json.beginArray("bench_states");
    for (const auto& [group, state] : states) {
        json.beginObject({}, true);
        json.text("group", group);
        json.text("state", state);
        json.end();
    }
    json.end();
}

} // namespace

FieldStamp readStamp(JsonObject& object)
{
    object.only({"model", "latitude_deg", "longitude_deg", "height_m", "date", "north_nT", "east_nT", "down_nT"});
    FieldStamp stamp;
    stamp.model = object.requiredText("model");
    stamp.place = {object.requiredNumber("latitude_deg", kLatitudeRange), object.requiredNumber("longitude_deg", kSignedAngleRange),
        object.requiredNumber("height_m", kHeightRange)};
    if (!object.has("date"))
        object.missing("date", MARKED("core", "a day of the calendar as YYYY-MM-DD"));
    stamp.date = object.date("date");
    if (object.has("date") && stamp.date.empty())
        object.fault("date", MARKED("core", "is empty; expected a day of the calendar as YYYY-MM-DD"));
    stamp.field = {object.requiredNumber("north_nT", kFieldRange), object.requiredNumber("east_nT", kFieldRange),
        object.requiredNumber("down_nT", kFieldRange)};
    return stamp;
}

void writeStamp(JsonWriter& json, std::string_view key, const FieldStamp& stamp)
{
    json.beginObject(key, true);
    json.text("model", stamp.model);
    json.number("latitude_deg", stamp.place.latitude_deg);
    json.number("longitude_deg", stamp.place.longitude_deg);
    json.number("height_m", stamp.place.height_m);
    json.text("date", stamp.date.text());
    json.number("north_nT", stamp.field.north_nT);
    json.number("east_nT", stamp.field.east_nT);
    json.number("down_nT", stamp.field.down_nT);
    json.end();
}

void readSensorParts(JsonObject& object, SensorRecord& sensor, FirstFault& fault)
{
    if (!object.has("model"))
        object.missing("model", MARKED("core", "a sensor model as in a Model JSON, without its field"));
    object.object("model", [&](JsonObject& model) {
        model.only({"soft_iron", "hard_iron_nT", "soft_constant_nT", "circuits", "misalignment_deg"});
        sensor.model = readSensorModel(model);
    });
    sensor.uncertainty = readCovariance(object);
    object.object("bench", [&](JsonObject& bench) { sensor.bench = readBench(bench, fault); });
    readStates(object, sensor.benchStates);
}

void writeSensorParts(JsonWriter& json, const SensorRecord& sensor)
{
    json.beginObject("model");
    writeSensorModel(json, sensor.model);
    json.end();
    writeCovariance(json, sensor.uncertainty);
    if (sensor.bench) {
        json.beginObject("bench");
        writeBench(json, *sensor.bench);
        json.end();
    }
    writeStates(json, sensor.benchStates);
}

} // namespace lubberline::exchange
