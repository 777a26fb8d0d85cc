#pragma once
/// Documents of tests of a sensor: spectrum, coil bench, interference.

#include "core/calibration/CoilBench.h"
#include "core/calibration/Interference.h"
#include "core/calibration/Spectrum.h"
#include "ui/report/forms/ReferenceSheet.h"

namespace lubberline::ui {

/// @param source name of the log
[[nodiscard]] ReferenceSheet spectrumSheet(const LogSpectrum& spectrum, const SensorLog& log, const QString& source);
[[nodiscard]] ReferenceSheet coilSheet(const CoilResult& result, const QString& source);
[[nodiscard]] ReferenceSheet interferenceSheet(const InterferenceResult& result, const SensorLog& log, const QString& source);

/// What a coil bench tells, a row a quantity, in three columns x, y, z.
[[nodiscard]] Table coilTable(const CoilResult& result);
[[nodiscard]] Table linesTable(const LogSpectrum& spectrum, const QString& unit);
[[nodiscard]] Table actionsTable(const InterferenceResult& result);
/// Angles between the axes and of the mount, in a sentence.
[[nodiscard]] QString coilAngles(const CoilResult& result);
/// The filter that was chosen, in a sentence; empty: none was.
[[nodiscard]] QString filterWords(const LogSpectrum& spectrum, const QString& unit);

} // namespace lubberline::ui
