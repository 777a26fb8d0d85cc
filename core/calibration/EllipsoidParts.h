#pragma once
/// Private to the ellipsoid: its rows and their spread, its covariance, and the judgement.

#include "core/calibration/QuadricFit.h"

namespace lubberline {

inline constexpr std::size_t kSubsample = 50000; ///< of a long log: enough for a median and for a covariance

[[nodiscard]] std::size_t freeOf(EllipsoidShape shape);

/// Evenly spread rows that are in use, at most `most`.
[[nodiscard]] std::vector<std::size_t> someRows(const std::vector<std::uint8_t>& used, std::size_t most = kSubsample);

/// Rows side by side: what is asked of them several times must not lie all over a long log.
using FieldSamples = std::vector<Eigen::Vector3d>;
[[nodiscard]] FieldSamples samplesOf(const SensorLog& log, const std::vector<std::size_t>& rows);

struct Spread {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    double scale = 1;
    Eigen::Vector3d axes = Eigen::Vector3d::Zero(); ///< standard deviations along the principal axes, smallest first
    Eigen::Vector3d thinnest = Eigen::Vector3d::Zero();
};

[[nodiscard]] Spread spreadOf(const FieldSamples& samples);

/// Figures, their covariance by one weighted Gauss–Newton step, the gate and the coverage.
[[nodiscard]] EllipsoidFit fitOf(
    const SensorLog& log, const Quadric& quadric, const std::vector<std::uint8_t>& used, EllipsoidShape shape, std::optional<double> field);

/// A fit of fewer parameters held against all ten of the same samples (F test of the parameters that it leaves out): what they say it is wrong
/// by goes into its errors. A warning where the log would not show what matters.
void holdAgainstGeneral(EllipsoidResult& result, const SensorLog& log, std::optional<double> field_nT);

/// Why nothing can be told of so few or such flat samples; empty where there is no such reason.
[[nodiscard]] Message flatness(const SensorLog& log, const std::vector<std::size_t>& rows, EllipsoidShape shape);
/// Verdict, reasons and what to do next, of the fit that is there.
void judge(EllipsoidResult& result, const SensorLog& log, std::optional<double> field_nT);

} // namespace lubberline
