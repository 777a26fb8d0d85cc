#include "core/format/exchange/JobJson.h"

#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>

#include "core/format/exchange/InstrumentJson.h"
#include "core/format/exchange/OptionalKeys.h"
#include "core/format/exchange/RecordChoice.h"
#include "core/format/exchange/SwingJson.h"
#include "core/format/exchange/UtcJson.h"
#include "core/format/json/JsonWriter.h"
#include "core/format/json/ReadObject.h"
#include "core/record/Ranges.h"

namespace lubberline {

namespace {

constexpr NumberRange kStation{0, 1000};
constexpr Pattern kExpectedJob = MARKED("core", "a guided swing");

template <class Choice, std::size_t N>
Choice choose(JsonObject& object, std::string_view key, const std::array<std::string_view, N>& words)
{
    const std::string word = object.requiredText(key);
    const auto found = std::find(words.begin(), words.end(), word);
    if (found != words.end())
        return static_cast<Choice>(found - words.begin());
    std::string allowed;
    for (const auto& each : words)
        allowed += (allowed.empty() ? "" : ", ") + std::string(each);
    if (!word.empty())
        object.fault(key, {MARKED("core", "is \"%1\"; expected one of %2"), word, allowed});
    return {};
}

/// Every event writes its keys and reads them again; `what` tells which it is.
struct Writer {
    JsonWriter& json;
    void operator()(const job::Ticked& event) const { json.text("item", event.item), json.boolean("done", event.done); }
    void operator()(const job::InterferenceRead& event) const
    {
        json.number("heading_deg", event.heading_deg), json.text("load", event.load), json.number("off_deg", event.off_deg),
            json.number("on_deg", event.on_deg);
    }
    void operator()(const job::Prepared& event) const { textIfAny(json, "note", event.note); }
    void operator()(const job::ReadingTaken& event) const
    {
        json.integer("station", event.station);
        writeRaw(json, event.raw);
        json.number("magnetic_heading_deg", event.magnetic_deg);
        json.number("compass_heading_deg", event.compass_deg);
        textIfAny(json, "note", event.note);
    }
    void operator()(const job::ReadingRejected& event) const { json.integer("station", event.station), json.text("reason", event.reason); }
    void operator()(const job::StationSkipped& event) const { json.integer("station", event.station), json.text("reason", event.reason); }
    void operator()(const job::Adjusted& event) const
    {
        json.integer("station", event.station);
        json.text("control", fileWord(event.control));
        json.number("before_deg", event.before_deg), json.number("target_deg", event.target_deg), json.number("after_deg", event.after_deg);
        textIfAny(json, "note", event.note);
    }
    void operator()(const job::NotAdjusted& event) const
    {
        json.integer("station", event.station), json.text("control", fileWord(event.control)), json.text("reason", event.reason);
    }
    void operator()(const job::IndexRemoved& event) const
    {
        json.number("before_deg", event.before_deg), json.number("target_deg", event.target_deg), json.number("after_deg", event.after_deg);
    }
    void operator()(const job::IndexLeft& event) const { json.text("reason", event.reason); }
    void operator()(const job::Accepted& event) const { json.text("by", event.by), textIfAny(json, "note", event.note); }
    void operator()(const job::Faulted& event) const { json.text("cause", event.cause); }
    void operator()(const job::Mended& event) const { json.text("action", event.action); }
    void operator()(const job::Abandoned& event) const { json.text("reason", event.reason); }
    void operator()(const job::DatumChanged& event) const
    {
        json.beginObject("datum", true);
        writeInstrument(json, event.datum);
        json.end();
    }
};

constexpr std::array<std::string_view, std::variant_size_v<job::What>> kEvents{"ticked", "interference_read", "prepared", "reading_taken",
    "reading_rejected", "station_skipped", "adjusted", "not_adjusted", "index_removed", "index_left", "accepted", "faulted", "mended",
    "abandoned", "datum_changed"};

int station(JsonObject& object) { return static_cast<int>(object.requiredNumber("station", kStation)); }

/// In the order of job::What.
job::What readWhat(JsonObject& object, std::size_t kind)
{
    const auto number = [&](std::string_view key) { return object.requiredNumber(key, kFigureRange); };
    switch (kind) {
    case 0: {
        auto item = object.requiredText("item");
        return job::Ticked{std::move(item), object.boolean("done")};
    }
    case 1: {
        const double heading = object.requiredNumber("heading_deg", kHeadingRange);
        auto load = object.requiredText("load");
        const double off = number("off_deg");
        return job::InterferenceRead{heading, std::move(load), off, number("on_deg")};
    }
    case 2: return job::Prepared{object.text("note")};
    case 3: {
        job::ReadingTaken taken;
        taken.station = station(object);
        taken.raw = readRaw(object);
        taken.magnetic_deg = object.requiredNumber("magnetic_heading_deg", kHeadingRange);
        taken.compass_deg = object.requiredNumber("compass_heading_deg", kHeadingRange);
        taken.note = object.text("note");
        return taken;
    }
    case 4: return job::ReadingRejected{station(object), object.text("reason")};
    case 5: return job::StationSkipped{station(object), object.requiredText("reason")};
    case 6: {
        job::Adjusted adjusted;
        adjusted.station = station(object);
        adjusted.control = choice<Control>(object, "control");
        adjusted.before_deg = number("before_deg");
        adjusted.target_deg = number("target_deg");
        adjusted.after_deg = number("after_deg");
        adjusted.note = object.text("note");
        return adjusted;
    }
    case 7: {
        const int at = station(object);
        const auto control = choice<Control>(object, "control");
        return job::NotAdjusted{at, control, object.requiredText("reason")};
    }
    case 8: {
        const double before = number("before_deg"), target = number("target_deg");
        return job::IndexRemoved{before, target, number("after_deg")};
    }
    case 9: return job::IndexLeft{object.requiredText("reason")};
    case 10: {
        auto by = object.text("by");
        return job::Accepted{std::move(by), object.text("note")};
    }
    case 11: return job::Faulted{object.requiredText("cause")};
    case 12: return job::Mended{object.text("action")};
    case 13: return job::Abandoned{object.text("reason")};
    default: {
        job::DatumChanged changed;
        object.object("datum", [&](JsonObject& datum) { changed.datum = readInstrument(datum); });
        return changed;
    }
    }
}

void writeEventKeys(JsonWriter& json, const JobEvent& event)
{
    json.text("time_utc", event.timeUtc);
    json.text("what", kEvents[event.what.index()]);
    std::visit(Writer{json}, event.what);
}

JobEvent readEventKeys(JsonObject& object)
{
    JobEvent event;
    event.timeUtc = utcText(object, "time_utc");
    const auto kind = choose<std::size_t>(object, "what", kEvents);
    event.what = readWhat(object, kind);
    object.finish();
    return event;
}

void writePlanKeys(JsonWriter& json, const SwingJob& job)
{
    json.text("procedure", fileWord(job.plan.kind));
    json.integer("check_points", job.plan.checkPoints);
    json.number("resolution_deg", job.resolution_deg);
    json.beginObject("datum");
    writeInstrument(json, job.datum);
    json.end();
    json.beginArray("configurations", true);
    for (const auto& configuration : job.plan.configurations)
        json.text({}, configuration);
    json.end();
    json.beginArray("checklist");
    for (const auto& item : job.checklist)
        json.text({}, item);
    json.end();
}

std::vector<std::string> texts(JsonObject& object, std::string_view key)
{
    std::vector<std::string> all;
    object.array(key, [&](const nlohmann::json& value, const JsonPath&) {
        if (value.is_string())
            all.push_back(value.get<std::string>());
        else
            object.fault(key, MARKED("core", "holds what is no text"));
    });
    return all;
}

void readPlanKeys(JsonObject& object, SwingJob& job)
{
    job.plan.kind = choice<ProcedureKind>(object, "procedure");
    job.plan.checkPoints = object.integer("check_points", {8, 24}).value_or(8);
    if (job.plan.checkPoints != 8 && job.plan.checkPoints != 12 && job.plan.checkPoints != 24)
        object.fault("check_points", {MARKED("core", "is %1; expected 8, 12 or 24"), job.plan.checkPoints}), job.plan.checkPoints = 8;
    job.resolution_deg = object.requiredNumber("resolution_deg", {1e-6, 90});
    object.object("datum", [&](JsonObject& datum) { job.datum = readInstrument(datum); });
    job.plan.configurations = texts(object, "configurations");
    job.checklist = texts(object, "checklist");
}

} // namespace

std::string writeJobEvent(const JobEvent& event)
{
    JsonWriter json;
    json.beginObject({}, true);
    writeEventKeys(json, event);
    json.end();
    std::string text = json.take();
    text.pop_back(); // the line end
    return text;
}

Result<JobEvent> readJobEvent(std::string_view text, const std::string& name)
{
    return readJsonObject<JobEvent>(text, name, kExpectedJob, readEventKeys);
}

std::string writeJobPlan(const SwingJob& job)
{
    JsonWriter json;
    json.beginObject();
    writePlanKeys(json, job);
    json.end();
    return json.take();
}

Result<SwingJob> readJobPlan(std::string_view text, const std::string& name)
{
    return readJsonObject<SwingJob>(text, name, kExpectedJob, [](JsonObject& object) {
        SwingJob job;
        readPlanKeys(object, job);
        object.finish();
        return job;
    });
}

void writeJob(JsonWriter& json, const SwingJob& job)
{
    json.text("record", job.record);
    writePlanKeys(json, job);
    json.beginArray("events");
    for (const auto& event : job.events) {
        json.beginObject({}, true);
        writeEventKeys(json, event);
        json.end();
    }
    json.end();
}

SwingJob readJob(JsonObject& object)
{
    SwingJob job;
    job.record = object.recordId("record");
    readPlanKeys(object, job);
    object.objects("events", [&](JsonObject& event) { job.events.push_back(readEventKeys(event)); });
    object.finish();
    return job;
}

} // namespace lubberline
