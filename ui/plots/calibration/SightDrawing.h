#pragma once
/// Errors of a line of sight over where one looks, drawn.

#include <vector>

#include "core/calibration/LineOfSight.h"
#include "ui/plots/drawn/DrawnPicture.h"

namespace lubberline::ui {

/// Of each elevation a curve of the whole error in azimuth (strong) and in elevation (dashed), in the turret's axes.
[[nodiscard]] DrawnPicture sightDrawing(std::vector<SightBudget> sweep);

} // namespace lubberline::ui
