// The demagnetisation tensor of 64³ cells, padded to 128³, against the Fourier transforms that it needs: one real one forward
// and five backward (the sixth component is known from the trace), as bare three-dimensional transforms of 128³ that are
// planned as ours are. Limit: 1.3 times. Beside it, for knowledge: the same transforms as they are made here, without the lines that
// hold only padding.

#include <fftw3.h>

#include <algorithm>
#include <cstdio>

#include "core/iron/DemagnetisationTensor.h"
#include "tests/bench/Ratio.h"

namespace {

constexpr int kCells = 64;
constexpr int kBackward = 5;

/// FFTW alone. The time does not depend on the numbers, so they are 0 and stay 0.
class BareTransforms {
public:
    BareTransforms()
    {
        m_forward = fftw_plan_dft_r2c_3d(kSide, kSide, kSide, m_real, m_spectrum, FFTW_ESTIMATE);
        m_backward = fftw_plan_dft_c2r_3d(kSide, kSide, kSide, m_spectrum, m_real, FFTW_ESTIMATE);
        std::fill_n(m_real, kSide * kSide * kSide, 0.0);
        std::fill_n(reinterpret_cast<double*>(m_spectrum), kSide * kSide * (kSide + 2), 0.0);
    }
    ~BareTransforms()
    {
        fftw_destroy_plan(m_forward);
        fftw_destroy_plan(m_backward);
        fftw_free(m_real);
        fftw_free(m_spectrum);
    }
    BareTransforms(const BareTransforms&) = delete;
    BareTransforms& operator=(const BareTransforms&) = delete;

    void run() const
    {
        fftw_execute(m_forward);
        for (int i = 0; i < kBackward; ++i)
            fftw_execute(m_backward);
    }

private:
    static constexpr int kSide = 2 * kCells;
    double* m_real = fftw_alloc_real(kSide * kSide * kSide);
    fftw_complex* m_spectrum = fftw_alloc_complex(kSide * kSide * (kSide / 2 + 1));
    fftw_plan m_forward, m_backward;
};

} // namespace

int main()
{
    using namespace lubberline;
    double sum = 0; // used, so that nothing is optimised away
    const auto tensor = [&] { sum += demagnetisationTensor(Sphere{1}, {kCells, 1.0 / 32})->component[0][0]; };
    const BareTransforms bare;
    FourierGrid ours(kCells);
    ours.plan();
    std::fill_n(ours.real(), 2 * kCells * kCells * kCells, 0.0);
    std::fill_n(ours.product(), ours.spectrumSize(), 0.0);
    const auto transforms = [&] {
        ours.forward();
        for (int i = 0; i < kBackward; ++i)
            ours.backward();
    };

    const auto timing = bench::compare(
        tensor, [&] { bare.run(); }, 15);
    const auto pruned = bench::compare(
        transforms, [&] { bare.run(); }, 15);
    std::fprintf(stderr, "%d cells a side, padded to %d; %.0f MiB; checksum %g; our transforms alone: %.2f x the bare ones\n", kCells,
        2 * kCells, static_cast<double>(memoryFor({kCells, 1})) / (1 << 20), sum, pruned.ratio());
    return bench::report("demagnetisation tensor", timing, "six bare transforms", 1.3) ? 0 : 1;
}
