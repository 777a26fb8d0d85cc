#include "core/calibration/Welch.h"

#include <fftw3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <mutex>

#include "core/angle/Angle.h"
#include "core/base/Contract.h"
#include "core/base/FourierPlanner.h"

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
    const fftw_complex* run()
    {
        fftw_execute(m_plan);
        return m_out.get();
    }

private:
    std::unique_ptr<double, FreeFourier> m_in;
    std::unique_ptr<fftw_complex[], FreeFourier> m_out;
    fftw_plan m_plan = nullptr;
};

/// In eight sums that do not wait for each other.
double sumOf(const double* values, std::size_t count)
{
    std::array<double, 8> sums{};
    std::size_t i = 0;
    for (; i + sums.size() <= count; i += sums.size())
        for (std::size_t k = 0; k < sums.size(); ++k)
            sums[k] += values[i + k];
    double sum = 0;
    for (; i < count; ++i)
        sum += values[i];
    for (const double one : sums)
        sum += one;
    return sum;
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
            const double mean = sumOf(samples, segment) / static_cast<double>(segment);
            for (std::size_t i = 0; i < segment; ++i)
                in[i] = (samples[i] - mean) * window[i];
            const fftw_complex* const out = transform.run();
            double* const density = spectrum.density.data();
            for (std::size_t k = 0; k < spectrum.density.size(); ++k)
                density[k] += out[k][0] * out[k][0] + out[k][1] * out[k][1];
            ++spectrum.segments;
        }
    const double factor = spectrum.segments > 0 ? 1.0 / (rate_hz * power * static_cast<double>(spectrum.segments)) : 0.0;
    for (std::size_t k = 0; k < spectrum.density.size(); ++k)
        spectrum.density[k] *= k == 0 || k == segment / 2 ? factor : 2.0 * factor;
    return spectrum;
}

} // namespace lubberline
