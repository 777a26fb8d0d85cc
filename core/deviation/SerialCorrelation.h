#pragma once
/// Readings of a log follow each other faster than what disturbs them changes: the error of one is nearly that of the next, and many
/// readings tell little more than a few. What that costs is measured from the residuals in the order in which they were read.
///   model: error = slow part, correlated ρ^k over k readings, share 1 − w of the variance, + white part, share w;
///   ρ and w by their restricted likelihood (Patterson and Thompson 1971, Biometrika 58, 545), which a Kalman filter gives; of the memories
///   that may be, the middle is taken: the likeliest is too short in a log of a few memories' length.

#include <optional>

#include <Eigen/Core>

#include "core/base/Progress.h"

namespace lubberline {

struct SerialCorrelation {
    double rho = 0;        ///< of the slow part, from one reading to the next
    double whiteShare = 0; ///< w, 0…1
    double variance = 0;   ///< of one reading, both parts, in the square of the unit of `observed`
    [[nodiscard]] double lagOne() const { return (1.0 - whiteShare) * rho; }
};

/// Below this many readings a correlation cannot be told from chance (and people read slowly).
inline constexpr int kLeastForSerialCorrelation = 30;

/// @param design N×p and `observed` in the order of reading. @param progress told false, the search ends, and what it gives is nothing.
/// None when fewer than kLeastForSerialCorrelation readings, or when independent errors explain the residuals nearly as well (likelihood ratio below the 0.5 % point of χ² with two degrees of freedom).
[[nodiscard]] std::optional<SerialCorrelation> serialCorrelation(
    const Eigen::MatrixXd& design, const Eigen::VectorXd& observed, const Progress& progress = {});

/// Covariance of the ordinary least-squares solution under such errors: (XᵀX)⁻¹ XᵀΓX (XᵀX)⁻¹.
[[nodiscard]] Eigen::MatrixXd covarianceUnder(
    const SerialCorrelation& errors, const Eigen::MatrixXd& design, const Eigen::MatrixXd& inverseNormal);

/// How many independent readings would tell the scatter as well: N (1 − r²)/(1 + r²) with the lag-one correlation r.
[[nodiscard]] double independentReadings(const SerialCorrelation& errors, int readings);

} // namespace lubberline
