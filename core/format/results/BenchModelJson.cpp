#include "core/format/results/BenchModelJson.h"

#include <nlohmann/json.hpp>

#include "core/iron/Coercivity.h"

namespace lubberline {

namespace {

using Json = nlohmann::ordered_json;

Json vectorJson(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Json matrixJson(const Eigen::Matrix3d& m)
{
    Json rows = Json::array();
    for (int row = 0; row < 3; ++row)
        rows.push_back({m(row, 0), m(row, 1), m(row, 2)});
    return rows;
}

Json partJson(const PartEffect& part)
{
    Json json{{"part", part.part}, {"method", part.dipole ? "dipole" : "tensor"}, {"distance_m", part.distance_m},
        {"soft_iron", matrixJson(part.softIron)}, {"hard_iron_nT", vectorJson(part.hardIron_nT)}};
    const auto drift_nT = mayDrift_nT(part);
    json["iron"] = part.coercivity_A_per_m ? Json(Message(nameOf(ironClassOf(*part.coercivity_A_per_m))).english()) : Json();
    json["may_drift_nT"] = drift_nT ? Json(*drift_nT) : Json();
    return json;
}

} // namespace

std::string toJson(const BenchModel& model, const BenchStates& states)
{
    Json json{{"soft_iron", matrixJson(model.model.softIron)}, {"hard_iron_nT", vectorJson(model.model.hardIron_nT)}};
    json["circuits"] = Json::array();
    for (const auto& circuit : model.model.circuits)
        json["circuits"].push_back({{"name", circuit.name}, {"field_nT_per_A", vectorJson(circuit.field_nT_per_A)},
            {"current_A", circuit.current_A}, {"on", circuit.on}});
    json["states"] = states;
    json["parts"] = Json::array();
    for (const auto& part : model.parts)
        json["parts"].push_back(partJson(part));
    json["warnings"] = inEnglish(model.warnings);
    return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

} // namespace lubberline
