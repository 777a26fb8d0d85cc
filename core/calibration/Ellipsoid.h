#pragma once
/// Calibration of a three-axis sensor by the field's size alone: whatever way it is turned, |W (m − p)| = F.
///   m = (I + S) B + p, W = (I + S)⁻¹ symmetric: an ellipsoid cannot see a rotation.
/// Adjusted least squares with unknown noise (Markovsky, Kukush, Van Huffel 2004, Numer. Math. 98, 177): the smallest σ² that makes the
/// noise-corrected moment matrix singular; its null vector is the quadric. Bad samples are trimmed at 4 × 1.4826 MAD of the residual
/// (|W (m − p)| − F)/|W n|. The covariance is that of one weighted Gauss–Newton step from there.

#include <optional>

#include <Eigen/Core>

#include "core/calibration/Coverage.h"
#include "core/calibration/SensorLog.h"
#include "core/sensor/ModelUncertainty.h"

namespace lubberline {

enum class EllipsoidShape {
    Sphere,  ///< 4 parameters: p and a common scale
    Axes,    ///< 7: S diagonal
    General, ///< 10: S symmetric
};

enum class CalibrationVerdict { Good, Doubtful, NotDetermined };
[[nodiscard]] std::string_view nameOf(CalibrationVerdict verdict); ///< "good", "doubtful", "not determined"

/// The gate g = κ σ/F, κ the condition number of the column-normalised weighted Jacobian: up to the first limit the 95 % intervals hold
/// (simulated: in 92–99 %), up to the second they are somewhat too short, beyond it the result is not determined.
inline constexpr double kGateGood = 0.5, kGateDetermined = 1.5;
/// A field that the log contradicts by this part is told as a fault of one of both.
inline constexpr double kFieldContradiction = 0.1;
/// Residual of |B| that noise does not explain: beyond this part of F a heading is 1° out.
inline constexpr double kResidualLimit = 0.02;

struct FittedParameter {
    std::string name; ///< "P", "a", "landing light S"
    std::optional<double> value;
    std::optional<double> standard_error;
    std::string unit; ///< "nT", "counts", "1", "nT/A"
};

/// Soft iron that a shape of fewer parameters leaves out, where the ten of the same samples leave so much less that chance is no reason.
struct LeftOutIron {
    double sigma = 0;                                   ///< noise of one axis that the ten leave
    double ratio = 0, limit = 0;                        ///< F, and what chance reaches once in a thousand logs
    Eigen::Vector3d hardIron{0, 0, 0};                  ///< of the ten − of the shape
    Eigen::Matrix3d softIron = Eigen::Matrix3d::Zero(); ///< likewise
    [[nodiscard]] double partOf(double field) const;    ///< the most that a component of the field is off by it
};

/// What a fit leaves over that goes with the direction of the field; nothing where chance explains it.
struct WithDirection {
    double rms = 0;   ///< of it
    double ratio = 1; ///< F, of means in cells of directions against the scatter inside
};

struct EllipsoidFit {
    EllipsoidShape shape = EllipsoidShape::General;
    Eigen::Matrix3d softIron = Eigen::Matrix3d::Zero();
    Eigen::Vector3d hardIron = Eigen::Vector3d::Zero();
    double field = 0; ///< F as given, or the geometric mean of the axes
    double sigma = 0; ///< noise of one axis
    double rms = 0;   ///< of |W (m − p)| − F
    double gate = 0;  ///< g
    double condition = 0;
    double slow = 1; ///< variance of a mean over that of independent samples: residuals that follow each other
    int rank = 0;
    WithDirection structured;
    std::optional<LeftOutIron> leftOut; ///< the errors of the parameters hold it
    std::vector<FittedParameter> parameters;
    ModelUncertainty uncertainty; ///< of the model that is made of it; of a log in counts R, P and Q are in counts
    Coverage coverage;
    Message changed; ///< with time, in words; empty where nothing did. What it is wrong by is in the covariance.
};

struct EllipsoidResult {
    std::size_t samples = 0, used = 0;
    std::vector<std::uint8_t> usedRows; ///< one byte a row
    std::optional<EllipsoidFit> fit;    ///< none where no ellipsoid comes out
    CalibrationVerdict verdict = CalibrationVerdict::NotDetermined;
    std::vector<Message> reasons;   ///< why no better, each with its figure and its limit
    std::vector<Message> nextSteps; ///< what to do
    std::vector<Message> warnings;
};

/// @param field_nT F where it is known; a log in counts keeps its radius.
[[nodiscard]] EllipsoidResult fitEllipsoid(const SensorLog& log, EllipsoidShape shape, std::optional<double> field_nT);

/// |W (m − p)| − F of one sample.
[[nodiscard]] double residualOf(const EllipsoidFit& fit, const Eigen::Vector3d& measured);

} // namespace lubberline
