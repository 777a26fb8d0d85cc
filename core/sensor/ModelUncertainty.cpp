#include "core/sensor/ModelUncertainty.h"

#include <algorithm>
#include <cmath>

#include "core/sensor/SensorReading.h"

namespace lubberline {

/// ψ' = atan2(−Y, X): dψ' = (Y dX − X dY)/(X² + Y²), dX and dY by dm = R (dS B + dp).
std::optional<double> headingSigma_rad(
    const SensorModel& model, const ModelUncertainty& uncertainty, const MeridianField& field, const Attitude& attitude)
{
    const Eigen::Vector3d b = fieldInBody(field, attitude);
    const SensorResponse response = responseOf(model);
    const Eigen::Vector3d m = response.gain * b + response.offset_nT;
    const double sp = std::sin(attitude.pitch_rad), cp = std::cos(attitude.pitch_rad);
    const double sr = std::sin(attitude.roll_rad), cr = std::cos(attitude.roll_rad);
    const Eigen::Vector3d along(cp, sp * sr, sp * cr), across(0, cr, -sr);
    const double x = along.dot(m), y = across.dot(m), square = x * x + y * y;
    if (!(std::sqrt(square) > kVanishingPart * ((response.gain * b).norm() + response.offset_nT.norm())))
        return {};
    const Eigen::Matrix3d mount = rotation(model.misalignment.roll_rad, model.misalignment.pitch_rad, model.misalignment.yaw_rad);
    const Eigen::Vector3d byField = mount.transpose() * (y * along - x * across) / square;
    Eigen::Matrix<double, kUncertainParameters, 1> slope;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        slope.segment<3>(3 * axis) = byField[axis] * b;
        slope[9 + axis] = byField[axis];
    }
    return std::sqrt(std::max(0.0, slope.dot(uncertainty.covariance * slope)));
}

} // namespace lubberline
