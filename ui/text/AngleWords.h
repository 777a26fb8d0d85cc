#pragma once
/// Angles as the window shows them: in decimal degrees, or in degrees and minutes. The style is one for the program, as its language is.

#include <QString>

#include "core/angle/AngleText.h"

namespace lubberline::ui {

void showAnglesIn(AngleStyle style);
[[nodiscard]] AngleStyle shownAngles();

/// "+3.2°" or "3°12'E".
[[nodiscard]] QString shownAngle(double angle_deg, int decimals = 1);
/// What has no direction, as a width or a spread: "3.2°" or "3°12'".
[[nodiscard]] QString shownSize(double size_deg, int decimals = 1);
/// "047.5°" or "047°30'".
[[nodiscard]] QString shownHeading(double heading_deg, int decimals = 1);
/// A figure under a heading that names the unit: "+3.2" or "3°12'E".
[[nodiscard]] QString shownFigure(double angle_deg, int decimals = 1);
/// On an axis whose title names the unit: "+0.5" or "+0°30'"; whole degrees stay as they are.
[[nodiscard]] QString angleTick(double angle_deg, double step_deg);
/// The same with its unit: "+0.5°" or "+0°30'", "+2°".
[[nodiscard]] QString degreeTick(double angle_deg, double step_deg);
/// A sentence that was written with decimal degrees, by core or by us: "up to 2.5°" becomes "up to 2°30'" where that is chosen. Rates ("°/s") stay.
[[nodiscard]] QString inAngleStyle(QString sentence);
/// A cell under a heading that names degrees: "+2.50" becomes "+2°30'" where that is chosen.
[[nodiscard]] QString inAngleColumn(QString cell);
/// The unit of such a column: "°" or "° ′".
[[nodiscard]] QString angleUnit();

} // namespace lubberline::ui
