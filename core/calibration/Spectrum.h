#pragma once
/// What disturbs a sensor periodically: lines of its log's spectrum by name, those that sampling folds down, and filters under a delay.

#include <optional>

#include "core/base/Result.h"
#include "core/calibration/DelayFilter.h"
#include "core/calibration/SensorLog.h"

namespace lubberline {

/// What a line may come from.
struct LineSource {
    Message name;                     ///< "mains 50 Hz"
    std::optional<double> aliasOf_hz; ///< the frequency that sampling folded down to it
    bool exactly = false;             ///< where such a supply stands as a rule, and not "perhaps" further off
};

struct SpectralLine {
    double frequency_hz = 0;              ///< as it stands in the log
    double amplitude = 0;                 ///< of the sine, in the unit of the log
    Message source;                       ///< "mains 50 Hz", "rotor order 2", "not known"; all that explain it: "… or …"
    std::optional<double> aliasOf_hz;     ///< of the first of them
    std::vector<LineSource> sources = {}; ///< supplies that explain it alike; nothing in the log tells one from the other
};

struct SpectrumOptions {
    std::string column = {};                ///< bx, by, bz, or a name of the file; empty: the axis with the strongest line
    std::size_t segment = 0;                ///< 0: by the length of the log
    std::string tachometer = {};            ///< a column [rev/min]
    std::optional<double> maxDelay_ms = {}; ///< for a filter
};

struct LogSpectrum {
    std::string column;
    double rate_hz = 0;
    std::size_t segment = 0, segments = 0;
    std::vector<double> frequency_hz, density; ///< one-sided
    std::vector<SpectralLine> lines;           ///< the strongest first
    std::optional<DelayFilter> filter;
    std::vector<Message> warnings;
};

/// A line is a bin above its neighbours' median by more than chance does once in a thousand spectra.
/// Errors: InvalidInput (no such column, no time, too short).
Result<LogSpectrum> spectrumOf(const SensorLog& log, const SpectrumOptions& options);

/// Densities over time: how lines come and go.
struct Spectrogram {
    double rate_hz = 0, step_hz = 0;
    std::vector<double> time_s;               ///< the middle of each
    std::vector<std::vector<double>> density; ///< of each time, at 0, step, …; as LogSpectrum's
};
/// Of a column as spectrumOf() names them, in at most `most` times, each of some segments. Errors: as spectrumOf().
Result<Spectrogram> spectrogramOf(const SensorLog& log, const std::string& column, std::size_t segment, std::size_t most = 200);

/// Where sampling at `rate_hz` puts a frequency: 0 … rate/2.
[[nodiscard]] double aliasOf_hz(double frequency_hz, double rate_hz);

/// Fills the sources of a line, all that it may come from: what stands as it is before what sampling folded down.
/// @param within_hz how far its true frequency may lie off
void nameLine(SpectralLine& line, double rate_hz, double within_hz);

/// Supplies (50, 60, 400 Hz and odd harmonics, 115 Hz) that fall within `within_hz` of zero at this rate and look like hard iron there.
[[nodiscard]] std::vector<double> suppliesOnZero_hz(double rate_hz, double within_hz);
/// The warning of it; empty where there is none.
[[nodiscard]] Message warningOfZero(double rate_hz, double within_hz);
/// Of those that fall above `from_hz` but on half a cycle a second or less.
[[nodiscard]] Message warningOfSlow(double rate_hz, double from_hz);

} // namespace lubberline
