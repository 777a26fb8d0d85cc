#pragma once
/// Real Fourier transforms by FFTW of a cube that is padded with zeros to twice its side, and back to that cube. Lines that
/// hold nothing but padding are not transformed: 7 of 12 parts of the work remain. Plans are made once a size and shared by
/// all threads.

#include <complex>
#include <cstddef>
#include <memory>

namespace lubberline {

class FourierGrid {
public:
    /// Too large sizes are the caller's business: it takes memory at once. @param cells of the cube along a side, > 0.
    explicit FourierGrid(int cells);

    [[nodiscard]] int cells() const { return m_cells; }
    [[nodiscard]] int side() const { return 2 * m_cells; }                                      ///< of the padded cube
    [[nodiscard]] std::size_t rowSize() const { return static_cast<std::size_t>(m_cells) + 1; } ///< complex numbers along z
    [[nodiscard]] std::size_t spectrumSize() const;                                             ///< side · side · rowSize()

    /// The cube, x slowest; each of its cells² rows along z has room for `side` numbers, of which the first `cells` are the
    /// cube's.
    [[nodiscard]] double* real() { return m_real.get(); }
    [[nodiscard]] std::complex<double>* spectrum() { return m_spectrum.get(); } ///< of forward(); kept by backward()
    [[nodiscard]] std::complex<double>* product() { return m_product.get(); }

    /// Plans both transforms if nobody has.
    void plan();
    void forward();  ///< real() → spectrum(), without a scale. @pre the second half of each row is 0
    void backward(); ///< product() → real(), without a scale; destroys product(). The second half of the rows is padding.

    static std::size_t memoryFor(int cells); ///< [bytes]

private:
    struct Free {
        void operator()(void* memory) const;
    };
    struct Plans;
    void clearPadding();
    int m_cells;
    std::unique_ptr<double[], Free> m_real;
    std::unique_ptr<std::complex<double>[], Free> m_spectrum, m_product;
    const Plans* m_plans = nullptr;
};

} // namespace lubberline
