// Compiled with -O3 -ffast-math (CMakeLists.txt), so that the loops become vectors and arc tangents those of libmvec.
// Each loop is compiled for plain x86-64, for AVX2 and for AVX-512, and the best that the processor has is taken.

#include "core/sensor/map/VectorAtan2.h"

#include <cmath>

#include "core/angle/Angle.h"

// The body of a loop as three functions, and one that chooses. Loops must be inlined into each, so that its instructions are
// used.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define LUBBERLINE_EACH_WIDTH(result, name, loop, parameters, arguments)                                                                   \
    [[gnu::target("avx512f,avx512dq,fma")]] static result name##Avx512 parameters { return loop arguments; }                               \
    [[gnu::target("avx2,fma")]] static result name##Avx2 parameters { return loop arguments; }                                             \
    result name parameters                                                                                                                 \
    {                                                                                                                                      \
        if (width() == Width::Avx512)                                                                                                      \
            return name##Avx512 arguments;                                                                                                 \
        if (width() == Width::Avx2)                                                                                                        \
            return name##Avx2 arguments;                                                                                                   \
        return loop arguments;                                                                                                             \
    }
#else
#define LUBBERLINE_EACH_WIDTH(result, name, loop, parameters, arguments)                                                                   \
    result name parameters { return loop arguments; }
#endif

namespace lubberline {

namespace {

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
enum class Width { Plain, Avx2, Avx512 };

Width widthOfProcessor()
{
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
        return Width::Avx512;
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") ? Width::Avx2 : Width::Plain;
}

Width width()
{
    static const Width found = widthOfProcessor();
    return found;
}
#endif

[[gnu::always_inline]] inline void atan2Loop(
    const double* __restrict y, const double* __restrict x, double* __restrict out, std::size_t count)
{
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = std::atan2(y[i], x[i]);
        out[i] = angle <= -kPi ? kPi : angle;
    }
}

/// Both polynomials of a stretch of the row, by cos 2x = 1 − 2 sin² x and sin 2x = 2 sin x cos x. Apart from the arc tangents:
/// around a call the coefficients would leave the registers.
/// @return the smallest numerator² + denominator².
[[gnu::always_inline]] inline double sidesLoop(const TrigonometricRow& row, const double* __restrict c, const double* __restrict s,
    std::size_t count, double* __restrict numerator, double* __restrict denominator)
{
    const double n0 = row.sine[0] + row.sine[3], n1 = row.sine[1], n2 = row.sine[2], n3 = -2 * row.sine[3], n4 = 2 * row.sine[4];
    const double d0 = row.cosine[0] + row.cosine[3], d1 = row.cosine[1], d2 = row.cosine[2], d3 = -2 * row.cosine[3],
                 d4 = 2 * row.cosine[4];
    double least = 1e300;
    for (std::size_t i = 0; i < count; ++i) {
        const double up = n0 + n1 * c[i] + s[i] * (n2 + n3 * s[i] + n4 * c[i]);
        const double across = d0 + d1 * c[i] + s[i] * (d2 + d3 * s[i] + d4 * c[i]);
        numerator[i] = up;
        denominator[i] = across;
        const double square = up * up + across * across;
        least = square < least ? square : least;
    }
    return least;
}

constexpr std::size_t kStretch = 512; // two of these stay in the nearest cache

[[gnu::always_inline]] inline double anglesLoop(
    const TrigonometricRow& row, const double* cosine, const double* sine, double* __restrict out, std::size_t count)
{
    double numerator[kStretch], denominator[kStretch];
    double least = 1e300;
    for (std::size_t begin = 0; begin < count; begin += kStretch) {
        const std::size_t size = count - begin < kStretch ? count - begin : kStretch;
        const double here = sidesLoop(row, cosine + begin, sine + begin, size, numerator, denominator);
        least = here < least ? here : least;
        atan2Loop(numerator, denominator, out + begin, size);
    }
    return least;
}

} // namespace

LUBBERLINE_EACH_WIDTH(void, vectorAtan2, atan2Loop, (const double* y, const double* x, double* out, std::size_t count), (y, x, out, count))
LUBBERLINE_EACH_WIDTH(double, vectorAngles, anglesLoop,
    (const TrigonometricRow& row, const double* cosine, const double* sine, double* out, std::size_t count),
    (row, cosine, sine, out, count))

} // namespace lubberline
