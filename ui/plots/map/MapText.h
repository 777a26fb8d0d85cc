#pragma once
/// What maps of deviation say in words: titles, read-outs, ticks. All units and signs are named.

#include <QString>

#include "ui/plots/base/NiceScale.h"
#include "ui/plots/map/MapPicture.h"

namespace lubberline::ui {

/// "magnetic heading (°)", "pitch (°, nose up +)", "roll (°, starboard down +)".
[[nodiscard]] QString attitudeTitle(AttitudeAxis axis);
/// "heading 047°", "pitch +12.0°".
[[nodiscard]] QString attitudeText(AttitudeAxis axis, double value_deg);
/// A tick: "090 E", "+30".
[[nodiscard]] QString attitudeTick(AttitudeAxis axis, double value_deg);

/// "MODELLED" or "MEASURED".
[[nodiscard]] QString kindWord(const MapPicture& picture);
/// The title and the held angle: "SP-XYZ · roll 0.0°".
[[nodiscard]] QString mapCaption(const MapPicture& picture);
/// "deviation (°, east +)".
[[nodiscard]] QString mapValueTitle(const MapPicture& picture);
/// "+3.4°".
[[nodiscard]] QString mapValueText(double value_deg);
/// "heading 047°, pitch +12.0°, deviation +3.4°"; without a value: the horizontal field vanishes.
[[nodiscard]] QString mapReadOut(const MapPicture& picture, double x_deg, double y_deg, std::optional<double> value_deg);
[[nodiscard]] QString vanishingText();

/// The colours' range: that of the picture, else what the largest |value| needs; never beyond ±180°.
[[nodiscard]] NiceScale mapScale(const MapPicture& picture, double largest_deg);

} // namespace lubberline::ui
