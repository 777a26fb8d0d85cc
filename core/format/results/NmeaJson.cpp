#include "core/format/results/NmeaJson.h"

#include <nlohmann/json.hpp>

#include "core/format/results/AnalysisJson.h"

namespace lubberline {

namespace {

using Json = nlohmann::ordered_json;

Json orNull(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json pairJson(const NmeaPair& pair)
{
    return {{"compass_heading_deg", pair.compass.degrees()}, {"magnetic_heading_deg", pair.magnetic.degrees()},
        {"deviation_deg", deviationOf(pair.magnetic, pair.compass).degrees()},
        {"time_utc", pair.timeUtc.empty() ? Json() : Json(pair.timeUtc)}, {"speed_kt", orNull(pair.speed_kt)},
        {"turn_rate_deg_per_s", orNull(pair.turnRate_deg_s)}};
}

/// In words of the contract.
const char* toldBy(DelayTold told)
{
    switch (told) {
    case DelayTold::NoTurn: return "no turn";
    case DelayTold::OneWay: return "one-way turn";
    case DelayTold::TooNoisy: return "uneven headings";
    case DelayTold::BothWays: return "turns both ways";
    case DelayTold::VaryingRate: return "varying turn rate";
    }
    return "";
}

/// A log without times counts steps of its reference, which are no seconds.
Json delayJson(const NmeaSwing& swing)
{
    const NmeaDelay& delay = swing.delay;
    return {{"seconds", swing.timesTold ? orNull(delay.seconds) : Json()}, {"told_by", toldBy(delay.told)},
        {"standard_error_s", swing.timesTold ? Json(delay.standardError_s) : Json()},
        {"A_deg_per_s", swing.timesTold ? Json(delay.A_degPerSecond) : Json()},
        {"steps", swing.timesTold || !delay.seconds ? Json() : Json(*delay.seconds / swing.step_s)}, {"clockwise", delay.clockwise},
        {"counter_clockwise", delay.counterClockwise}};
}

Json windJson(const std::optional<NmeaWind>& wind)
{
    if (!wind)
        return {};
    return {{"from_deg", wind->from_deg()}, {"speed_kt", wind->speed_kt()}, {"standard_error_kt", wind->standardError_kt()},
        {"airspeed_kt", wind->airspeed_kt}, {"scatter_kt", wind->scatter_kt}, {"drift_deg", wind->drift_deg()},
        {"taken_out", wind->takenOut}};
}

Json directionsJson(const std::optional<NmeaDirections>& directions)
{
    if (!directions)
        return {};
    return {{"clockwise_A_deg", directions->clockwiseA_deg}, {"counter_clockwise_A_deg", directions->counterClockwiseA_deg},
        {"largest_difference_deg", directions->largestDifference_deg}};
}

} // namespace

std::string toJson(const NmeaSwing& swing, const std::optional<Analysis>& analysis)
{
    Json json{{"lines", swing.lines}, {"sentences", swing.sentences}, {"bad_checksums", swing.badChecksums},
        {"without_checksum", swing.withoutChecksum}, {"other_lines", swing.otherLines}, {"pairs", swing.pairs.size()}, {"used", swing.used},
        {"compass_talker", swing.compassTalker}, {"variation_deg", swing.variation ? Json(swing.variation->degrees()) : Json()},
        {"variation_source", swing.variationSource}, {"variation_of_model_deg", orNull(swing.variationOfModel_deg)},
        {"bad_headings", swing.badHeadings}, {"reference_source", swing.referenceSource},
        {"date", swing.date.empty() ? Json() : Json(swing.date.text())}, {"delay", delayJson(swing)}, {"wind", windJson(swing.wind)},
        {"directions", directionsJson(swing.directions)}, {"readings", Json::array()}};
    for (const auto& pair : swing.pairs)
        if (pair.used)
            json["readings"].push_back(pairJson(pair));
    const Json result = analysis ? Json::parse(toJson(*analysis)) : Json();
    for (const char* key : {"approximate", "exact", "harmonics", "summary"})
        json[key] = analysis ? result.at(key) : Json();
    json["warnings"] = inEnglish(swing.warnings);
    if (analysis)
        for (const auto& warning : analysis->warnings)
            json["warnings"].push_back(warning.english());
    return json.dump(2);
}

} // namespace lubberline
