#pragma once
/// Documents of tests of a sensor: spectrum, coil bench, interference.

#include "core/calibration/Interference.h"
#include "core/calibration/Spectrum.h"
#include "core/coil/CoilHistory.h"
#include "ui/report/forms/ReferenceSheet.h"

namespace lubberline::ui {

/// @param source name of the log
[[nodiscard]] ReferenceSheet spectrumSheet(const LogSpectrum& spectrum, const SensorLog& log, const QString& source);
/// @param history what earlier benches say (driftWords())
[[nodiscard]] ReferenceSheet coilSheet(const CoilResult& result, const QString& source, const QStringList& history = {});
[[nodiscard]] ReferenceSheet interferenceSheet(const InterferenceResult& result, const SensorLog& log, const QString& source);

/// What a coil bench tells, a row a quantity, in three columns x, y, z.
[[nodiscard]] Table coilTable(const CoilResult& result);
/// Kept benches, a row each: range, bias and noise.
[[nodiscard]] Table benchesTable(const std::vector<CoilBench>& benches);
/// What became other between two benches, or why they cannot be compared, in sentences.
[[nodiscard]] QStringList driftWords(const CoilBench& earlier, const CoilBench& later);
[[nodiscard]] Table linesTable(const LogSpectrum& spectrum, const QString& unit);
[[nodiscard]] Table actionsTable(const InterferenceResult& result);
/// Angles between the axes and of the mount, in a sentence.
[[nodiscard]] QString coilAngles(const CoilResult& result);
/// The filter that was chosen, in a sentence; empty: none was.
[[nodiscard]] QString filterWords(const LogSpectrum& spectrum, const QString& unit);

} // namespace lubberline::ui
