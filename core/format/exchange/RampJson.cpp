#include "core/format/exchange/RampJson.h"

#include "core/format/exchange/Ranges.h"
#include "core/format/exchange/RecordChoice.h"
#include "core/format/json/JsonDocument.h"

namespace lubberline {

namespace {

constexpr NumberRange kMetres{-1e5, 1e5};
constexpr std::size_t kMostSigned = 64, kHashDigits = 64;

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
            object.fault(key, "holds what is no heading; expected numbers from -360 to 360");
    });
    return values;
}

/// A choice that is left out where it is the first.
template <class Choice>
void choiceIfAny(JsonWriter& json, std::string_view key, Choice value)
{
    if (value != Choice{})
        json.text(key, fileWord(value));
}

void writePoints(JsonWriter& json, const std::vector<SurveyPoint>& points)
{
    json.beginArray("survey");
    for (const auto& point : points) {
        json.beginObject({}, true);
        json.number("east_m", point.east_m);
        json.number("north_m", point.north_m);
        json.number("height_m", point.height_m);
        numberIfAny(json, "declination_deg", point.declination_deg);
        numberIfAny(json, "total_nT", point.total_nT);
        json.end();
    }
    json.end();
}

std::vector<SurveyPoint> readPoints(JsonObject& object)
{
    std::vector<SurveyPoint> points;
    object.objects("survey", [&](JsonObject& one) {
        one.only({"east_m", "north_m", "height_m", "declination_deg", "total_nT"});
        SurveyPoint point;
        point.east_m = one.requiredNumber("east_m", kMetres);
        point.north_m = one.requiredNumber("north_m", kMetres);
        point.height_m = one.requiredNumber("height_m", kMetres);
        point.declination_deg = one.number("declination_deg", kSignedAngleRange);
        point.total_nT = one.number("total_nT", {0, 1e6});
        points.push_back(point);
    });
    return points;
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
        json.end();
    }
    json.end();
}

std::vector<Signature> readSignatures(JsonObject& object)
{
    std::vector<Signature> signatures;
    object.objects("signatures", [&](JsonObject& one) {
        one.only({"role", "name", "licence", "time_utc", "hash"});
        Signature signature;
        signature.role = choice<SignatureRole>(one, "role");
        signature.name = one.requiredText("name");
        signature.licence = one.text("licence");
        signature.timeUtc = one.requiredText("time_utc");
        signature.hash = one.requiredText("hash");
        if (signature.hash.size() != kHashDigits || signature.hash.find_first_not_of("0123456789abcdef") != std::string::npos)
            one.fault("hash", "is no SHA-256; expected 64 hexadecimal digits");
        signatures.push_back(std::move(signature));
    });
    if (signatures.size() > kMostSigned)
        object.fault("signatures", "are more than 64; expected a signed swing");
    return signatures;
}

} // namespace

void textIfAny(JsonWriter& json, std::string_view key, const std::string& value)
{
    if (!value.empty())
        json.text(key, value);
}

void numberIfAny(JsonWriter& json, std::string_view key, std::optional<double> value)
{
    if (value)
        json.number(key, *value);
}

void writeInstrument(JsonWriter& json, const DatumInstrument& instrument)
{
    textIfAny(json, "record", instrument.record);
    textIfAny(json, "name", instrument.name);
    json.text("kind", fileWord(instrument.kind));
    textIfAny(json, "maker", instrument.maker);
    textIfAny(json, "serial_number", instrument.serialNumber);
    textIfAny(json, "calibration_due", instrument.calibrationDue);
    json.text("ahead", fileWord(instrument.ahead));
    json.boolean("gives_true", instrument.givesTrue);
    json.number("zero_deg", instrument.zero_deg);
    json.number("resolution_deg", instrument.resolution_deg);
    textIfAny(json, "note", instrument.note);
}

DatumInstrument readInstrument(JsonObject& object)
{
    DatumInstrument instrument;
    if (object.has("record"))
        instrument.record = object.recordId("record");
    instrument.name = object.text("name");
    instrument.kind = choice<DatumKind>(object, "kind");
    instrument.maker = object.text("maker");
    instrument.serialNumber = object.text("serial_number");
    instrument.calibrationDue = object.date("calibration_due");
    instrument.ahead = choice<SightingDirection>(object, "ahead");
    instrument.givesTrue = object.boolean("gives_true");
    instrument.zero_deg = object.requiredNumber("zero_deg", kFigureRange);
    instrument.resolution_deg = object.requiredNumber("resolution_deg", {1e-6, 90});
    instrument.note = object.text("note");
    object.finish();
    return instrument;
}

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

void writeRampParticulars(JsonWriter& json, const Swing& swing)
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

void readRampParticulars(JsonObject& object, Swing& swing)
{
    swing.datum.readOut = object.text("datum_read_out");
    swing.startUtc = object.text("start_utc");
    swing.endUtc = object.text("end_utc");
    swing.siteOverride = object.text("site_override");
    swing.weather = object.text("weather");
    if (object.has("job_record"))
        swing.job = object.recordId("job_record");
    if (object.has("supersedes"))
        swing.supersedes = object.recordId("supersedes");
    swing.amendment = object.text("amendment");
    swing.revision = object.integer("revision", {1, 10000}).value_or(1);
    swing.signatures = readSignatures(object);
}

bool hasRampParticulars(const Swing& swing)
{
    return !swing.datum.readOut.empty() || !swing.startUtc.empty() || !swing.endUtc.empty() || !swing.siteOverride.empty()
        || !swing.weather.empty() || !swing.job.empty() || !swing.supersedes.empty() || !swing.amendment.empty() || swing.revision != 1
        || !swing.signatures.empty();
}

void writeBase(JsonWriter& json, const Site& site)
{
    textIfAny(json, "owner", site.owner);
    choiceIfAny(json, "class", site.siteClass);
    textIfAny(json, "certificate", site.certificate);
    textIfAny(json, "certificate_expiry", site.certificateExpiry);
    numberIfAny(json, "painted_variation_deg", site.paintedVariation_deg);
    textIfAny(json, "painted_date", site.paintedDate);
    textIfAny(json, "survey_date", site.surveyDate);
    textIfAny(json, "surveyor", site.surveyor);
    textIfAny(json, "survey_instrument", site.surveyInstrument);
    if (!site.survey.empty())
        writePoints(json, site.survey);
}

void readBase(JsonObject& object, Site& site)
{
    site.owner = object.text("owner");
    site.siteClass = optionalChoice<SiteClass>(object, "class");
    site.certificate = object.text("certificate");
    site.certificateExpiry = object.date("certificate_expiry");
    site.paintedVariation_deg = object.number("painted_variation_deg", kSignedAngleRange);
    site.paintedDate = object.date("painted_date");
    site.surveyDate = object.date("survey_date");
    site.surveyor = object.text("surveyor");
    site.surveyInstrument = object.text("survey_instrument");
    site.survey = readPoints(object);
}

bool hasBase(const Site& site)
{
    return !site.owner.empty() || site.siteClass != SiteClass::None || !site.certificate.empty() || !site.certificateExpiry.empty()
        || site.paintedVariation_deg || !site.paintedDate.empty() || !site.surveyDate.empty() || !site.surveyor.empty()
        || !site.surveyInstrument.empty() || !site.survey.empty();
}

std::string writeSurvey(const std::vector<SurveyPoint>& points)
{
    JsonWriter json;
    json.beginObject();
    writePoints(json, points);
    json.end();
    return json.take();
}

Result<std::vector<SurveyPoint>> readSurvey(std::string_view text, const std::string& name)
{
    const auto document = parseJson(text, name, "the survey of a compass base");
    if (!document)
        return document.error();
    FirstFault fault(name);
    const JsonPath root{};
    JsonObject object(*document, root, fault);
    auto points = readPoints(object);
    object.finish();
    if (fault.error())
        return *fault.error();
    return points;
}

void writeDueRule(JsonWriter& json, const DueRule& rule)
{
    json.text("record", rule.record);
    json.text("name", rule.name);
    json.integer("months", rule.months);
    json.integer("grace_days", rule.graceDays);
    json.integer("warn_days", rule.warnDays);
    textIfAny(json, "document", rule.document);
    textIfAny(json, "issue", rule.issue);
    textIfAny(json, "type", rule.type);
}

DueRule readDueRule(JsonObject& object)
{
    DueRule rule;
    rule.record = object.recordId("record");
    rule.name = object.requiredText("name");
    rule.months = static_cast<int>(object.requiredNumber("months", {1, 1200}));
    rule.graceDays = object.integer("grace_days", {0, 36500}).value_or(0);
    rule.warnDays = object.integer("warn_days", {0, 36500}).value_or(0);
    rule.document = object.text("document");
    rule.issue = object.text("issue");
    if (object.has("type"))
        rule.type = object.recordId("type");
    object.finish();
    return rule;
}

void writeWaiver(JsonWriter& json, const Waiver& waiver)
{
    json.text("record", waiver.record);
    json.text("date", waiver.date);
    json.text("reason", waiver.reason);
    json.text("by", waiver.by);
}

Waiver readWaiver(JsonObject& object, const RecordId& event)
{
    Waiver waiver;
    waiver.record = object.recordId("record");
    waiver.event = event;
    waiver.date = object.date("date");
    waiver.reason = object.requiredText("reason");
    waiver.by = object.requiredText("by");
    object.finish();
    return waiver;
}

} // namespace lubberline
