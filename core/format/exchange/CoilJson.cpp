#include "core/format/exchange/CoilJson.h"

#include <algorithm>

#include "core/format/exchange/OptionalKeys.h"
#include "core/format/json/ReadObject.h"
#include "core/record/Ranges.h"

namespace lubberline {

namespace {

constexpr NumberRange kMeasured{-1e9, 1e9}; ///< counts of any converter

} // namespace

void writeCoilBench(JsonWriter& json, const CoilBench& bench)
{
    textIfAny(json, "record", bench.record);
    textIfAny(json, "date", bench.date);
    textIfAny(json, "serial_number", bench.serialNumber);
    textIfAny(json, "log", bench.log);
    textIfAny(json, "note", bench.note);
    if (bench.inCounts)
        json.boolean("in_counts", true);
    json.integer("count", static_cast<std::int64_t>(bench.readings.size()));
    const bool warm = !bench.temperature_c.empty();
    if (warm)
        json.boolean("temperature", true);
    json.beginArray("readings"); // ax, ay, az, bx, by, bz [, °C]
    for (std::size_t i = 0; i < bench.readings.size(); ++i) {
        std::vector<double> row(bench.readings[i].begin(), bench.readings[i].end());
        if (warm)
            row.push_back(bench.temperature_c[i]);
        json.numbers({}, row);
    }
    json.end();
}

CoilBench readCoilBench(JsonObject& object)
{
    CoilBench bench;
    if (object.has("record"))
        bench.record = object.recordId("record");
    bench.date = object.date("date");
    if (bench.date.empty())
        object.missing("date", MARKED("core", "a date (YYYY-MM-DD)"));
    bench.serialNumber = object.text("serial_number");
    bench.log = object.text("log");
    bench.note = object.text("note");
    bench.inCounts = object.boolean("in_counts");
    const auto count = static_cast<std::size_t>(object.integer("count", {8, double{kMostCoilReadings}}).value_or(0));
    if (!object.has("count") || !object.has("readings"))
        object.missing(object.has("count") ? "readings" : "count", MARKED("core", "the readings of the bench and their count"));
    const std::size_t columns = object.boolean("temperature") ? 7 : 6;
    std::vector<double> numbers(count * columns);
    object.numberRows("readings", numbers, columns, kMeasured);
    bench.readings.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(i * columns), 6, bench.readings[i].begin());
        if (columns == 7)
            bench.temperature_c.push_back(numbers[i * columns + 6]);
    }
    object.finish();
    return bench;
}

std::string writeCoilBenchJson(const CoilBench& bench)
{
    JsonWriter json;
    json.beginObject();
    writeCoilBench(json, bench);
    json.end();
    return json.take();
}

Result<CoilBench> readCoilBenchJson(std::string_view text, const std::string& name)
{
    return readJsonObject<CoilBench>(text, name, MARKED("core", "a coil bench"), readCoilBench);
}

} // namespace lubberline
