#include "core/calibration/Welch.h"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <mutex>

#include "core/angle/Angle.h"
#include "core/base/Contract.h"
#include "core/base/FourierPlanner.h"
#include "core/base/VectorClones.h"

namespace lubberline {

namespace {

struct FreeFourier {
    void operator()(void* memory) const { fftw_free(memory); }
};

/// A plan of one size with its arrays.
class SegmentTransform {
public:
    explicit SegmentTransform(std::size_t size)
        : m_in(static_cast<double*>(fftw_malloc(size * sizeof(double))))
        , m_out(static_cast<fftw_complex*>(fftw_malloc((size / 2 + 1) * sizeof(fftw_complex))))
    {
        const std::lock_guard lock(fourierPlannerMutex());
        m_plan = fftw_plan_dft_r2c_1d(static_cast<int>(size), m_in.get(), m_out.get(), FFTW_ESTIMATE);
    }
    ~SegmentTransform()
    {
        const std::lock_guard lock(fourierPlannerMutex());
        fftw_destroy_plan(m_plan);
    }
    SegmentTransform(const SegmentTransform&) = delete;
    SegmentTransform& operator=(const SegmentTransform&) = delete;

    [[nodiscard]] double* in() { return m_in.get(); }
    fftw_complex* run()
    {
        fftw_execute(m_plan);
        return m_out.get();
    }

private:
    std::unique_ptr<double, FreeFourier> m_in;
    std::unique_ptr<fftw_complex[], FreeFourier> m_out;
    fftw_plan m_plan = nullptr;
};

/// Samples times window into `in`; the sum of the samples in the same run through them.
LUBBERLINE_VECTOR_CLONES double putWindowed(const double* samples, const double* window, double* in, std::size_t count)
{
    FourDoubles first{}, second{};
    std::size_t i = 0;
    for (; i + 8 <= count; i += 8) {
        FourDoubles a, b, wa, wb;
        std::memcpy(&a, samples + i, sizeof a);
        std::memcpy(&b, samples + i + 4, sizeof b);
        std::memcpy(&wa, window + i, sizeof wa);
        std::memcpy(&wb, window + i + 4, sizeof wb);
        first += a;
        second += b;
        wa *= a;
        wb *= b;
        std::memcpy(in + i, &wa, sizeof wa);
        std::memcpy(in + i + 4, &wb, sizeof wb);
    }
    first += second;
    double sum = (first[0] + first[1]) + (first[2] + first[3]);
    for (; i < count; ++i) {
        sum += samples[i];
        in[i] = samples[i] * window[i];
    }
    return sum;
}

/// Squares of complex numbers, real and imaginary part in turns, added to a density.
LUBBERLINE_VECTOR_CLONES void addSquares(const double* parts, double* density, std::size_t count)
{
    std::size_t k = 0;
    for (; k + 4 <= count; k += 4) {
        FourDoubles a, b, sum;
        std::memcpy(&a, parts + 2 * k, sizeof a);
        std::memcpy(&b, parts + 2 * k + 4, sizeof b);
        std::memcpy(&sum, density + k, sizeof sum);
        a *= a;
        b *= b;
        sum += FourDoubles{a[0], a[2], b[0], b[2]} + FourDoubles{a[1], a[3], b[1], b[3]};
        std::memcpy(density + k, &sum, sizeof sum);
    }
    for (; k < count; ++k)
        density[k] += parts[2 * k] * parts[2 * k] + parts[2 * k + 1] * parts[2 * k + 1];
}

} // namespace

WelchSpectrum welch(std::span<const std::vector<double>> runs, std::size_t segment, double rate_hz)
{
    LUBBERLINE_EXPECT(segment >= 4 && segment % 2 == 0, "a segment is of an even number of samples");
    WelchSpectrum spectrum;
    spectrum.segment = segment;
    spectrum.step_hz = rate_hz / static_cast<double>(segment);
    spectrum.density.assign(segment / 2 + 1, 0.0);
    std::vector<double> window(segment);
    double power = 0;
    for (std::size_t i = 0; i < segment; ++i) {
        window[i] = 0.5 - 0.5 * std::cos(2.0 * kPi * static_cast<double>(i) / static_cast<double>(segment));
        power += window[i] * window[i];
    }
    SegmentTransform transform(segment);
    for (const auto& run : runs)
        for (std::size_t from = 0; from + segment <= run.size(); from += segment / 2) {
            const double* const samples = run.data() + from;
            double* const in = transform.in();
            const double sum = putWindowed(samples, window.data(), in, segment);
            // The window's own transform is N/2, −N/4 and 0: the mean is taken out where it is.
            fftw_complex* const out = transform.run();
            out[0][0] -= sum / 2;
            out[1][0] += sum / 4;
            addSquares(&out[0][0], spectrum.density.data(), spectrum.density.size());
            ++spectrum.segments;
        }
    const double factor = spectrum.segments > 0 ? 1.0 / (rate_hz * power * static_cast<double>(spectrum.segments)) : 0.0;
    for (std::size_t k = 0; k < spectrum.density.size(); ++k)
        spectrum.density[k] *= k == 0 || k == segment / 2 ? factor : 2.0 * factor;
    return spectrum;
}

} // namespace lubberline
