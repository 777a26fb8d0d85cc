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

} // namespace

std::string toJson(const NmeaSwing& swing, const std::optional<Analysis>& analysis)
{
    Json json{{"lines", swing.lines}, {"sentences", swing.sentences}, {"bad_checksums", swing.badChecksums},
        {"without_checksum", swing.withoutChecksum}, {"other_lines", swing.otherLines}, {"pairs", swing.pairs.size()}, {"used", swing.used},
        {"compass_talker", swing.compassTalker}, {"variation_deg", swing.variation ? Json(swing.variation->degrees()) : Json()},
        {"variation_source", swing.variationSource}, {"readings", Json::array()}};
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
