#include "core/iron/DemagnetisationTensor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>

#include "core/angle/Angle.h"
#include "core/base/Contract.h"
#include "core/iron/ShapeGeometry.h"

namespace lubberline {

namespace {

constexpr std::array<std::pair<int, int>, 6> kAxes{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
constexpr std::size_t kZz = 2; ///< known from the trace

std::size_t cellsOf(const TensorGrid& grid)
{
    const auto n = static_cast<std::size_t>(grid.cells);
    return n * n * n;
}

Result<void> check(const Shape& shape, const TensorGrid& grid)
{
    const Eigen::Vector3d size_m = sizeOf(shape);
    if (!size_m.allFinite() || size_m.minCoeff() <= 0 || !std::isfinite(grid.cell_m) || grid.cell_m <= 0)
        return Error{ErrorCode::InvalidInput, MARKED("core", "a body and the cells of its grid must have sizes above 0 m")};
    if (grid.cells < kFewestTensorCells)
        return Error{ErrorCode::InvalidInput,
            {MARKED("core", "a grid of %1 cells a side is too coarse; expected %2 or more"), grid.cells, kFewestTensorCells}};
    if (memoryFor(grid) > kMostTensorMemory)
        return Error{ErrorCode::InvalidInput,
            {MARKED("core", "a grid of %1 cells a side takes %2 MiB of memory; expected no more than %3 MiB"), grid.cells,
                memoryFor(grid) >> 20, kMostTensorMemory >> 20}};
    if (size_m.maxCoeff() > grid.cells * grid.cell_m * (1 + 1e-12))
        return Error{ErrorCode::InvalidInput, {MARKED("core", "the body is larger than its grid of %1 cells a side"), grid.cells}};
    return {};
}

/// The memory of the last transforms, for the next: to be given fresh pages by the system takes longer than the transforms'
/// sums.
class GridPool {
public:
    std::unique_ptr<FourierGrid> take(int cells)
    {
        {
            const std::lock_guard lock(m_mutex);
            if (m_grid && m_grid->cells() == cells)
                return std::move(m_grid);
        }
        return std::make_unique<FourierGrid>(cells);
    }
    void giveBack(std::unique_ptr<FourierGrid> grid)
    {
        constexpr int kLargestKept = 64; // 40 MB
        const std::lock_guard lock(m_mutex);
        if (grid->cells() <= kLargestKept)
            m_grid = std::move(grid);
    }

private:
    std::mutex m_mutex;
    std::unique_ptr<FourierGrid> m_grid;
};

GridPool& gridPool()
{
    static GridPool pool;
    return pool;
}

/// The wave numbers of the padded grid along one axis, in steps of 2π over its side.
struct WaveNumbers {
    std::vector<double> plain;
    std::vector<double> odd; ///< the highest has no sign: 0 where a product of two different axes needs one
    explicit WaveNumbers(int side)
    {
        for (int i = 0; i < side; ++i)
            plain.push_back(i <= side / 2 ? i : i - side);
        odd = plain;
        odd[static_cast<std::size_t>(side / 2)] = 0;
    }
};

/// (1 − cos kR)/k² by the square of the wave number in steps, R half the side of the padded grid: kR = π√m. Scaled by 1/side³.
std::vector<double> greensFunction(int side)
{
    const auto half = static_cast<std::size_t>(side / 2);
    std::vector<double> weights(3 * half * half + 1);
    const double scale = 1.0 / (static_cast<double>(side) * side * side);
    for (std::size_t m = 1; m < weights.size(); ++m)
        weights[m] = scale * (1 - std::cos(kPi * std::sqrt(static_cast<double>(m)))) / static_cast<double>(m);
    return weights;
}

void placeFill(const std::vector<float>& fill, int cells, FourierGrid& fourier)
{
    const auto n = static_cast<std::size_t>(cells);
    for (std::size_t row = 0; row < n * n; ++row) {
        double* to = std::copy_n(fill.data() + row * n, n, fourier.real() + 2 * row * n);
        std::fill_n(to, n, 0.0);
    }
}

/// F(k) → F(k) times the Green's function: once for all components.
void weigh(FourierGrid& fourier, const WaveNumbers& k)
{
    const auto side = static_cast<std::size_t>(fourier.side()), row = fourier.rowSize();
    const auto weights = greensFunction(fourier.side());
    std::complex<double>* values = fourier.spectrum();
    for (std::size_t x = 0; x < side; ++x)
        for (std::size_t y = 0; y < side; ++y, values += row) {
            const auto across = static_cast<std::size_t>(k.plain[x] * k.plain[x] + k.plain[y] * k.plain[y]);
            for (std::size_t z = 0; z < row; ++z)
                values[z] *= weights[across + z * z];
        }
}

/// product = k_i k_j times the weighed F(k).
void multiply(FourierGrid& fourier, const WaveNumbers& k, std::pair<int, int> axes)
{
    const auto side = static_cast<std::size_t>(fourier.side()), row = fourier.rowSize();
    const auto& one = axes.first == axes.second ? k.plain : k.odd;
    std::vector<double> alongZ(2 * row, 1.0); // real and imaginary part of each number alike
    for (std::size_t z = 0; z < row; ++z)
        for (const int axis : {axes.first, axes.second})
            if (axis == 2)
                alongZ[2 * z] = alongZ[2 * z + 1] *= one[z];
    const auto* from = reinterpret_cast<const double*>(fourier.spectrum());
    auto* to = reinterpret_cast<double*>(fourier.product());
    for (std::size_t x = 0; x < side; ++x)
        for (std::size_t y = 0; y < side; ++y, from += 2 * row, to += 2 * row) {
            double factor = 1;
            for (const int axis : {axes.first, axes.second})
                factor *= axis == 0 ? one[x] : axis == 1 ? one[y] : 1.0;
            for (std::size_t z = 0; z < 2 * row; ++z)
                to[z] = factor * alongZ[z] * from[z];
        }
}

std::vector<double> takeComponent(FourierGrid& fourier, int cells)
{
    const auto n = static_cast<std::size_t>(cells);
    std::vector<double> component;
    component.reserve(n * n * n);
    for (std::size_t row = 0; row < n * n; ++row)
        component.insert(component.end(), fourier.real() + 2 * row * n, fourier.real() + (2 * row + 1) * n);
    return component;
}

/// The trace of the tensor is the shape function.
std::vector<double> zzFromTrace(const DemagnetisationTensor& tensor)
{
    std::vector<double> zz(tensor.fill.size());
    for (std::size_t i = 0; i < zz.size(); ++i)
        zz[i] = static_cast<double>(tensor.fill[i]) - tensor.component[0][i] - tensor.component[1][i];
    return zz;
}

Eigen::Matrix3d matrixOf(const std::array<double, 6>& c)
{
    Eigen::Matrix3d matrix;
    matrix << c[0], c[3], c[4], c[3], c[1], c[5], c[4], c[5], c[2];
    return matrix;
}

/// Six cells in a row and their weights.
struct Taps {
    std::size_t first = 0;
    std::array<double, 6> weight{};
};

/// The B-spline of degree 5 at `x` cells from its middle.
double splineAt(double x)
{
    constexpr std::array<double, 7> kBinomials{1, -6, 15, -20, 15, -6, 1};
    double sum = 0;
    for (std::size_t j = 0; j < kBinomials.size(); ++j)
        sum += kBinomials[j] * std::pow(std::max(0.0, 3 - std::abs(x) - static_cast<double>(j)), 5);
    return sum / 120;
}

/// Weights at `place` (in cells, 0 at the centre of the first); beyond the borders the outermost slope goes on.
Taps tapsAt(double place, int cells)
{
    const int wanted = static_cast<int>(std::floor(place)) - 2;
    const int first = std::clamp(wanted, 0, cells - 6);
    Taps taps{static_cast<std::size_t>(first), {}};
    for (int i = wanted; i < wanted + 6; ++i) {
        const double weight = splineAt(place - i);
        const int inside = std::clamp(i, 0, cells - 1), neighbour = i < 0 ? 1 : i >= cells ? cells - 2 : inside;
        const double beyond = std::abs(i - inside);
        taps.weight[static_cast<std::size_t>(inside - first)] += weight * (1 + beyond);
        taps.weight[static_cast<std::size_t>(neighbour - first)] -= weight * beyond;
    }
    return taps;
}

/// The normal of the surface in a cell, by the slope of the fill; of any length.
Eigen::Vector3d slopeOf(const DemagnetisationTensor& tensor, std::size_t cell)
{
    const auto n = static_cast<std::size_t>(tensor.grid.cells);
    const auto along = [&](std::size_t stride) {
        const std::size_t place = cell / stride % n;
        const double before = place > 0 ? static_cast<double>(tensor.fill[cell - stride]) : 0.0;
        const double after = place + 1 < n ? static_cast<double>(tensor.fill[cell + stride]) : 0.0;
        return after - before;
    };
    return {along(n * n), along(n), along(1)};
}

} // namespace

std::size_t memoryFor(const TensorGrid& grid)
{
    constexpr double kCounted = 1e18;
    const double cells = std::max(0, grid.cells);
    if (8 * cells * cells * cells * 30 > kCounted)
        return std::numeric_limits<std::size_t>::max();
    return FourierGrid::memoryFor(std::max(0, grid.cells)) + cellsOf({std::max(0, grid.cells), 1}) * (sizeof(float) + 6 * sizeof(double));
}

Result<DemagnetisationTensor> demagnetisationTensor(const Shape& shape, const TensorGrid& grid, const Progress& progress)
{
    if (const auto checked = check(shape, grid); !checked)
        return checked.error();
    const auto goesOn = [&](double done) { return !progress || progress(done); };
    const Error cancelled{ErrorCode::Cancelled, MARKED("core", "the demagnetisation tensor was cancelled")};
    if (!goesOn(0))
        return cancelled;

    DemagnetisationTensor tensor{grid, fillOf(shape, grid.cells, grid.cell_m), {}};
    auto memory = gridPool().take(grid.cells);
    FourierGrid& fourier = *memory;
    fourier.plan();
    placeFill(tensor.fill, grid.cells, fourier);
    fourier.forward();
    const WaveNumbers k(fourier.side());
    weigh(fourier, k);
    for (std::size_t i = 0; i < kAxes.size(); ++i) {
        if (i == kZz)
            continue;
        if (!goesOn((1.0 + static_cast<double>(i)) / 7))
            return cancelled;
        multiply(fourier, k, kAxes[i]);
        fourier.backward();
        tensor.component[i] = takeComponent(fourier, grid.cells);
    }
    gridPool().giveBack(std::move(memory));
    tensor.component[kZz] = zzFromTrace(tensor);
    return goesOn(1) ? Result(std::move(tensor)) : cancelled;
}

Eigen::Matrix3d DemagnetisationTensor::at(const Eigen::Vector3d& place_m) const
{
    const double half_m = grid.cells * grid.cell_m / 2;
    LUBBERLINE_EXPECT(place_m.lpNorm<Eigen::Infinity>() <= half_m * (1 + 1e-12), "a tensor is asked within its grid");
    const auto n = static_cast<std::size_t>(grid.cells);
    std::array<Taps, 3> taps;
    for (int axis = 0; axis < 3; ++axis)
        taps[static_cast<std::size_t>(axis)] = tapsAt((place_m[axis] + half_m) / grid.cell_m - 0.5, grid.cells);
    std::array<double, 6> value{};
    for (std::size_t x = 0; x < 6; ++x)
        for (std::size_t y = 0; y < 6; ++y)
            for (std::size_t z = 0; z < 6; ++z) {
                const double weight = taps[0].weight[x] * taps[1].weight[y] * taps[2].weight[z];
                const std::size_t cell = ((taps[0].first + x) * n + taps[1].first + y) * n + taps[2].first + z;
                for (std::size_t i = 0; i < value.size(); ++i)
                    value[i] += weight * component[i][cell];
            }
    return matrixOf(value);
}

Eigen::Matrix3d DemagnetisationTensor::averageInside() const
{
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    double volume = 0;
    for (std::size_t cell = 0; cell < fill.size(); ++cell) {
        const double part = static_cast<double>(fill[cell]);
        if (part <= 0)
            continue;
        std::array<double, 6> value{};
        for (std::size_t i = 0; i < value.size(); ++i)
            value[i] = component[i][cell];
        sum += part * matrixOf(value);
        if (part < 1) {
            const Eigen::Vector3d slope = slopeOf(*this, cell);
            const double length2 = slope.squaredNorm();
            if (length2 > 0)
                sum += part * (1 - part) * slope * slope.transpose() / length2;
        }
        volume += part;
    }
    return sum / volume;
}

} // namespace lubberline
