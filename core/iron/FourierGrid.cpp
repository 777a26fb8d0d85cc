#include "core/iron/FourierGrid.h"

#include <fftw3.h>

#include <algorithm>
#include <map>
#include <new>

#include "core/base/Contract.h"
#include "core/base/FourierPlanner.h"

namespace lubberline {

/// Along one axis each. Forward z, y, x; backward x, y, z.
struct FourierGrid::Plans {
    fftw_plan forwardZ, forwardY, forwardX, backwardX, backwardY, backwardZ;
};

namespace {

/// FFTW's first guess: to try its ways takes a second, as much as is won in some sixty tensors, and other ways at other times
/// would mean other last digits.
constexpr unsigned kFlags = FFTW_ESTIMATE | FFTW_DESTROY_INPUT;

fftw_complex* asFftw(std::complex<double>* numbers) { return reinterpret_cast<fftw_complex*>(numbers); }

template <class Number>
Number* allocated(std::size_t count)
{
    void* memory = fftw_malloc(count * sizeof(Number));
    if (!memory)
        throw std::bad_alloc();
    return static_cast<Number*>(memory);
}

/// A line of `length` numbers `stride` apart, for each of two further axes; in place.
fftw_plan planLines(fftw_complex* data, fftw_iodim length, fftw_iodim outer, fftw_iodim inner, int sign)
{
    const fftw_iodim many[2] = {outer, inner};
    return fftw_plan_guru_dft(1, &length, 2, many, data, data, sign, kFlags);
}

} // namespace

void FourierGrid::Free::operator()(void* memory) const { fftw_free(memory); }

FourierGrid::FourierGrid(int cells) : m_cells(cells)
{
    LUBBERLINE_EXPECT(cells > 0, "a Fourier grid has cells");
    const auto n = static_cast<std::size_t>(cells);
    m_real.reset(allocated<double>(n * n * 2 * n));
    m_spectrum.reset(allocated<std::complex<double>>(spectrumSize()));
    m_product.reset(allocated<std::complex<double>>(spectrumSize()));
}

std::size_t FourierGrid::spectrumSize() const
{
    const auto padded = static_cast<std::size_t>(side());
    return padded * padded * rowSize();
}

std::size_t FourierGrid::memoryFor(int cells)
{
    const auto n = static_cast<std::size_t>(cells);
    return 2 * n * n * n * sizeof(double) + 2 * (4 * n * n * (n + 1)) * sizeof(std::complex<double>);
}

void FourierGrid::plan()
{
    // Kept until the program ends, and never destroyed: plans without their map would be reported as leaks.
    static auto& plans = *new std::map<int, Plans>;
    const std::lock_guard lock(fourierPlannerMutex());
    const auto [place, isNew] = plans.try_emplace(m_cells, Plans{});
    if (isNew) {
        const int n = m_cells, N = 2 * n, row = n + 1, plane = N * row;
        const fftw_iodim alongZ{N, 1, 1}, alongY{N, row, row}, alongX{N, plane, plane};
        const fftw_iodim halfX{n, plane, plane}, allY{N, row, row}, eachZ{row, 1, 1};
        const fftw_iodim rowsOut[2] = {{n, n * N, plane}, {n, N, row}}, rowsBack[2] = {{n, plane, n * N}, {n, row, N}};
        place->second = {fftw_plan_guru_dft_r2c(1, &alongZ, 2, rowsOut, real(), asFftw(spectrum()), kFlags),
            planLines(asFftw(spectrum()), alongY, halfX, eachZ, FFTW_FORWARD),
            planLines(asFftw(spectrum()), alongX, allY, eachZ, FFTW_FORWARD),
            planLines(asFftw(product()), alongX, allY, eachZ, FFTW_BACKWARD),
            planLines(asFftw(product()), alongY, halfX, eachZ, FFTW_BACKWARD),
            fftw_plan_guru_dft_c2r(1, &alongZ, 2, rowsBack, asFftw(product()), real(), kFlags)};
    }
    m_plans = &place->second;
}

/// Lines of padding, which forward() does not write but the other axes read.
void FourierGrid::clearPadding()
{
    const auto n = static_cast<std::size_t>(m_cells), halfPlane = n * rowSize();
    for (std::size_t x = 0; x < n; ++x)
        std::fill_n(spectrum() + (2 * x + 1) * halfPlane, halfPlane, 0.0);
    std::fill_n(spectrum() + 2 * n * halfPlane, 2 * n * halfPlane, 0.0);
}

void FourierGrid::forward()
{
    LUBBERLINE_EXPECT(m_plans, "a Fourier grid is planned before it is transformed");
    clearPadding();
    fftw_execute_dft_r2c(m_plans->forwardZ, real(), asFftw(spectrum()));
    fftw_execute_dft(m_plans->forwardY, asFftw(spectrum()), asFftw(spectrum()));
    fftw_execute_dft(m_plans->forwardX, asFftw(spectrum()), asFftw(spectrum()));
}

void FourierGrid::backward()
{
    LUBBERLINE_EXPECT(m_plans, "a Fourier grid is planned before it is transformed");
    fftw_execute_dft(m_plans->backwardX, asFftw(product()), asFftw(product()));
    fftw_execute_dft(m_plans->backwardY, asFftw(product()), asFftw(product()));
    fftw_execute_dft_c2r(m_plans->backwardZ, asFftw(product()), real());
}

} // namespace lubberline
