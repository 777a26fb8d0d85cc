#pragma once
/// What a calibration shows: the log, the directions that it has seen, and headings or the field's size before and after.

#include "ui/calibration/CalibrationRun.h"
#include "ui/calibration/CoverageSphere.h"
#include "ui/plots/series/SeriesPlot.h"

namespace lubberline::ui {

[[nodiscard]] SeriesPicture logPicture(const std::shared_ptr<const SensorLog>& log);
/// Of a run without a model none.
[[nodiscard]] std::vector<SphereDot> sphereDots(const CalibrationRun& run);
[[nodiscard]] SeriesPicture beforeAfterPicture(const CalibrationRun& run);

} // namespace lubberline::ui
