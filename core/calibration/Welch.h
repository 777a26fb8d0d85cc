#pragma once
/// Power spectral density by Welch's method (IEEE Trans. AU-15, 70, 1967): periodic Hann window, segments that overlap by half, the mean
/// of each taken out. One-sided: the sum of density times step is the variance.

#include <cstddef>
#include <span>
#include <vector>

namespace lubberline {

struct WelchSpectrum {
    std::size_t segment = 0;  ///< samples
    std::size_t segments = 0; ///< averaged
    double step_hz = 0;
    std::vector<double> density; ///< at 0, step, 2 step …, in the square of the unit over Hz
};

/// @param runs stretches without a gap; those shorter than a segment add nothing. @param segment even, 4 and more
[[nodiscard]] WelchSpectrum welch(std::span<const std::vector<double>> runs, std::size_t segment, double rate_hz);

} // namespace lubberline
