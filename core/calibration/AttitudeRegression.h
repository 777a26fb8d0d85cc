#pragma once
/// Private to the attitude fit: the regression by its moments, and what of it cannot be told.

#include <vector>

#include "core/calibration/AttitudeFit.h"

namespace lubberline {

/// The angles of one row as they are to be taken.
struct AngleReading {
    double headingFactor = 1, tiltFactor = 1; ///< 180/π where they are radians
    double headingOffset_deg = 0;
    double pitchSign = 1, rollSign = 1;
    bool swapped = false; ///< pitch for roll
};

/// Sums over rows; those of a part can be taken out again.
struct RegressionMoments {
    Eigen::MatrixXd design;                        ///< Σ x x', x = (B/F, 1, currents scaled)
    Eigen::MatrixXd across;                        ///< Σ x (m/F)'
    Eigen::Matrix3d own = Eigen::Matrix3d::Zero(); ///< Σ (m/F)(m/F)'
    double rows = 0;
};

struct Regression {
    Eigen::MatrixXd solution;          ///< (3 + 1 + circuits) × 3: S', p', currents, in units of F; 0 where not told
    Eigen::MatrixXd covariance;        ///< of one axis for unit variance of (m/F)
    std::vector<bool> told;            ///< of each regressor
    std::vector<Eigen::Index> kept;    ///< those that were fitted: what is told, and one of each sum
    std::vector<Eigen::VectorXd> null; ///< directions that change nothing, reduced: the first regressor of each is its own
    double condition = 0;              ///< of what is told
    double variance = 0;               ///< of (m/F), mean of the axes
};

[[nodiscard]] Eigen::Vector3d fieldOfRow(
    const SensorLog& log, std::size_t row, const MeridianField& field, const AngleReading& reading = {});
[[nodiscard]] std::vector<double> currentScales(const SensorLog& log);
void addRow(RegressionMoments& moments, const SensorLog& log, std::size_t row, const MeridianField& field,
    const std::vector<double>& scales, const AngleReading& reading = {});
[[nodiscard]] RegressionMoments without(RegressionMoments all, const RegressionMoments& part);
/// @param attitudeError_rad s
[[nodiscard]] Regression regress(const RegressionMoments& moments, double attitudeError_rad);

} // namespace lubberline
