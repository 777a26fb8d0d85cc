#include "core/format/results/CalibrationJson.h"

#include <nlohmann/json.hpp>

#include "core/angle/Angle.h"

namespace lubberline {

namespace {

using CalibrationKeys = nlohmann::ordered_json;

CalibrationKeys axesKeys(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
CalibrationKeys matrixKeys(const Eigen::Matrix3d& m)
{
    return {axesKeys(m.row(0).transpose()), axesKeys(m.row(1).transpose()), axesKeys(m.row(2).transpose())};
}

CalibrationKeys parameterKeys(const std::vector<FittedParameter>& parameters)
{
    CalibrationKeys rows = CalibrationKeys::array();
    for (const auto& parameter : parameters)
        rows.push_back({{"name", parameter.name}, {"value", parameter.value ? CalibrationKeys(*parameter.value) : CalibrationKeys()},
            {"standard_error", parameter.standard_error ? CalibrationKeys(*parameter.standard_error) : CalibrationKeys()},
            {"unit", parameter.unit}});
    return rows;
}

CalibrationKeys coverageKeys(const Coverage& coverage)
{
    return {{"share", coverage.share}, {"largest_gap_deg", coverage.largestGap_deg}, {"turn_to", coverage.turnTo.english()}};
}

} // namespace

std::string_view nameOf(EllipsoidShape shape)
{
    return shape == EllipsoidShape::Sphere ? "sphere" : shape == EllipsoidShape::Axes ? "axes" : "ellipsoid";
}

std::string toJson(const EllipsoidResult& result, const SensorLog& log, EllipsoidShape shape)
{
    // Numbers of a result that is not determined would be taken for a calibration.
    const EllipsoidFit* fit = result.fit && result.verdict != CalibrationVerdict::NotDetermined ? &*result.fit : nullptr;
    const EllipsoidFit* any = result.fit ? &*result.fit : nullptr;
    const auto number
        = [](const EllipsoidFit* from, double EllipsoidFit::*member) { return from ? CalibrationKeys(from->*member) : CalibrationKeys(); };
    CalibrationKeys json{{"method", nameOf(shape)}, {"samples", result.samples}, {"used", result.used}, {"unit", nameOf(log.unit)},
        {"unit_reason", log.unitReason.english()}};
    json["hard_iron_nT"] = fit ? axesKeys(fit->hardIron) : CalibrationKeys();
    json["soft_iron"] = fit ? matrixKeys(fit->softIron) : CalibrationKeys();
    json["circuits"] = CalibrationKeys::array();
    json["field_nT"] = number(fit, &EllipsoidFit::field);
    json["sigma_nT"] = number(any, &EllipsoidFit::sigma);
    json["rms_nT"] = number(any, &EllipsoidFit::rms);
    json["gate"] = number(any, &EllipsoidFit::gate);
    json["verdict"] = nameOf(result.verdict);
    json["reasons"] = inEnglish(result.reasons);
    json["next_steps"] = inEnglish(result.nextSteps);
    json["coverage"] = any ? coverageKeys(any->coverage) : CalibrationKeys();
    json["condition_number"] = number(any, &EllipsoidFit::condition);
    json["rank"] = any ? CalibrationKeys(any->rank) : CalibrationKeys();
    json["parameters"] = fit ? parameterKeys(fit->parameters) : CalibrationKeys::array();
    json["not_separable"] = CalibrationKeys::array();
    if (any)
        json["not_separable"].push_back("a rotation of the sensor in its mount: the field's size cannot see it");
    json["validation"] = nullptr;
    std::vector<Message> warnings = log.warnings;
    warnings.insert(warnings.end(), result.warnings.begin(), result.warnings.end());
    json["warnings"] = inEnglish(warnings);
    return json.dump(2, ' ', false, CalibrationKeys::error_handler_t::replace);
}

namespace {

/// A matrix or a vector whose elements are null where they cannot be told.
CalibrationKeys toldKeys(const Eigen::MatrixXd& values, const Eigen::MatrixXd& told)
{
    CalibrationKeys rows = CalibrationKeys::array();
    for (Eigen::Index i = 0; i < values.rows(); ++i) {
        CalibrationKeys row = CalibrationKeys::array();
        for (Eigen::Index j = 0; j < values.cols(); ++j)
            row.push_back(told(i, j) > 0 ? CalibrationKeys(values(i, j)) : CalibrationKeys());
        rows.push_back(std::move(row));
    }
    return rows;
}

CalibrationKeys circuitKeys(const AttitudeResult& result)
{
    CalibrationKeys rows = CalibrationKeys::array();
    for (std::size_t i = 0; i < result.model.circuits.size(); ++i)
        rows.push_back({{"name", result.model.circuits[i].name},
            {"field_nT_per_A", result.circuitTold[i] ? axesKeys(result.model.circuits[i].field_nT_per_A) : CalibrationKeys()}});
    return rows;
}

} // namespace

std::string toJson(const AttitudeResult& result, const SensorLog& log, const MeridianField& field)
{
    const bool told = result.verdict != CalibrationVerdict::NotDetermined;
    CalibrationKeys json{{"method", "attitude"}, {"samples", result.samples}, {"used", result.used}, {"unit", nameOf(log.unit)},
        {"unit_reason", log.unitReason.english()}};
    json["hard_iron_nT"] = told ? toldKeys(result.model.hardIron_nT.transpose(), result.hardTold.transpose())[0] : CalibrationKeys();
    json["soft_iron"] = told ? toldKeys(result.model.softIron, result.softTold) : CalibrationKeys();
    json["circuits"] = told ? circuitKeys(result) : CalibrationKeys::array();
    json["field_nT"] = field.total_nT();
    json["sigma_nT"] = result.sigma_nT;
    json["rms_nT"] = result.rms_nT;
    json["gate"] = nullptr; // of the ellipsoid only
    json["verdict"] = nameOf(result.verdict);
    json["reasons"] = inEnglish(result.reasons);
    json["next_steps"] = inEnglish(result.nextSteps);
    json["coverage"] = coverageKeys(result.coverage);
    json["condition_number"] = result.condition;
    json["rank"] = result.rank;
    json["parameters"] = told ? parameterKeys(result.parameters) : CalibrationKeys::array();
    json["not_separable"] = inEnglish(result.notSeparable);
    json["misalignment_deg"] = {{"roll", toDegrees(result.misalignment.roll_rad)}, {"pitch", toDegrees(result.misalignment.pitch_rad)},
        {"yaw", toDegrees(result.misalignment.yaw_rad)}};
    json["soft_iron_symmetric"] = matrixKeys(result.symmetric);
    json["validation"] = result.validation
        ? CalibrationKeys{{"blocks", result.validation->blocks}, {"rms_deg", result.validation->heading_deg},
            {"rms_nT", result.validation->field_nT}, {"rms_dip_deg", result.validation->dip_deg}}
        : CalibrationKeys();
    std::vector<Message> warnings = log.warnings;
    warnings.insert(warnings.end(), result.warnings.begin(), result.warnings.end());
    json["warnings"] = inEnglish(warnings);
    return json.dump(2, ' ', false, CalibrationKeys::error_handler_t::replace);
}

} // namespace lubberline
