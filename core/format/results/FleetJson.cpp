#include "core/format/results/FleetJson.h"

#include <nlohmann/json.hpp>

#include <cmath>

#include "core/format/results/FleetFigures.h"
#include "core/format/results/ResultFigures.h"

namespace lubberline {

namespace {

using Json = nlohmann::ordered_json;

Json figureOrNull(const std::optional<double>& value) { return value && std::isfinite(*value) ? Json(toTenDecimals(*value)) : Json(); }
Json dayOrNull(const std::optional<int>& day) { return day ? Json(dateOfDay(*day)) : Json(); }
Json intervalJson(const Interval& interval) { return Json::array({figureOrNull(interval.low), figureOrNull(interval.high)}); }

Json selectionJson(const FleetCounts& counts)
{
    Json json{{"aircraft", counts.aircraft}, {"compasses", counts.compasses}, {"swings", counts.swings}, {"used", counts.used},
        {"left_out", Json::array()}};
    for (const auto& left : counts.leftOut)
        json["left_out"].push_back({{"reason", left.reason}, {"swings", left.swings}});
    return json;
}

Json patternJson(const PopulationPattern& pattern)
{
    Json json = Json::array();
    for (const auto& point : pattern.points)
        json.push_back({{"heading_deg", toTenDecimals(point.heading_deg)}, {"aircraft", point.units},
            {"mean_deg", figureOrNull(point.mean_deg)}, {"standard_deviation_deg", figureOrNull(point.standardDeviation_deg)},
            {"between_aircraft_deg", figureOrNull(point.between_deg)}, {"percentile_5_deg", figureOrNull(point.percentile5_deg)},
            {"percentile_50_deg", figureOrNull(point.percentile50_deg)}, {"percentile_95_deg", figureOrNull(point.percentile95_deg)},
            {"moved_along_own_curve", point.moved}});
    return json;
}

Json coefficientsJson(const PopulationPattern& pattern, const FleetSwings& fleet)
{
    Json json = Json::object();
    for (std::size_t c = 0; c < kCoefficientCount; ++c) {
        const auto& spread = pattern.coefficients[c];
        Json outliers = Json::array();
        for (const auto& outlier : spread.outliers) {
            const auto& compass = compassAt(fleet, fleet.swings[outlier.row].compass);
            outliers.push_back({{"aircraft", compass.aircraft}, {"compass", compass.compass},
                {"value_deg", toTenDecimals(outlier.value_deg)}, {"robust_z", toTenDecimals(outlier.distance)}});
        }
        json[letterAt(c)] = {{"mean_deg", figureOrNull(spread.mean_deg)}, {"standard_error_deg", figureOrNull(spread.standardError_deg)},
            {"standard_deviation_deg", figureOrNull(spread.standardDeviation_deg)},
            {"between_aircraft_deg", figureOrNull(spread.between_deg)}, {"aircraft", spread.units},
            {"percentile_5_deg", figureOrNull(spread.percentile5_deg)}, {"percentile_50_deg", figureOrNull(spread.percentile50_deg)},
            {"percentile_95_deg", figureOrNull(spread.percentile95_deg)}, {"outliers", std::move(outliers)}};
    }
    return json;
}

Json ordersJson(const std::vector<HarmonicOrder>& orders)
{
    Json json = Json::array();
    for (const auto& order : orders)
        json.push_back({{"order", order.order}, {"sin_deg", toTenDecimals(toDegrees(order.sin_rad))},
            {"cos_deg", toTenDecimals(toDegrees(order.cos_rad))}, {"amplitude_deg", toTenDecimals(toDegrees(order.amplitude_rad()))},
            {"phase_deg", toTenDecimals(toDegrees(order.phase_rad()))}});
    return json;
}

Json groupsJson(const std::vector<ExceedanceGroup>& groups, const char* name)
{
    Json json = Json::array();
    for (const auto& group : groups)
        json.push_back({{name, group.name}, {"pairs", group.pairs}, {"exceeded", group.exceeded},
            {"share", toTenDecimals(static_cast<double>(group.exceeded) / static_cast<double>(group.pairs))},
            {"share_95", intervalJson(group.share95)}});
    return json;
}

Json exceedanceJson(const Exceedance& exceedance)
{
    Json json{{"limit_deg", figureOrNull(exceedance.limit_deg)}, {"pairs", exceedance.pairs}, {"exceeded", exceedance.exceeded},
        {"share",
            exceedance.pairs > 0 ? Json(toTenDecimals(static_cast<double>(exceedance.exceeded) / static_cast<double>(exceedance.pairs)))
                                 : Json()},
        {"share_95", exceedance.share95 ? intervalJson(*exceedance.share95) : Json()},
        {"expected_share", figureOrNull(exceedance.expectedShare)}, {"three_sigma_share", figureOrNull(exceedance.threeSigmaShare)},
        {"headings", Json::array()}, {"pairs_without_limit", exceedance.withoutLimit}};
    for (const auto& heading : exceedance.headings)
        json["headings"].push_back({{"heading_deg", toTenDecimals(heading.heading_deg)},
            {"expected_share", toTenDecimals(heading.expectedShare)}, {"three_sigma_share", toTenDecimals(heading.threeSigmaShare)}});
    json["by_type"] = groupsJson(exceedance.byType, "type");
    json["by_site"] = groupsJson(exceedance.bySite, "site");
    json["by_crew"] = groupsJson(exceedance.byCrew, "crew");
    return json;
}

Json varianceJson(const CoefficientVariance& variance)
{
    Json json{{"aircraft_deg2", nullptr}, {"crew_deg2", nullptr}, {"site_deg2", nullptr}, {"residual_deg2", nullptr},
        {"interval_95", Json::object()}, {"mean_deg", nullptr}, {"mean_standard_error_deg", nullptr}, {"not_told", Json::array()}};
    if (!variance.report) {
        if (!variance.why.empty())
            json["not_told"].push_back(variance.why.english());
        return json;
    }
    const auto& report = *variance.report;
    const auto add = [&](const char* name, const std::optional<VarianceComponent>& component) {
        if (!component)
            return;
        json[std::string(name) + "_deg2"] = toTenDecimals(component->variance);
        json["interval_95"][std::string(name) + "_deg2"] = intervalJson(component->interval);
    };
    add("aircraft", report.aircraft);
    add("crew", report.crew);
    add("site", report.site);
    add("residual", report.residual);
    json["mean_deg"] = toTenDecimals(report.mean);
    json["mean_standard_error_deg"] = toTenDecimals(report.meanStandardError);
    for (const auto& words : report.notTold)
        json["not_told"].push_back(words.english());
    return json;
}

Json groupOfAJson(const std::vector<GroupOfA>& groups, const char* name)
{
    Json json = Json::array();
    for (const auto& group : groups)
        json.push_back({{name, group.name}, {"swings", group.swings}, {"mean_A_deg", toTenDecimals(group.meanA_deg)},
            {"mean_abs_A_deg", toTenDecimals(group.meanAbsA_deg)}, {"mean_abs_A_95_deg", intervalJson(group.meanAbsA95_deg)},
            {"compasses", group.aircraft}});
    return json;
}

Json sideJson(const SideOfDate& side)
{
    return {{"swings", side.swings}, {"mean_A_deg", toTenDecimals(side.meanA_deg)}, {"mean_abs_A_deg", toTenDecimals(side.meanAbsA_deg)},
        {"standard_deviation_A_deg", toTenDecimals(side.standardDeviation_deg)}};
}

Json trainingJson(const std::optional<DateComparison>& comparison)
{
    if (!comparison)
        return {};
    Json json{{"date", dateOfDay(comparison->day)}, {"after", dateOfDay(comparison->lastBefore_day)}, {"given", comparison->given},
        {"before_it", sideJson(comparison->before)}, {"from_it_on", sideJson(comparison->after)},
        {"change_share", toTenDecimals(comparison->change)}, {"change_share_95", intervalJson(comparison->change95)}, {"p", comparison->p},
        {"compasses_on_both_sides", comparison->compassesOnBothSides}, {"change_share_within", figureOrNull(comparison->changeWithin)},
        {"words", Json::array()}};
    for (const auto& words : inWords(*comparison))
        json["words"].push_back(words.english());
    return json;
}

Json chartsJson(const std::optional<ChartWatch>& charts)
{
    if (!charts)
        return {};
    Json json{{"centre_A_deg", toTenDecimals(charts->centre_deg)}, {"sigma_A_deg", toTenDecimals(charts->sigma_deg)},
        {"ewma",
            {{"weight", charts->limits.weight}, {"width", charts->limits.width},
                {"run_length_without_shift", toTenDecimals(charts->ewmaFalseAlarmAfter)},
                {"run_length_at_one_sigma", toTenDecimals(charts->ewmaShiftFoundAfter)}}},
        {"cusum",
            {{"reference", charts->limits.reference}, {"decision", charts->limits.decision},
                {"run_length_without_shift", toTenDecimals(charts->cusumFalseAlarmAfter)},
                {"run_length_at_one_sigma", toTenDecimals(charts->cusumShiftFoundAfter)}}},
        {"alarms", Json::array()}};
    for (const auto& alarm : charts->alarms)
        json["alarms"].push_back({{alarm.crew ? "crew" : "site", alarm.name}, {"chart", alarm.cusum ? "cusum" : "ewma"},
            {"date", dateOfDay(alarm.day)}, // these two as ever, for scripts that read them; the next four tell more
            {"ewma", alarm.ewma}, {"cusum", alarm.cusum}, {"first_date", dateOfDay(alarm.day)}, {"last_date", dateOfDay(alarm.last_day)},
            {"average_A_deg", toTenDecimals(alarm.level_deg)}, {"words", inWords(alarm).english()}});
    return json;
}

std::string partName(LikelyPart part)
{
    switch (part) {
    case LikelyPart::Mount: return "mount";
    case LikelyPart::Magnets: return "magnets";
    case LikelyPart::Transmission: return "transmission";
    case LikelyPart::Corrector: return "corrector";
    case LikelyPart::Several: break;
    }
    return "several";
}

Json jumpsJson(const FleetReport& report, const FleetSwings& fleet)
{
    Json json = Json::array();
    for (const auto& jump : report.changes.jumps) {
        const auto& compass = compassAt(fleet, jump.compass);
        json.push_back({{"aircraft", compass.aircraft}, {"compass", compass.compass}, {"after", dateOfDay(dayAt(fleet, jump.afterRow))},
            {"before", dateOfDay(dayAt(fleet, jump.beforeRow))}, {"coefficient", letterAt(jump.coefficient)},
            {"change_deg", toTenDecimals(jump.change_deg)}, {"standard_error_deg", toTenDecimals(jump.standardError_deg)}, {"p", jump.p},
            {"event", jump.event.empty() ? Json() : Json(jump.event)},
            {"likely_part", partName(likelyPart(jumpedTogether(report.changes, jump), compass.kind))}});
    }
    return json;
}

Json driftsJson(const FleetReport& report, const FleetSwings& fleet)
{
    Json json = Json::array();
    for (const auto& each : report.changes.drifts) {
        const auto& compass = compassAt(fleet, each.compass);
        json.push_back({{"aircraft", compass.aircraft}, {"compass", compass.compass}, {"coefficient", letterAt(each.coefficient)},
            {"deg_per_year", toTenDecimals(each.drift.perYear)}, {"standard_error_deg_per_year", toTenDecimals(each.drift.standardError)},
            {"interval_95_deg_per_year", intervalJson(each.drift.interval95)}, {"p", each.drift.p},
            {"from", dateOfDay(dayAt(fleet, each.firstRow))}, {"to", dateOfDay(dayAt(fleet, each.lastRow))}});
    }
    return json;
}

Json rankingJson(const FleetReport& report, const FleetSwings& fleet)
{
    Json json = Json::array();
    for (const auto& ranked : report.ranking.compasses) {
        const auto& compass = compassAt(fleet, ranked.compass);
        json.push_back({{"aircraft", compass.aircraft}, {"compass", compass.compass}, {"probability", toTenDecimals(ranked.probability)},
            {"by_date", dateOfDay(ranked.by_day)}, {"reason", inWords(ranked).english()}, {"limit_deg", toTenDecimals(ranked.limit_deg)},
            {"expected_max_abs_deviation_deg", toTenDecimals(ranked.largestExpected_deg)}, {"swings", ranked.swings},
            {"last_swing", dateOfDay(ranked.lastSwing_day)},
            {"limit_reached_by",
                {{"percent_5", dayOrNull(ranked.reached5_day)}, {"percent_50", dayOrNull(ranked.reached50_day)},
                    {"percent_95", dayOrNull(ranked.reached95_day)}}}});
    }
    return json;
}

Json softIronJson(const std::vector<SoftIronStandard>& standards)
{
    const auto coefficient = [](const std::optional<SoftIronCoefficient>& one) {
        return one ? Json{{"aircraft", one->aircraft}, {"mean_deg", toTenDecimals(one->mean_deg)},
                   {"standard_error_deg", toTenDecimals(one->standardError_deg)}, {"between_aircraft_deg", toTenDecimals(one->between_deg)},
                   {"next_aircraft_95_deg", intervalJson(one->next95_deg)}}
                   : Json();
    };
    Json json = Json::array();
    for (const auto& standard : standards)
        json.push_back(
            {{"type", standard.type}, {"compass", standard.compass}, {"D", coefficient(standard.D)}, {"E", coefficient(standard.E)}});
    return json;
}

Json headingsJson(const std::vector<double>& headings_deg)
{
    Json json = Json::array();
    for (const double heading : headings_deg)
        json.push_back(toTenDecimals(heading));
    return json;
}

} // namespace

std::string toJson(const FleetReport& report, const FleetSwings& fleet)
{
    Json json{{"selection", selectionJson(report.counts)}, {"pattern", patternJson(report.pattern)},
        {"maxima_deg", headingsJson(report.pattern.maxima_deg)}, {"minima_deg", headingsJson(report.pattern.minima_deg)},
        {"largest_spread_deg", figureOrNull(report.pattern.largestSpread_deg)}, {"coefficients", coefficientsJson(report.pattern, fleet)},
        {"harmonics",
            {{"mean", ordersJson(report.pattern.mean)}, {"standard_deviation", ordersJson(report.pattern.spread)},
                {"as_found", ordersJson(report.found)}, {"as_left", ordersJson(report.left)}}},
        {"exceedance", exceedanceJson(report.exceedance)}, {"variance", Json::object()}};
    for (std::size_t c = 0; c < kCoefficientCount; ++c)
        json["variance"][letterAt(c)] = varianceJson(report.variance[c]);
    json["by_plant"] = groupOfAJson(report.plants.bySite, "site");
    json["by_crew"] = groupOfAJson(report.plants.byCrew, "crew");
    json["training"] = trainingJson(report.plants.training);
    json["charts"] = chartsJson(report.plants.charts);
    json["soft_iron"] = softIronJson(report.softIron);
    json["jumps"] = jumpsJson(report, fleet);
    json["drifts"] = driftsJson(report, fleet);
    json["ranking"] = rankingJson(report, fleet);
    json["warnings"] = inEnglish(report.warnings);
    return json.dump(2, ' ', false, Json::error_handler_t::replace); // names may be no UTF-8
}

} // namespace lubberline
