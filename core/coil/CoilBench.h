#pragma once
/// A sensor in a coil: what it measures against what was applied. m = scale (axes) a + bias + temperature + hysteresis + nonlinearity.

#include <array>
#include <optional>
#include <vector>

#include "core/base/Result.h"
#include "core/calibration/SensorLog.h"
#include "core/sensor/SensorModel.h"

namespace lubberline {

/// The applied field in a log [nT].
inline constexpr std::array kAppliedColumns{"ax_nT", "ay_nT", "az_nT"};

struct CoilResult {
    std::size_t samples = 0, used = 0;
    std::vector<std::size_t> rows;                                  ///< of the log, those that are whole: what is used
    double range_nT = 0;                                            ///< largest field that was applied along an axis
    Eigen::Matrix3d gain = Eigen::Matrix3d::Identity();             ///< measured per applied, all of it
    Eigen::Vector3d scale = Eigen::Vector3d::Ones();                ///< measured per applied along each axis of the sensor
    Eigen::Vector3d scaleError = Eigen::Vector3d::Zero();           ///< standard errors
    Eigen::Vector3d nonOrthogonality_deg = Eigen::Vector3d::Zero(); ///< 90° − angle of x and y, x and z, y and z
    Misalignment misalignment;                                      ///< of the axes' nearest rectangular frame in the coil's
    Eigen::Vector3d bias_nT = Eigen::Vector3d::Zero(), biasError_nT = Eigen::Vector3d::Zero();
    std::optional<double> biasAt_c;                      ///< the mean temperature of the log: the bias is that there; none without a column
    std::optional<Eigen::Vector3d> temperature_nT_per_c; ///< none without a column, or where it did not change by 1°
    Eigen::Vector3d temperatureError_nT_per_c = Eigen::Vector3d::Zero();
    std::optional<Eigen::Vector3d> hysteresis_nT; ///< read on the way up − on the way down; none where the field went one way only
    Eigen::Vector3d nonlinearity_nT = Eigen::Vector3d::Zero(); ///< largest part of a curve of third order along the axis
    Eigen::Vector3d noise_nT = Eigen::Vector3d::Zero();        ///< what is left, rms
    std::vector<Message> warnings;
};

/// Columns ax_nT, ay_nT, az_nT (applied) beside the measured field; temperature_c where there is one.
/// Errors: InvalidInput (columns, counts, a measured or applied field in another unit than it says), Numeric (the applied field does not go through all three axes).
Result<CoilResult> coilBench(const SensorLog& log);

} // namespace lubberline
