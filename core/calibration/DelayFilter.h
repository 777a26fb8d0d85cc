#pragma once
/// Filters against the lines of a spectrum under a delay that may not be more.

#include <optional>
#include <span>
#include <vector>

namespace lubberline {

/// Notches of second order (Q 5) and a low-pass of first order, whose delays at low frequency add up: 1/(2π f Q) and 1/(2π f).
struct DelayFilter {
    std::vector<double> notches_hz;
    std::optional<double> lowPass_hz;
    double delay_ms = 0;
    double before_rms = 0, left_rms = 0; ///< above `from_hz`, where what moves is no turn of the aircraft
    double from_hz = 1;
};

/// |H|² of the filter at a frequency.
[[nodiscard]] double gainSquared(const DelayFilter& filter, double frequency_hz);

/// Notches one after the other, each time the one that leaves least, as long as that helps; what delay is left goes to the low-pass.
/// @param frequency_hz from 0 in even steps, with the density at each. @param lines_hz what a notch may stand at
[[nodiscard]] DelayFilter chooseFilter(
    std::span<const double> frequency_hz, std::span<const double> density, std::span<const double> lines_hz, double maxDelay_ms);

} // namespace lubberline
