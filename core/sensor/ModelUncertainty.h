#pragma once
/// How sure a sensor model is, and what that makes of a heading by it.

#include <optional>

#include <Eigen/Core>

#include "core/sensor/Attitude.h"
#include "core/sensor/SensorModel.h"

namespace lubberline {

inline constexpr int kUncertainParameters = 12;

struct ModelUncertainty {
    /// Of a, b, c, d, e, f, g, h, k (no dimension) and P, Q, R (nT), in this order.
    using Covariance = Eigen::Matrix<double, kUncertainParameters, kUncertainParameters>;
    Covariance covariance = Covariance::Zero();
    friend bool operator==(const ModelUncertainty&, const ModelUncertainty&) = default;
};

/// Standard deviation of the deviation that the model tells at an attitude, and so of a heading that it compensates; none where the
/// horizontal field at the sensor vanishes.
[[nodiscard]] std::optional<double> headingSigma_rad(
    const SensorModel& model, const ModelUncertainty& uncertainty, const MeridianField& field, const Attitude& attitude);

} // namespace lubberline
