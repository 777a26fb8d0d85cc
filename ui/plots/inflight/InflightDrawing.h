#pragma once
/// What flights tell, drawn: reports of an aircraft over heading with their fit and its band, the headings that were flown as a rose, and the
/// coefficients of a continuous swing as they settle. Deviation is magnetic − compass, up where it is easterly.

#include "core/inflight/ContinuousSwing.h"
#include "core/inflight/Legs.h"
#include "core/inflight/WindStudy.h"
#include "ui/plots/drawn/DrawnPicture.h"

namespace lubberline::ui {

[[nodiscard]] DrawnPicture windScatter(const AircraftWinds& aircraft);
[[nodiscard]] DrawnPicture windRose(const AircraftWinds& aircraft);
/// A to E over time, each with two standard errors either way; alarms are lines.
[[nodiscard]] DrawnPicture convergence(const ContinuousResult& result);
/// Wind triangle of legs: their ground velocities on the circle about the wind whose radius is the airspeed.
[[nodiscard]] DrawnPicture legCircle(const LegsSolution& solution);

} // namespace lubberline::ui
