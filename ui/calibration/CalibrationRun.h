#pragma once
/// A log from the file to the compensated headings: what the page's worker does, and what it says of it.

#include <QString>

#include <memory>
#include <optional>

#include "core/calibration/AttitudeFit.h"
#include "core/calibration/Compensation.h"
#include "core/format/csv/SensorLogCsv.h"

namespace lubberline::ui {

enum class CalibrationMethod { Ellipsoid, Axes, Sphere, Attitude };

struct CalibrationWish {
    std::string path;
    SensorLogOptions reading;
    std::shared_ptr<const SensorLog> read;         ///< the same log, read before; null: it is read
    std::optional<std::pair<double, double>> part; ///< of time, or of rows
    CalibrationMethod method = CalibrationMethod::Ellipsoid;
    std::optional<double> field_nT, dip_deg;
    double attitudeError_deg = 0;
};

struct CalibrationRun {
    std::shared_ptr<const SensorLog> log;  ///< whole
    std::shared_ptr<const SensorLog> part; ///< what was used
    std::optional<EllipsoidResult> ellipsoid;
    std::optional<AttitudeResult> attitude;
    std::optional<SensorModel> model; ///< none where nothing is determined
    std::optional<ModelUncertainty> uncertainty;
    double field_nT = 0; ///< of the model
    std::optional<CompensatedLog> compensated;

    [[nodiscard]] CalibrationVerdict verdict() const
    {
        return ellipsoid ? ellipsoid->verdict : attitude ? attitude->verdict : CalibrationVerdict::NotDetermined;
    }
};

Result<CalibrationRun> runCalibration(const CalibrationWish& wish, const Progress& progress);

/// The verdict, why, what to do next, and the figures, as HTML for a label.
[[nodiscard]] QString wordsOf(const CalibrationRun& run);

} // namespace lubberline::ui
