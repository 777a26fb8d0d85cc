#pragma once

#include <complex>
#include <vector>

namespace lubberline {

/// X_k = Σ_j x_j e^(−2πi jk/N), k = 0…N/2, by FFTW's real transform. Plans are made once a length and shared by all threads.
[[nodiscard]] std::vector<std::complex<double>> realTransform(const std::vector<double>& samples);

} // namespace lubberline
