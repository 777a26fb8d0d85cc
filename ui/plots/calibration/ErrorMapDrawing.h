#pragma once
/// The deviation of a log before and after compensation over heading, drawn.

#include <vector>

#include "core/calibration/Compensation.h"
#include "ui/plots/drawn/DrawnPicture.h"

namespace lubberline::ui {

/// Over heading and pitch, a cell its colour: before above, after below on one scale of colours; with their read-out.
[[nodiscard]] DrawnPicture errorMapDrawing(std::vector<ErrorCell> map);

} // namespace lubberline::ui
