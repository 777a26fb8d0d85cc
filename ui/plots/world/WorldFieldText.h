#pragma once
/// What the map of the Earth's field says in words.

#include <QString>

#include "core/earth/FieldGrid.h"

namespace lubberline::ui {

[[nodiscard]] bool isAngle(FieldElement element);
/// "declination (°, east +)", "horizontal field H (nT)".
[[nodiscard]] QString fieldElementTitle(FieldElement element);
/// "+10°", "20000".
[[nodiscard]] QString isolineText(FieldElement element, double level);
/// "52.2° N", "21.0° E"; `decimals` of the degree.
[[nodiscard]] QString latitudeText(double latitude_deg, int decimals);
[[nodiscard]] QString longitudeText(double longitude_deg, int decimals);
/// "52.2° N, 21.0° E: declination +6.7°".
[[nodiscard]] QString worldReadOut(const FieldGrid& grid, double latitude_deg, double longitude_deg);
/// Bilinear between the nodes; across a jump of the angle the nearest node.
[[nodiscard]] double gridValueAt(const FieldGrid& grid, double latitude_deg, double longitude_deg);

} // namespace lubberline::ui
