#include "core/format/exchange/SwingJson.h"
#include "core/format/exchange/SignedContent.h"

#include <utility>

#include "core/format/exchange/OptionalKeys.h"
#include "core/format/exchange/RecordChoice.h"
#include "core/format/exchange/UtcJson.h"
#include "core/record/Ranges.h"

namespace lubberline {

namespace {

constexpr std::size_t kMostSigned = 64, kHashDigits = 64;

/// Of signatures by version 3 of the contents.
constexpr std::pair<const char*, std::string Signature::*> kOfThird[] = {{"file", &Signature::file}, {"file_head", &Signature::fileHead},
    {"record_head", &Signature::recordHead}, {"particulars", &Signature::particulars}, {"key", &Signature::key},
    {"public_key", &Signature::publicKey}, {"openpgp", &Signature::openPgp}};

void figures(JsonWriter& json, std::string_view key, const std::vector<double>& values)
{
    if (!values.empty())
        json.numbers(key, values);
}

std::vector<double> figures(JsonObject& object, std::string_view key)
{
    std::vector<double> values;
    object.array(key, [&](const nlohmann::json& value, const JsonPath&) {
        const double figure = value.is_number() ? value.get<double>() : std::numeric_limits<double>::infinity();
        if (std::abs(figure) <= kFigureRange.most)
            values.push_back(figure);
        else
            object.fault(key, MARKED("core", "holds what is no heading; expected numbers from -360 to 360"));
    });
    return values;
}

void writeSignatures(JsonWriter& json, const std::vector<Signature>& signatures)
{
    if (signatures.empty())
        return;
    json.beginArray("signatures");
    for (const auto& one : signatures) {
        json.beginObject({}, true);
        json.text("role", fileWord(one.role));
        json.text("name", one.name);
        textIfAny(json, "licence", one.licence);
        json.text("time_utc", one.timeUtc);
        json.text("hash", one.hash);
        if (one.contents != 1)
            json.integer("contents", one.contents);
        for (const auto& [key, field] : kOfThird)
            textIfAny(json, key, one.*field);
        json.end();
    }
    json.end();
}

std::vector<Signature> readSignatures(JsonObject& object)
{
    std::vector<Signature> signatures;
    object.objects("signatures", [&](JsonObject& one) {
        one.only({"role", "name", "licence", "time_utc", "hash", "contents", "file", "file_head", "record_head", "particulars", "key",
            "public_key", "openpgp"});
        Signature signature;
        signature.role = choice<SignatureRole>(one, "role");
        signature.name = one.requiredText("name");
        signature.licence = one.text("licence");
        signature.timeUtc = requiredUtcText(one, "time_utc");
        signature.hash = one.requiredText("hash");
        if (signature.hash.size() != kHashDigits || signature.hash.find_first_not_of("0123456789abcdef") != std::string::npos)
            one.fault("hash", MARKED("core", "is no SHA-256; expected 64 hexadecimal digits"));
        signature.contents = one.integer("contents", {1, kSignedContents}).value_or(1);
        for (const auto& [key, field] : kOfThird)
            signature.*field = one.longText(key);
        signatures.push_back(std::move(signature));
    });
    if (signatures.size() > kMostSigned)
        object.fault("signatures", MARKED("core", "are more than 64; expected a signed swing"));
    return signatures;
}

} // namespace

void writeRaw(JsonWriter& json, const RawFigures& raw)
{
    figures(json, "datum_read_deg", raw.datum_deg);
    figures(json, "astern_read_deg", raw.astern_deg);
    figures(json, "compass_read_deg", raw.compass_deg);
}

RawFigures readRaw(JsonObject& object)
{
    RawFigures raw;
    raw.datum_deg = figures(object, "datum_read_deg");
    raw.astern_deg = figures(object, "astern_read_deg");
    raw.compass_deg = figures(object, "compass_read_deg");
    return raw;
}

void writeSwingRecord(JsonWriter& json, const Swing& swing)
{
    textIfAny(json, "datum_read_out", swing.datum.readOut);
    textIfAny(json, "start_utc", swing.startUtc);
    textIfAny(json, "end_utc", swing.endUtc);
    textIfAny(json, "site_override", swing.siteOverride);
    textIfAny(json, "weather", swing.weather);
    textIfAny(json, "job_record", swing.job);
    textIfAny(json, "supersedes", swing.supersedes);
    textIfAny(json, "amendment", swing.amendment);
    if (swing.revision != 1)
        json.integer("revision", swing.revision);
    writeSignatures(json, swing.signatures);
}

void readSwingRecord(JsonObject& object, Swing& swing)
{
    swing.datum.readOut = object.text("datum_read_out");
    swing.startUtc = utcText(object, "start_utc");
    swing.endUtc = utcText(object, "end_utc");
    swing.siteOverride = object.text("site_override");
    swing.weather = object.text("weather");
    if (object.has("job_record"))
        swing.job = object.recordId("job_record");
    if (object.has("supersedes"))
        swing.supersedes = object.recordId("supersedes");
    swing.amendment = object.text("amendment");
    swing.revision = object.integer("revision", kRevisionRange).value_or(1);
    swing.signatures = readSignatures(object);
}

bool hasSwingRecord(const Swing& swing)
{
    return !swing.datum.readOut.empty() || !swing.startUtc.empty() || !swing.endUtc.empty() || !swing.siteOverride.empty()
        || !swing.weather.empty() || !swing.job.empty() || !swing.supersedes.empty() || !swing.amendment.empty() || swing.revision != 1
        || !swing.signatures.empty();
}

} // namespace lubberline
