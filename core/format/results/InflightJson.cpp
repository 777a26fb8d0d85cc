#include "core/format/results/InflightJson.h"

#include <Eigen/Core>
#include <cmath>

#include <nlohmann/json.hpp>

#include "core/algebra/Spectra.h"
#include "core/angle/Angle.h"
#include "core/base/Number.h"
#include "core/format/csv/TextCell.h"
#include "core/format/json/ReadObject.h"

namespace lubberline {

namespace {

using InflightTree = nlohmann::ordered_json;

InflightTree orNothing(const std::optional<double>& value) { return value ? InflightTree(*value) : InflightTree(); }

std::string stateKey(const std::string& name) { return name.size() == 1 ? name + "_deg" : name + " [deg]"; }

InflightTree statesJson(const std::vector<std::string>& names, const std::vector<std::optional<double>>& values)
{
    InflightTree json;
    for (std::size_t i = 0; i < names.size(); ++i)
        json[stateKey(names[i])] = orNothing(values[i]);
    return json;
}

constexpr int kStateVersion = 1;

} // namespace

std::string toJson(const LegsSolution& solution)
{
    InflightTree json{{"wind",
                          {{"from_deg", solution.air.from_deg()}, {"speed_kt", solution.air.speed_kt()},
                              {"standard_error_kt", solution.air.standardError_kt()}}},
        {"airspeed_kt", solution.air.airspeed_kt}, {"airspeed_standard_error_kt", solution.air.airspeedError_kt},
        {"scatter_kt", solution.legs.size() > 3 ? InflightTree(solution.air.scatter_kt) : InflightTree()}, {"legs", InflightTree::array()}};
    for (const auto& one : solution.legs)
        json["legs"].push_back({{"leg", one.leg.name}, {"samples", one.leg.samples}, {"track_deg", one.leg.track_deg},
            {"ground_speed_kt", one.leg.groundSpeed_kt}, {"true_heading_deg", one.trueHeading_deg},
            {"standard_error_deg", one.standardError_deg}, {"magnetic_heading_deg", orNothing(one.magneticHeading_deg)},
            {"compass_heading_deg", orNothing(one.leg.compassHeading_deg)}, {"deviation_deg", orNothing(one.deviation_deg)},
            {"off_circle_kt", one.offCircle_kt}});
    json["warnings"] = inEnglish(solution.warnings);
    return json.dump(2, ' ', false, InflightTree::error_handler_t::replace);
}

std::string toJson(const ContinuousResult& result)
{
    InflightTree json{{"updates", result.updates}, {"not_taken", result.gated}, {"state", statesJson(result.names, result.state_deg)},
        {"standard_error_deg", statesJson(result.names, result.standardError_deg)}, {"nis_mean", orNothing(result.nisMean)},
        {"whiteness_p", orNothing(result.whitenessP)}, {"correlation", orNothing(result.correlation)}, {"variance_widened", result.widened},
        {"noise_found_deg", orNothing(result.noise_deg)}, {"noise_variance_ratio", result.noiseRatio},
        {"null_directions", inEnglish(result.nullDirections)}, {"alarms", InflightTree::array()}, {"history", InflightTree::array()},
        {"legs", InflightTree::array()}};
    for (const auto& alarm : result.alarms)
        json["alarms"].push_back({{"time_s", alarm.time_s}, {"since_s", alarm.since_s}, {"from_s", alarm.from_s}, {"to_s", alarm.to_s},
            {"window", alarm.window}, {"p", alarm.p}, {"coefficient", alarm.coefficient}, {"or_else", alarm.orElse},
            {"change_deg", alarm.change_deg}, {"standard_error_deg", alarm.standardError_deg}});
    for (const auto& point : result.history) {
        InflightTree values, errors;
        for (std::size_t i = 0; i < result.historyNames.size(); ++i) {
            values[stateKey(result.historyNames[i])] = point.state_deg(static_cast<Eigen::Index>(i));
            errors[stateKey(result.historyNames[i])] = point.standardError_deg(static_cast<Eigen::Index>(i));
        }
        json["history"].push_back({{"time_s", point.time_s}, {"state", values}, {"standard_error_deg", errors}});
    }
    if (const auto& whole = result.whole) {
        InflightTree level{{"H_nT", whole->field.horizontal_nT}, {"dip_deg", toDegrees(whole->field.inclination_rad())}};
        constexpr std::string_view kLetters = "ABCDE";
        for (std::size_t c = 0; c < kLetters.size(); ++c) {
            level[std::string(1, kLetters[c]) + "_deg"] = orNothing(whole->level_deg[c]);
            level[std::string(1, kLetters[c]) + "_standard_error_deg"] = orNothing(whole->levelError_deg[c]);
        }
        json["level"] = level;
        json["sensor_model"] = InflightTree();
        if (const auto& model = whole->model) {
            InflightTree soft = InflightTree::array();
            for (int row = 0; row < 3; ++row)
                soft.push_back({model->softIron(row, 0), model->softIron(row, 1), model->softIron(row, 2)});
            json["sensor_model"]
                = {{"soft_iron", soft}, {"hard_iron_nT", {model->hardIron_nT.x(), model->hardIron_nT.y(), model->hardIron_nT.z()}}};
        }
    }
    for (const auto& leg : result.legs)
        json["legs"].push_back({{"leg", leg.leg.empty() ? InflightTree() : InflightTree(leg.leg)}, {"time_s", leg.time_s},
            {"samples", leg.samples}, {"compass_heading_deg", leg.compassHeading_deg}, {"deviation_deg", leg.deviation_deg}});
    json["warnings"] = inEnglish(result.warnings);
    return json.dump(2, ' ', false, InflightTree::error_handler_t::replace);
}

std::string historyCsv(const ContinuousResult& result)
{
    std::string csv = "time_s";
    for (const auto& name : result.historyNames)
        csv += "," + csvTextCell(stateKey(name)) + "," + csvTextCell("standard error of " + stateKey(name));
    csv += "\n";
    for (const auto& point : result.history) {
        csv += shortestNumber(point.time_s);
        for (Eigen::Index i = 0; i < point.state_deg.size(); ++i)
            csv += "," + shortestNumber(point.state_deg(i)) + "," + shortestNumber(point.standardError_deg(i));
        csv += "\n";
    }
    return csv;
}

std::string stateJson(const ContinuousState& state)
{
    InflightTree json{{"format", "lubberline continuous swing"}, {"version", kStateVersion}, {"time_s", state.time_s},
        {"updates", state.updates}, {"loads", state.loads}, {"state_deg", InflightTree::array()},
        {"covariance_deg2", InflightTree::array()}};
    if (state.horizontal_nT)
        json["whole_model_over_nT"] = *state.horizontal_nT;
    for (const TakenLog& log : state.logs)
        json["logs"].push_back(
            {{"print", log.print}, {"beginning", log.beginning}, {"from_s", log.from_s}, {"to_s", log.to_s}, {"readings", log.samples}});
    for (Eigen::Index i = 0; i < state.state_deg.size(); ++i) {
        json["state_deg"].push_back(state.state_deg(i));
        for (Eigen::Index j = 0; j < state.state_deg.size(); ++j)
            json["covariance_deg2"].push_back(state.covariance(i, j));
    }
    return json.dump(1);
}

Result<ContinuousState> readStateJson(std::string_view text, const std::string& name)
{
    return readJsonObject<ContinuousState>(text, name, MARKED("core", "the state of a continuous swing"), [](JsonObject& object) {
        ContinuousState state;
        object.only({"format", "version", "time_s", "updates", "loads", "whole_model_over_nT", "state_deg", "covariance_deg2", "logs"});
        if (object.requiredText("format") != "lubberline continuous swing")
            object.fault("format", MARKED("core", "is another; expected the state of a continuous swing"));
        if (object.requiredNumber("version", {}) != kStateVersion)
            object.fault("version", {MARKED("core", "is not %1: it was written by another version of the program"), kStateVersion});
        state.time_s = object.requiredNumber("time_s", {});
        state.updates = static_cast<std::int64_t>(object.requiredNumber("updates", {0, 1e15}));
        object.array("loads", [&](const nlohmann::json& value, const JsonPath&) {
            if (value.is_string())
                state.loads.push_back(value.get<std::string>());
        });
        object.objects("logs", [&](JsonObject& log) {
            log.only({"print", "beginning", "from_s", "to_s", "readings"});
            TakenLog& one = state.logs.emplace_back();
            one.print = static_cast<std::uint64_t>(log.requiredNumber("print", {0, 0x1p52}));
            one.beginning = static_cast<std::uint64_t>(log.requiredNumber("beginning", {0, 0x1p52}));
            one.from_s = log.requiredNumber("from_s", {});
            one.to_s = log.requiredNumber("to_s", {});
            one.samples = static_cast<std::int64_t>(log.requiredNumber("readings", {1, 1e15}));
        });
        if (object.has("whole_model_over_nT"))
            state.horizontal_nT = object.requiredNumber("whole_model_over_nT", {500, 50'000});
        const int core = coreStates(state.horizontal_nT.has_value());
        const auto kMostLoadsKept = static_cast<std::size_t>((kMostStates - core) / 2);
        if (state.loads.size() > kMostLoadsKept) {
            object.fault("loads", {MARKED("core", "has more than %1 loads"), kMostLoadsKept});
            state.loads.clear();
        }
        const auto states = static_cast<Eigen::Index>(core) + 2 * static_cast<Eigen::Index>(state.loads.size());
        std::vector<double> values(static_cast<std::size_t>(states)), covariance(static_cast<std::size_t>(states * states));
        for (const char* key : {"state_deg", "covariance_deg2"})
            if (!object.has(key))
                object.missing(key, MARKED("core", "numbers"));
        object.numbers("state_deg", values);
        object.numbers("covariance_deg2", covariance);
        state.state_deg = Eigen::Map<const Eigen::VectorXd>(values.data(), states);
        state.covariance = Eigen::Map<const Eigen::MatrixXd>(covariance.data(), states, states);
        const Eigen::VectorXd spectrum = symmetricValues(state.covariance);
        if (!state.covariance.isApprox(state.covariance.transpose(), 1e-9) || spectrum(0) < -1e-9 * std::abs(spectrum(states - 1)))
            object.fault("covariance_deg2", MARKED("core", "is no covariance; expected a symmetric one that is not negative"));
        return state;
    });
}

} // namespace lubberline
