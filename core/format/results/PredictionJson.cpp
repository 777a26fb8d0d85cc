#include "core/format/results/PredictionJson.h"

#include <nlohmann/json.hpp>

#include <cmath>

#include "core/base/Number.h"
#include "core/format/results/ResultFigures.h"

namespace lubberline {

namespace {

using Json = nlohmann::ordered_json;

Json degreesOrNull(const std::optional<double>& angle_rad) { return angle_rad ? Json(toTenDecimals(toDegrees(*angle_rad))) : Json(); }
std::optional<double> radiansOf(const std::optional<Deviation>& deviation)
{
    return deviation ? std::optional(deviation->radians()) : std::nullopt;
}

Json exactOrNull(const std::optional<ExactSmith>& exact)
{
    return exact ? Json{{"A", exact->A}, {"B", exact->B}, {"C", exact->C}, {"D", exact->D}, {"E", exact->E}} : Json();
}

Json estimateJson(const Estimate& estimate)
{
    return {{"value", estimate.value}, {"standard_error", estimate.standardError > 0 ? Json(estimate.standardError) : Json()}};
}

Json assumedOrNull(const std::optional<AssumedIron>& assumed)
{
    if (!assumed)
        return {};
    return {{"c_f", assumed->verticalSoft}, {"P_Q_nT", assumed->hardIron_nT}, {"compensator_nT", assumed->compensator_nT},
        {"compass_one_cycle_deg", assumed->compassOneCycle_deg}, {"degrees_of_freedom", assumed->degreesOfFreedom},
        {"in_words", sayAssumed(*assumed).english()}};
}

/// How sure the bounds are: of a model they are the curve itself.
Json boundsJson(const Prediction& prediction)
{
    return {{"probability", prediction.assumed ? Json(kBoundProbability) : Json()}, {"assumed_sizes", assumedOrNull(prediction.assumed)}};
}

Json changeOrNull(const std::optional<PredictedChange>& change)
{
    return change
        ? Json{{"expected_deg", toTenDecimals(toDegrees(change->expected_rad))}, {"bound_deg", toTenDecimals(toDegrees(change->bound_rad))}}
        : Json();
}

} // namespace

const char* nameOf(PredictedVerdict verdict)
{
    switch (verdict) {
    case PredictedVerdict::InLimits: return "in_limits";
    case PredictedVerdict::MayLeaveLimits: return "may_leave_limits";
    case PredictedVerdict::OutOfLimits: return "out_of_limits";
    case PredictedVerdict::NoLimit: break;
    }
    return "no_limit";
}

std::string toJson(const Prediction& prediction, const PredictionContext& context)
{
    Json json{{"basis", prediction.basis.english()},
        {"there",
            {{"H_nT", prediction.there.horizontal_nT}, {"Z_nT", prediction.there.down_nT},
                {"dip_deg", toDegrees(prediction.there.inclination_rad())}}},
        {"points", Json::array()}};
    for (const auto& point : prediction.points)
        json["points"].push_back({{"magnetic_heading_deg", toTenDecimals(point.magnetic.degrees())},
            {"deviation_deg", degreesOrNull(radiansOf(point.deviation))}, {"lowest_deg", degreesOrNull(point.lowest_rad)},
            {"highest_deg", degreesOrNull(point.highest_rad)}});
    json["exact"] = exactOrNull(prediction.exact);
    json["max_abs_deviation_deg"] = degreesOrNull(prediction.maxAbs_rad);
    json["max_abs_possible_deg"] = degreesOrNull(prediction.maxAbsPossible_rad);
    json["bounds"] = boundsJson(prediction);
    json["max_change"] = changeOrNull(prediction.change);
    json["limit_deg"] = context.limits && context.limits->maxDeviation_deg ? Json(*context.limits->maxDeviation_deg) : Json();
    json["verdict"] = nameOf(judge(prediction, context.limits));
    json["swing_again"]
        = context.swingAgain ? Json{{"needed", context.swingAgain->needed}, {"reason", context.swingAgain->reason.english()}} : Json();
    json["warnings"] = inEnglish(prediction.warnings);
    return json.dump(2);
}

std::string toJson(const IronSeparation& separation, std::span<const Knowledge> knowledge)
{
    Json json{{"c", estimateJson(separation.c)}, {"f", estimateJson(separation.f)}, {"P_nT", estimateJson(separation.P_nT)},
        {"Q_nT", estimateJson(separation.Q_nT)}, {"A", estimateJson(separation.A)}, {"D", estimateJson(separation.D)},
        {"E", estimateJson(separation.E)}, {"correlation", separation.correlation}, {"condition_number", separation.conditionNumber},
        {"chi_square", separation.chiSquare}, {"degrees_of_freedom", separation.degreesOfFreedom}, {"known", Json::array()},
        {"not_known", Json::array()}};
    for (const auto& each : knowledge)
        json[each.known ? "known" : "not_known"].push_back(each.what.english());
    json["warnings"] = inEnglish(separation.warnings);
    return json.dump(2);
}

std::string toCsv(const Prediction& prediction)
{
    const auto cell = [](const std::optional<double>& angle_rad) {
        return angle_rad ? shortestNumber(toTenDecimals(toDegrees(*angle_rad))) : std::string();
    };
    std::string csv = "magnetic_heading_deg,deviation_deg,lowest_deg,highest_deg\n";
    for (const auto& point : prediction.points)
        csv += shortestNumber(toTenDecimals(point.magnetic.degrees())) + ',' + cell(radiansOf(point.deviation)) + ','
            + cell(point.lowest_rad) + ',' + cell(point.highest_rad) + '\n';
    return csv;
}

} // namespace lubberline
