#include "core/sensor/PoissonSmith.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/sensor/Attitude.h"

namespace lubberline {

namespace {

/// A part of the response: the parts of gain and offset add up to the whole, and so do their coefficients, which are linear in
/// both once λ is known.
struct Part {
    Message cause;
    Eigen::Matrix3d gain = Eigen::Matrix3d::Zero();
    Eigen::Vector3d offset_nT = Eigen::Vector3d::Zero();
};

/// λ 𝔄 … λ 𝔈 [P 7], with 1 + S in the gain.
ExactSmith timesLambda(const Eigen::Matrix3d& gain, const Eigen::Vector3d& offset_nT, const MeridianField& field)
{
    const double H_nT = field.horizontal_nT, tanI = field.down_nT / field.horizontal_nT;
    return {(gain(1, 0) - gain(0, 1)) / 2, gain(0, 2) * tanI + offset_nT.x() / H_nT, gain(1, 2) * tanI + offset_nT.y() / H_nT,
        (gain(0, 0) - gain(1, 1)) / 2, (gain(1, 0) + gain(0, 1)) / 2};
}

ExactSmith dividedBy(const ExactSmith& smith, double lambda)
{
    return {smith.A / lambda, smith.B / lambda, smith.C / lambda, smith.D / lambda, smith.E / lambda};
}

std::array<double, kCoefficientCount> valuesOf(const ExactSmith& smith) { return {smith.A, smith.B, smith.C, smith.D, smith.E}; }

bool allFinite(const ExactSmith& smith)
{
    return std::isfinite(smith.A) && std::isfinite(smith.B) && std::isfinite(smith.C) && std::isfinite(smith.D) && std::isfinite(smith.E);
}

void addSoftIron(std::vector<Part>& parts, const SensorModel& model)
{
    static constexpr char kNames[3][3] = {{'a', 'b', 'c'}, {'d', 'e', 'f'}, {'g', 'h', 'k'}};
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) {
            // The third column is excited by the vertical field.
            Part part{{column == 2 ? MARKED("core", "soft iron %1 (dip)") : MARKED("core", "soft iron %1"), kNames[row][column]}};
            part.gain(row, column) = model.softIron(row, column);
            parts.push_back(std::move(part));
        }
}

void addConstant(std::vector<Part>& parts, const Eigen::Vector3d& constant_nT, Pattern what, const std::array<std::string, 3>& names)
{
    for (int axis = 0; axis < 3; ++axis) {
        Part part{{what, names[static_cast<std::size_t>(axis)]}};
        part.offset_nT(axis) = constant_nT(axis);
        parts.push_back(std::move(part));
    }
}

/// Everything that acts at the sensor, as it is before the mount turns it.
std::vector<Part> partsOf(const SensorModel& model)
{
    std::vector<Part> parts;
    addSoftIron(parts, model);
    addConstant(parts, model.hardIron_nT, MARKED("core", "hard iron %1"), {"P", "Q", "R"});
    addConstant(parts, model.softConstant_nT, MARKED("core", "soft constant %1"), {"D1", "D2", "D3"});
    for (const auto& circuit : model.circuits)
        if (circuit.on)
            parts.push_back(
                {Message{MARKED("core", "circuit %1"), circuit.name}, Eigen::Matrix3d::Zero(), circuit.current_A * circuit.field_nT_per_A});
    return parts;
}

std::vector<SmithTerm> termsOf(const SensorModel& model, const MeridianField& field, double lambda)
{
    const Misalignment& turned = model.misalignment;
    const Eigen::Matrix3d mount = rotation(turned.roll_rad, turned.pitch_rad, turned.yaw_rad);
    std::vector<Part> parts = partsOf(model);
    parts.push_back({MARKED("core", "misalignment"), Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()});
    std::vector<SmithTerm> terms;
    for (const Coefficient coefficient : kCoefficients)
        for (const auto& part : parts) {
            const auto values = valuesOf(dividedBy(timesLambda(mount * part.gain, mount * part.offset_nT, field), lambda));
            if (const double value = values[indexOf(coefficient)]; value != 0)
                terms.push_back({coefficient, part.cause, value});
        }
    std::stable_sort(terms.begin(), terms.end(), [](const SmithTerm& a, const SmithTerm& b) {
        return a.coefficient != b.coefficient ? a.coefficient < b.coefficient : std::abs(a.value) > std::abs(b.value);
    });
    return terms;
}

} // namespace

Result<PoissonSmith> smithOf(const SensorModel& model, const MeridianField& field)
{
    if (!(field.horizontal_nT > 0))
        return Error{ErrorCode::Numeric,
            MARKED("core", "the horizontal field H is 0: a level compass has nothing to point by there; expected H > 0")};
    const SensorResponse response = responseOf(model);
    PoissonSmith smith;
    smith.lambda = (response.gain(0, 0) + response.gain(1, 1)) / 2;
    if (!(smith.lambda > 0))
        return Error{ErrorCode::Numeric,
            {MARKED("core", "λ = %1: the iron (or the mount) turns the compass round, and no coefficients describe it; expected λ > 0"),
                std::to_string(smith.lambda)}};
    smith.exact = dividedBy(timesLambda(response.gain, response.offset_nT, field), smith.lambda);
    if (!allFinite(smith.exact))
        return Error{ErrorCode::Numeric,
            {MARKED("core", "the coefficients are beyond all numbers: H = %1 nT and λ = %2 are too small for the iron"),
                std::to_string(field.horizontal_nT), std::to_string(smith.lambda)}};
    if (const auto approximate = toApproximate(smith.exact))
        smith.approximate = *approximate;
    else
        smith.whyNoApproximate = approximate.error().message;
    smith.terms = termsOf(model, field, smith.lambda);
    return smith;
}

} // namespace lubberline
