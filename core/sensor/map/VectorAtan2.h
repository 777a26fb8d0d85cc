#pragma once
/// Many arc tangents at once, as wide as the processor's vectors are (chosen when the program runs).

#include <cstddef>

namespace lubberline {

/// out[i] = atan2(y[i], x[i]) [rad], within 4 units in the last place of the C library's (glibc's libmvec); [−π, π]. Where both
/// are 0 the result is finite and means nothing. The arrays do not overlap.
void vectorAtan2(const double* y, const double* x, double* out, std::size_t count);

/// Numerator and denominator of an arc tangent as trigonometric polynomials of second degree: Σ over (1, cos x, sin x, cos 2x,
/// sin 2x).
struct TrigonometricRow {
    double sine[5];   ///< of the numerator
    double cosine[5]; ///< of the denominator
};

/// cosine[i] and sine[i] of many angles [rad], within a few units in the last place.
void vectorCircle(const double* angle_rad, double* cosine, double* sine, std::size_t count);

/// out[i] = atan2(numerator, denominator) [rad, [−π, π]] where cos x and sin x stand in `cosine` and `sine`.
void vectorAngles(const TrigonometricRow& row, const double* cosine, const double* sine, double* out, std::size_t count);
/// The same in (−π, π]. @return the smallest numerator² + denominator² of the row: where it is small, the angles are not exact.
double vectorAnglesWithSize(const TrigonometricRow& row, const double* cosine, const double* sine, double* out, std::size_t count);

} // namespace lubberline
