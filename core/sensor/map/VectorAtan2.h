#pragma once
/// Many arc tangents at once, as wide as the processor's vectors are (chosen when the program runs).

#include <cstddef>

namespace lubberline {

/// out[i] = atan2(y[i], x[i]) [rad, (−π, π]], within 4 units in the last place of the C library's (glibc's libmvec). y and x are
/// finite; where both are 0 the result is finite and means nothing. The arrays do not overlap.
void vectorAtan2(const double* y, const double* x, double* out, std::size_t count);

/// Numerator and denominator of an arc tangent as trigonometric polynomials of second degree: Σ over (1, cos x, sin x, cos 2x,
/// sin 2x).
struct TrigonometricRow {
    double sine[5];   ///< of the numerator
    double cosine[5]; ///< of the denominator
};

/// out[i] = atan2(numerator, denominator), as above, where cos x and sin x stand in `cosine` and `sine`.
/// @return the smallest numerator² + denominator² of the row: where it is small, the angles are not exact.
double vectorAngles(const TrigonometricRow& row, const double* cosine, const double* sine, double* out, std::size_t count);

} // namespace lubberline
