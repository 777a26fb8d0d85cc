#pragma once
/// Documents of a calibration from a log, and of a log that was compensated.

#include "core/calibration/AttitudeFit.h"
#include "core/calibration/Compensation.h"
#include "ui/report/forms/ReferenceSheet.h"

namespace lubberline::ui {

/// What an ellipsoid and a fit against attitude have in common.
struct CalibrationOutcome {
    QString method;
    CalibrationVerdict verdict = CalibrationVerdict::NotDetermined;
    std::size_t samples = 0, used = 0;
    std::vector<Message> reasons, nextSteps, notSeparable, warnings;
    std::vector<FittedParameter> parameters; ///< empty where nothing is determined
};
[[nodiscard]] CalibrationOutcome outcomeOf(const EllipsoidResult& result);
[[nodiscard]] CalibrationOutcome outcomeOf(const AttitudeResult& result);

/// @param source name of the log. @param compensated the log with the calibration taken out; null: there is none
[[nodiscard]] ReferenceSheet calibrationSheet(
    const CalibrationOutcome& outcome, const SensorLog& log, const CompensatedLog* compensated, const QString& source);
[[nodiscard]] ReferenceSheet compensationSheet(const CompensatedLog& compensated, const SensorLog& log, const QString& source);

} // namespace lubberline::ui
