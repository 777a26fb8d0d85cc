#include "core/format/results/DueJson.h"

#include "core/format/json/JsonWriter.h"

namespace lubberline {

namespace {

void textOrNull(JsonWriter& json, std::string_view key, const std::string& text)
{
    if (text.empty())
        json.null(key);
    else
        json.text(key, text);
}

void dayOrNull(JsonWriter& json, std::string_view key, Date day) { textOrNull(json, key, day.text()); }

void writeLine(JsonWriter& json, const DueLine& line)
{
    json.beginObject();
    json.text("type", line.compass.typeName);
    json.text("aircraft", line.compass.registration);
    json.text("compass", line.compass.compassName);
    json.text("compass_record", line.compass.compassRecord);
    json.text("state", nameOf(line.answer.state));
    dayOrNull(json, "last_signed", line.answer.lastSigned);
    dayOrNull(json, "next_by_calendar", line.answer.nextByCalendar);
    json.beginArray("flags");
    for (const auto& flag : line.answer.flags) {
        json.beginObject({}, true);
        json.text("state", nameOf(flag.state));
        dayOrNull(json, "since", flag.since);
        json.text("reason", flag.reason.english());
        textOrNull(json, "event", flag.event);
        if (flag.probability)
            json.number("probability", *flag.probability);
        json.end();
    }
    json.end();
    json.end();
}

} // namespace

std::string toJson(std::span<const DueLine> lines, std::span<const Message> warnings, Date today)
{
    JsonWriter json;
    json.beginObject();
    json.text("today", today.text());
    json.beginArray("compasses");
    for (const auto& line : lines)
        writeLine(json, line);
    json.end();
    json.beginArray("warnings");
    for (const auto& warning : warnings)
        json.text({}, warning.english());
    json.end();
    json.end();
    return json.take();
}

} // namespace lubberline
