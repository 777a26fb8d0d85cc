#include "core/format/results/WindsJson.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "core/base/Number.h"
#include "core/fleet/Proportion.h"
#include "core/format/csv/TextCell.h"

namespace lubberline {

namespace {

using WindJson = nlohmann::ordered_json;

WindJson figureOr(bool told, double value) { return told && std::isfinite(value) ? WindJson(value + 0.0) : WindJson(); }

WindJson rmseJson(const WindRmse& rmse)
{
    return {{"total", rmse.total_kt}, {"longitudinal", rmse.longitudinal_kt}, {"transverse", rmse.transverse_kt}};
}

WindJson tableJson(const AircraftWinds& one, TableFactor factor)
{
    WindJson rows = WindJson::array();
    if (!one.fitted || !one.fit.fit.told[0] || !one.fit.fit.told[1] || !one.fit.fit.told[2])
        return rows;
    const auto table = one.table_deg(factor);
    for (std::size_t i = 0; i < table.size(); ++i)
        rows.push_back({{"heading_deg", 45 * i}, {"correction_deg", table[i]}});
    return rows;
}

/// Of the indication error: in phase with sin, in quadrature, offset.
WindJson fitJson(const ClusteredFit& fit)
{
    WindJson errors, halves;
    const double student = fit.flights > 1 ? studentFactor(fit.flights - 1) : 0;
    const std::array<std::pair<const char*, int>, 3> parts{{{"in_phase_deg", 1}, {"quadrature_deg", 2}, {"offset_deg", 0}}};
    WindJson json;
    for (const auto& [key, column] : parts) {
        json[key] = figureOr(fit.told[column], fit.value(column));
        errors[key] = figureOr(fit.told[column] && fit.errorsTold, fit.standardError(column));
        halves[key] = figureOr(fit.told[column] && fit.errorsTold && fit.flights > 1, student * fit.standardError(column));
    }
    json["standard_error_deg"] = errors;
    json["interval_95_deg"] = halves;
    json["flights"] = fit.flights;
    return json;
}

/// Deviation is the indication error the other way.
WindJson smithJson(const AircraftWinds& one)
{
    if (!one.fitted || !one.secondOrderTold)
        return {};
    const ClusteredFit& fit = one.secondOrder;
    WindJson json, errors;
    for (int i = 0; i < kWindColumns; ++i) {
        const std::string key = std::string(1, static_cast<char>('A' + i)) + "_deg";
        json[key] = figureOr(fit.told[i], -fit.value(i));
        errors[key] = figureOr(fit.told[i] && fit.errorsTold, fit.standardError(i));
    }
    json["standard_error_deg"] = errors;
    json["D_E_absent_p"] = one.secondOrderP;
    json["D_E_used"] = one.secondOrderUsed();
    return json;
}

WindJson changeJson(const FoundChange& change)
{
    return {{"after_flight", change.afterFlight}, {"before_flight", change.beforeFlight}, {"p", change.p},
        {"in_phase_change_deg", change.step_deg(1)}, {"quadrature_change_deg", change.step_deg(2)},
        {"offset_change_deg", change.step_deg(0)}};
}

/// The keys of the JSON.
const char* keyOf(LeftOut why)
{
    switch (why) {
    case LeftOut::NoReference: return "no_reference";
    case LeftOut::NoWind: return "no_wind";
    case LeftOut::Rolling: return "rolling";
    case LeftOut::Climbing: return "climbing";
    case LeftOut::Turning: return "turning";
    case LeftOut::Slow: return "slow";
    case LeftOut::Duplicate: return "duplicate";
    }
    return "";
}

WindJson aircraftJson(const AircraftWinds& one, TableFactor factor)
{
    WindJson json{{"aircraft", one.aircraft}, {"flights", one.flights}, {"observations", one.observations}, {"used", one.used}};
    WindJson left;
    for (const LeftOut why : kLeftOut)
        left[keyOf(why)] = one.leftOut[static_cast<std::size_t>(why)];
    json["left_out"] = left;
    json["fit"] = one.fitted ? fitJson(one.fit.fit) : WindJson();
    json["smith"] = smithJson(one);
    json["argument"] = one.declinationOut ? "magnetic heading" : "true heading";
    json["mean_declination_deg"] = figureOr(one.declinationOut, one.meanDeclination_deg);
    json["airspeed_offset_kt"] = figureOr(one.airspeedOffset_kt.has_value(), one.airspeedOffset_kt.value_or(0));
    json["airspeed_offset_standard_error_kt"] = figureOr(one.airspeedOffsetError_kt.has_value(), one.airspeedOffsetError_kt.value_or(0));
    json["table"] = tableJson(one, factor);
    json["table_factor"] = tableFactor(factor);
    WindJson tables;
    for (const TableFactor other : kTableFactors)
        tables[nameOf(other)] = {{"factor", tableFactor(other)}, {"table", tableJson(one, other)}};
    json["tables"] = tables;
    json["rmse_kt"]
        = one.fitted ? WindJson{{"before", rmseJson(one.before)}, {"after", one.after ? rmseJson(*one.after) : WindJson()}} : WindJson();
    json["group"] = one.group.empty() ? WindJson() : WindJson(one.group);
    json["from_positions"] = one.fromPositions;
    json["position_error_kt"] = figureOr(one.fromPositions > 0, one.positionError_kt);
    json["change"] = one.changes.empty() ? WindJson() : changeJson(one.changes.back());
    json["changes"] = WindJson::array();
    for (const auto& change : one.changes)
        json["changes"].push_back(changeJson(change));
    json["fit_before_change"] = one.beforeChange ? fitJson(*one.beforeChange) : WindJson();
    json["warnings"] = inEnglish(one.warnings);
    return json;
}

/// Parts of the control's own.
WindJson normalisedJson(const AircraftWinds& one, const std::optional<WindGroup>& control)
{
    if (!control || !one.fitted)
        return {};
    const WindRmse norm = control->before.rmse();
    const auto parts = [&norm](const WindRmse& rmse) {
        return WindJson{{"total", figureOr(norm.total_kt > 0, rmse.total_kt / norm.total_kt)},
            {"longitudinal", figureOr(norm.longitudinal_kt > 0, rmse.longitudinal_kt / norm.longitudinal_kt)},
            {"transverse", figureOr(norm.transverse_kt > 0, rmse.transverse_kt / norm.transverse_kt)}};
    };
    return {{"before", parts(one.before)}, {"after", one.after ? parts(*one.after) : WindJson()}};
}

WindJson groupJson(const WindGroup& group)
{
    return {{"group", group.group}, {"aircraft", group.aircraft}, {"observations", group.before.count},
        {"rmse_kt",
            {{"before", rmseJson(group.before.rmse())}, {"after", group.after.count > 0 ? rmseJson(group.after.rmse()) : WindJson()}}}};
}

WindJson commonJson(const std::optional<CommonSine>& common)
{
    if (!common)
        return {};
    return {{"aircraft", common->aircraft}, {"in_phase_deg", common->value_deg(1)}, {"quadrature_deg", common->value_deg(2)},
        {"offset_deg", common->value_deg(0)},
        {"standard_error_deg",
            {{"in_phase_deg", common->standardError_deg(1)}, {"quadrature_deg", common->standardError_deg(2)},
                {"offset_deg", common->standardError_deg(0)}}},
        {"as_reference_error_kt", common->asWind_kt()}, {"taken_out", common->takenOut}};
}

} // namespace

const char* nameOf(TableFactor factor)
{
    switch (factor) {
    case TableFactor::Paper: return "paper";
    case TableFactor::Exact: return "exact";
    case TableFactor::None: return "none";
    }
    return "";
}

std::string toJson(const WindResult& result, TableFactor factor)
{
    WindJson json{{"observations", result.observations}, {"used", result.used}, {"aircraft", WindJson::array()}};
    WindJson warnings = inEnglish(result.warnings);
    for (const auto& one : result.aircraft) {
        json["aircraft"].push_back(aircraftJson(one, factor));
        json["aircraft"].back()["rmse_of_control"] = normalisedJson(one, result.control);
        for (const auto& warning : one.warnings)
            warnings.push_back((one.aircraft.empty() ? std::string() : one.aircraft + ": ") + warning.english());
    }
    json["common"] = commonJson(result.common);
    json["bins"] = WindJson::array();
    for (const auto& bin : result.bins)
        json["bins"].push_back({{"from_deg", bin.from_deg}, {"to_deg", figureOr(true, bin.to_deg)}, {"aircraft", bin.aircraft}});
    json["outliers"] = WindJson::array();
    for (const std::size_t row : result.outliers)
        json["outliers"].push_back({{"aircraft", result.aircraft[row].aircraft}, {"size_deg", result.aircraft[row].size_deg()}});
    json["groups"] = WindJson::array();
    for (const auto& group : result.groups)
        json["groups"].push_back(groupJson(group));
    json["control"] = result.control ? groupJson(*result.control) : WindJson();
    json["altitudes"] = WindJson::array();
    for (const auto& band : result.altitudes)
        json["altitudes"].push_back({{"from_m", band.from_m}, {"to_m", band.to_m}, {"observations", band.before.count},
            {"rmse_kt", rmseJson(band.before.rmse())}, {"after_observations", band.after.count},
            {"after_rmse_kt", band.after.count > 0 ? rmseJson(band.after.rmse()) : WindJson()}});
    json["sources"] = WindJson::array();
    for (const auto& source : result.sources)
        json["sources"].push_back({{"source", source.source}, {"observations", source.observations},
            {"mean_error_deg", source.meanError_deg}, {"transverse_kt", source.transverse_kt}});
    json["sources_apart_kt"] = figureOr(result.sourcesApart_kt.has_value(), result.sourcesApart_kt.value_or(0));
    json["warnings"] = warnings;
    return json.dump(2, ' ', false, WindJson::error_handler_t::replace);
}

std::string windTableCsv(const WindResult& result, TableFactor factor)
{
    std::string csv = "# factor: " + shortestNumber(std::round(tableFactor(factor) * 1e6) / 1e6) + " (" + nameOf(factor)
        + "); the table is read with straight lines between its points\naircraft,heading_deg,correction_deg\n";
    for (const auto& one : result.aircraft)
        for (const auto& row : tableJson(one, factor))
            csv += csvTextCell(one.aircraft) + "," + row["heading_deg"].dump() + ","
                + figureOr(true, std::round(row["correction_deg"].get<double>() * 1e4) / 1e4).dump() + "\n";
    return csv;
}

} // namespace lubberline
