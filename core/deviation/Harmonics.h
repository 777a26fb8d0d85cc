#pragma once
/// Fourier harmonics of deviation against magnetic (or compass) heading:
///   δ(ψ) = c0 + Σ_n (s_n sin nψ + c_n cos nψ);  A = c0, B = s_1, C = c_1, D = s_2, E = c_2        (docs/model.md, Harmonics)

#include <optional>
#include <span>
#include <vector>

#include "core/deviation/Smith.h"

namespace lubberline {

enum class HarmonicsMethod { Fft, LeastSquares };

struct HarmonicOrder {
    int order = 0;
    double sin_rad = 0;
    double cos_rad = 0;
    std::optional<double> standardError_rad; ///< of each of the two
    bool nyquist = false;                    ///< order N/2 of N even: only its cosine can be seen, so its sine is 0 and unknown
    [[nodiscard]] double amplitude_rad() const;
    /// φ of amplitude · sin(nψ + φ), that is atan2(cos, sin) [rad]; 0 for order 0.
    [[nodiscard]] double phase_rad() const;
};

struct Harmonics {
    HarmonicsMethod method = HarmonicsMethod::Fft;
    int highestResolvable = 0; ///< what the headings resolve; `orders` may be cut shorter on request
    double conditionNumber = 1;
    std::vector<HarmonicOrder> orders; ///< 0, 1, 2, …
    /// Amplitude that pure noise stays below 95 times in 100, from the residuals of the orders above 2 (F distribution);
    /// none without degrees of freedom.
    std::optional<double> noiseFloor_rad;
};

/// One deviation on one heading; headings [rad] in any order.
struct HarmonicSample {
    double heading_rad = 0;
    double deviation_rad = 0;
};

/// FFT (FFTW real transform, one plan a length, shared by all threads) when the headings are equally spaced to 1e-6°, least
/// squares otherwise, up to the highest order that spacing and condition support. `maxOrder` < 0: all.
/// Errors: InvalidInput (no samples, not finite).
Result<Harmonics> harmonics(std::span<const HarmonicSample> samples, int maxOrder = -1);

} // namespace lubberline
