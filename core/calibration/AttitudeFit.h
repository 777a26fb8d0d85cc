#pragma once
/// Calibration against attitude: heading, pitch and roll beside every sample give the field in body axes, and each axis of the sensor is a
/// linear regression on (Bx, By, Bz, 1, the current of each circuit).
///   m = (1 + S) B + p + Σ circuits (field per ampere × current), S any 3×3 matrix [P 6, 9]
/// An error of the attitude is an error of the regressors: with its standard deviation s (of each angle, independent from row to row) the
/// moments are corrected to second order, E[b b'] = (1 − 3 s²) B B' + s² F² and E[b m'] = (1 − s²) B m'.

#include <optional>

#include "core/base/Result.h"
#include "core/calibration/Ellipsoid.h"
#include "core/earth/EarthField.h"
#include "core/sensor/SensorModel.h"

namespace lubberline {

struct AttitudeOptions {
    MeridianField field;
    double attitudeError_deg = 0;
    std::optional<Variation> variation = {}; ///< of the place: true headings are then known from magnetic ones
};

/// On whole sectors of heading that were left out of the fit.
struct HeldOut {
    int blocks = 0;
    double heading_deg = 0, dip_deg = 0, field_nT = 0; ///< rms
};

struct AttitudeResult {
    std::size_t samples = 0, used = 0;
    SensorModel model;                                  ///< what cannot be told is 0 in it, and what adds up with it holds the sum
    Eigen::Matrix3d softTold = Eigen::Matrix3d::Ones(); ///< 1 where an element can be told
    Eigen::Vector3d hardTold = Eigen::Vector3d::Ones();
    std::vector<bool> circuitTold;
    Misalignment misalignment; ///< by the convention that soft iron is symmetric; with `symmetric` what is left
    Eigen::Matrix3d symmetric = Eigen::Matrix3d::Zero();
    double sigma_nT = 0; ///< scatter of one axis, attitude error included
    double rms_nT = 0;   ///< of |B fitted| − F
    double condition = 0;
    int rank = 0, parametersAsked = 12;
    std::vector<FittedParameter> parameters;
    std::optional<ModelUncertainty> uncertainty; ///< none where not all twelve can be told
    std::vector<Message> notSeparable;
    std::optional<HeldOut> validation;
    Coverage coverage;
    CalibrationVerdict verdict = CalibrationVerdict::NotDetermined;
    std::vector<Message> reasons, nextSteps, warnings;
};

/// Errors: InvalidInput (a column that is missing; counts; angles in radians; headings that come from the compass itself), Numeric
/// (fewer than four samples).
Result<AttitudeResult> fitAttitude(const SensorLog& log, const AttitudeOptions& options);

} // namespace lubberline
