#include "core/format/results/SimulationJson.h"

#include <array>

#include <nlohmann/json.hpp>

namespace lubberline {

namespace {

using Json = nlohmann::ordered_json;

Json fieldJson(const MeridianField& field)
{
    return {{"H_nT", field.horizontal_nT}, {"Z_nT", field.down_nT}, {"dip_deg", toDegrees(field.inclination_rad())}};
}

Json exactJson(const ExactSmith& exact) { return {{"A", exact.A}, {"B", exact.B}, {"C", exact.C}, {"D", exact.D}, {"E", exact.E}}; }

Json approximateJson(const std::optional<ApproximateSmith>& smith)
{
    if (!smith)
        return {};
    return {{"A_deg", toDegrees(smith->A_rad)}, {"B_deg", toDegrees(smith->B_rad)}, {"C_deg", toDegrees(smith->C_rad)},
        {"D_deg", toDegrees(smith->D_rad)}, {"E_deg", toDegrees(smith->E_rad)}};
}

Json pointJson(const SensorReading& point)
{
    const auto& attitude = point.attitude;
    return {{"heading_deg", attitude.heading.degrees()}, {"pitch_deg", toDegrees(attitude.pitch_rad)},
        {"roll_deg", toDegrees(attitude.roll_rad)}, {"field_nT", {point.field_nT.x(), point.field_nT.y(), point.field_nT.z()}},
        {"horizontal_nT", point.horizontal_nT}, {"compass_heading_deg", point.compass ? Json(point.compass->degrees()) : Json()},
        {"deviation_deg", point.deviation ? Json(point.deviation->degrees()) : Json()}};
}

} // namespace

std::string toJson(const PoissonSmith& smith, const MeridianField& field)
{
    Json json{{"lambda", smith.lambda}, {"exact", exactJson(smith.exact)}, {"approximate", approximateJson(smith.approximate)}};
    json["why_no_approximate"] = smith.approximate ? Json() : Json(smith.whyNoApproximate.english());
    json["terms"] = Json::array();
    for (const auto& term : smith.terms)
        json["terms"].push_back(
            {{"coefficient", std::string(1, letterOf(term.coefficient))}, {"cause", term.cause.english()}, {"value", term.value}});
    json["field"] = fieldJson(field);
    return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string toJson(std::span<const SensorReading> points, const MeridianField& field)
{
    Json json{{"points", Json::array()}};
    for (const auto& point : points)
        json["points"].push_back(pointJson(point));
    json["field"] = fieldJson(field);
    return json.dump(2);
}

std::string toJson(const CompensatorResult& result, const AttitudeRange& range, double limit_deg)
{
    const auto setting = [](const CompensatorSetting& one) {
        return Json{{"magnets_nT", {one.magnets_nT.x(), one.magnets_nT.y(), one.magnets_nT.z()}}, {"soft_fore_aft", one.foreAft},
            {"soft_athwart", one.athwart}};
    };
    const auto residual = [](const RangeResidual& one) {
        return Json{{"largest_deg", one.largest_deg}, {"rms_deg", one.rms_deg}, {"heading_deg", one.heading_deg},
            {"pitch_deg", one.pitch_deg}, {"roll_deg", one.roll_deg}};
    };
    Json json{{"range", {{"pitch_deg", range.pitch_deg}, {"roll_deg", range.roll_deg}}}, {"before", residual(result.before)},
        {"level", {{"setting", setting(result.level)}, {"residual", residual(result.afterLevel)}}},
        {"best", {{"setting", setting(result.best)}, {"residual", residual(result.after)}}}, {"limit_deg", limit_deg},
        {"within_limit", result.after.largest_deg <= limit_deg}};
    json["at_end_of_reach"] = Json::array();
    constexpr std::array<const char*, 5> kParts{"magnet_x", "magnet_y", "magnet_z", "soft_fore_aft", "soft_athwart"};
    for (std::size_t i = 0; i < kParts.size(); ++i)
        if (result.atEnd[i])
            json["at_end_of_reach"].push_back(kParts[i]);
    json["warnings"] = Json::array();
    for (const Message& warning : result.warnings)
        json["warnings"].push_back(warning.english());
    return json.dump(2);
}

} // namespace lubberline
