#pragma once
/// Private to the attitude fit: what it asks of a log before it is believed, and its words.

#include "core/calibration/AttitudeRegression.h"

namespace lubberline {

[[nodiscard]] RegressionMoments momentsOfRows(
    const SensorLog& log, const std::vector<std::uint8_t>& used, const MeridianField& field, const AngleReading& reading = {});

/// Angles in another unit explain the samples far better than as they are named; empty where they do not.
[[nodiscard]] Message misreadAngles(
    const SensorLog& log, const std::vector<std::uint8_t>& used, const AttitudeOptions& options, double variance);
/// Headings that are reciprocal or run the other way, pitch or roll of the other sign: of the ways to take the columns, one explains the
/// samples far better than the one that is stated. Empty where none does.
[[nodiscard]] Message misnamedAngles(const SensorLog& log, const std::vector<std::uint8_t>& used, const AttitudeOptions& options);
/// What part of the readings' variance the attitude explains, 0 … 1.
[[nodiscard]] double explainedPart(const RegressionMoments& moments, double variance);
/// Swapped or mirrored axes: of the 48 ways to name them, one fits far better than the one that is stated.
void checkAxes(AttitudeResult& result, const RegressionMoments& moments);
/// Headings from true north, where the place's variation explains the samples far better: seen only where the aircraft was tilted.
void checkNorth(
    AttitudeResult& result, const SensorLog& log, const std::vector<std::uint8_t>& used, const AttitudeOptions& options, double variance);

/// A direction of the regressors along which nothing changes, in words for all three axes.
[[nodiscard]] Message inWords(const SensorLog& log, const Eigen::VectorXd& direction, double total_nT);
void describeAttitudeParameters(AttitudeResult& result, const SensorLog& log, const Regression& fit, double total_nT, double variance);

} // namespace lubberline
