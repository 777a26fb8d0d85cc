#include "core/format/exchange/SiteJson.h"

#include "core/format/exchange/OptionalKeys.h"
#include "core/format/exchange/RecordChoice.h"
#include "core/format/json/ReadObject.h"
#include "core/record/Ranges.h"

namespace lubberline {

namespace {

constexpr NumberRange kMetres{-1e5, 1e5};

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

} // namespace

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
    return readJsonObject<std::vector<SurveyPoint>>(text, name, MARKED("core", "the survey of a compass base"), [](JsonObject& object) {
        auto points = readPoints(object);
        object.finish();
        return points;
    });
}

} // namespace lubberline
