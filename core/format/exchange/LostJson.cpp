#include "core/format/exchange/LostJson.h"

#include "core/format/exchange/JobJson.h"
#include "core/format/exchange/OptionalKeys.h"
#include "core/format/exchange/ReadingJson.h"
#include "core/format/json/ReadObject.h"

namespace lubberline {

namespace {

/// As far as a double counts in ones.
constexpr NumberRange kRowIds{1, 9007199254740992.0};
constexpr NumberRange kPlaces{0, 1e9};

LostStep readStep(JsonObject& object, std::string_view event)
{
    LostStep step;
    step.place = static_cast<std::size_t>(object.requiredNumber("place", kPlaces));
    auto read = readJobEvent(event, "recovery file");
    if (read)
        step.event = std::move(read.value());
    else
        object.fault("event", read.error().message);
    return step;
}

LostEntry readEntry(JsonObject& object)
{
    LostEntry entry;
    entry.database = object.requiredText("database");
    entry.swing = SwingId{static_cast<std::int64_t>(object.requiredNumber("swing", kRowIds))};
    entry.record = object.text("record");
    entry.subject = object.text("subject");
    entry.file = object.text("file");
    entry.timeUtc = object.text("time_utc");
    if (object.has("event")) {
        entry.what = readStep(object, object.text("event"));
        return entry;
    }
    LostReading lost;
    lost.row = static_cast<int>(object.requiredNumber("row", kPlaces));
    if (!object.has("reading"))
        object.missing("reading", MARKED("core", "a reading"));
    object.object("reading", [&](JsonObject& reading) { lost.reading = readReading(reading, true); });
    if (object.has("reading_id"))
        lost.id = ReadingId{static_cast<std::int64_t>(object.requiredNumber("reading_id", kRowIds))};
    object.object("before", [&](JsonObject& before) { lost.before = readReading(before, true); });
    entry.what = std::move(lost);
    return entry;
}

} // namespace

std::string writeLostEntry(const LostEntry& entry)
{
    JsonWriter json;
    json.beginObject({}, true);
    json.text("database", entry.database);
    json.integer("swing", entry.swing.value);
    json.text("record", entry.record);
    json.text("subject", entry.subject);
    textIfAny(json, "file", entry.file);
    textIfAny(json, "time_utc", entry.timeUtc);
    if (const auto* step = std::get_if<LostStep>(&entry.what)) {
        json.integer("place", static_cast<std::int64_t>(step->place));
        json.text("event", writeJobEvent(step->event));
    } else {
        const auto& lost = std::get<LostReading>(entry.what);
        json.integer("row", lost.row);
        if (lost.id.valid())
            json.integer("reading_id", lost.id.value);
        if (lost.before) {
            json.beginObject("before");
            writeReadingKeys(json, *lost.before);
            json.end();
        }
        json.beginObject("reading");
        writeReadingKeys(json, lost.reading);
        json.end();
    }
    json.end();
    return json.take();
}

Result<LostEntry> readLostEntry(std::string_view line)
{
    return readJsonObject<LostEntry>(line, "recovery file", MARKED("core", "a line of the recovery file"), readEntry);
}

} // namespace lubberline
