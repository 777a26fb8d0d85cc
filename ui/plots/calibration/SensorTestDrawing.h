#pragma once
/// What tests of a sensor tell, drawn: its spectrum with the lines by name, how lines come and go, and what switching changes.

#include "core/calibration/Interference.h"
#include "core/calibration/Spectrum.h"
#include "core/coil/CoilBench.h"
#include "ui/plots/drawn/DrawnPicture.h"

namespace lubberline::ui {

/// @param unit of the column: "nT", "counts"
[[nodiscard]] DrawnPicture spectrumDrawing(const LogSpectrum& spectrum, const QString& unit);
[[nodiscard]] DrawnPicture spectrogramDrawing(const Spectrogram& spectrogram, const QString& unit);
/// The field less its middle before the first action; actions are lines with their names.
[[nodiscard]] DrawnPicture interferenceDrawing(const SensorLog& log, const InterferenceResult& result);

} // namespace lubberline::ui
