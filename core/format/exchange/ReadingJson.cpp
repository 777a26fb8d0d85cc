#include "core/format/exchange/ReadingJson.h"

#include "core/format/exchange/OptionalKeys.h"
#include "core/format/exchange/SwingJson.h"
#include "core/format/exchange/UtcJson.h"
#include "core/record/Ranges.h"

namespace lubberline {

namespace {

template <class Angle>
void angle(JsonWriter& json, std::string_view key, const std::optional<Angle>& value)
{
    if (value)
        json.number(key, value->degrees());
}

template <class Angle>
std::optional<Angle> heading(JsonObject& object, std::string_view key)
{
    const auto heading_deg = object.number(key, kHeadingRange);
    return heading_deg ? std::optional(Angle::fromDegrees(*heading_deg)) : std::nullopt;
}

std::vector<std::pair<std::string, std::string>> readExtra(JsonObject& object)
{
    std::vector<std::pair<std::string, std::string>> extra;
    object.objects("extra", [&](JsonObject& pair) {
        auto name = pair.requiredText("name");
        auto value = pair.text("value");
        pair.finish();
        extra.emplace_back(std::move(name), std::move(value));
    });
    return extra;
}

} // namespace

void writeReadingKeys(JsonWriter& json, const Reading& reading)
{
    numberIfAny(json, "nominal_deg", reading.nominal_deg);
    angle(json, "magnetic_heading_deg", reading.magnetic);
    angle(json, "compass_heading_deg", reading.compass);
    angle(json, "true_heading_deg", reading.trueHeading);
    numberIfAny(json, "pitch_deg", reading.pitch_deg);
    numberIfAny(json, "roll_deg", reading.roll_deg);
    writeRaw(json, reading.raw);
    textIfAny(json, "time_utc", reading.timeUtc);
    textIfAny(json, "note", reading.note);
    if (reading.exclusion)
        json.text("excluded", reading.exclusion->reason);
    if (!reading.extra.empty()) {
        json.beginArray("extra");
        for (const auto& [name, value] : reading.extra) {
            json.beginObject();
            json.text("name", name);
            json.text("value", value);
            json.end();
        }
        json.end();
    }
}

Reading readReading(JsonObject& object, bool withRaw)
{
    Reading reading;
    if (const auto nominal_deg = object.number("nominal_deg", kHeadingRange))
        reading.nominal_deg = wrap360(*nominal_deg);
    reading.magnetic = heading<MagneticHeading>(object, "magnetic_heading_deg");
    reading.compass = heading<CompassHeading>(object, "compass_heading_deg");
    reading.trueHeading = heading<TrueHeading>(object, "true_heading_deg");
    reading.pitch_deg = object.number("pitch_deg", kPitchRange);
    reading.roll_deg = object.number("roll_deg", kRollRange);
    if (withRaw) {
        reading.raw = readRaw(object);
        reading.timeUtc = utcText(object, "time_utc");
    }
    reading.note = object.text("note");
    if (auto reason = object.optionalText("excluded"))
        reading.exclusion = Exclusion{std::move(*reason)};
    reading.extra = readExtra(object);
    object.finish();
    return reading;
}

} // namespace lubberline
