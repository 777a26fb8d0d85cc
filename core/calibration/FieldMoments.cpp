#include "core/calibration/FieldMoments.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include "core/base/Alongside.h"
#include "core/base/Contract.h"
#include "core/base/VectorClones.h"

namespace lubberline {

namespace {

constexpr std::size_t kBlockPoints = 256; // nine columns of a block stay in the first cache
constexpr int kHighest = 4;

constexpr auto kPlaces = [] {
    std::array<std::array<std::array<std::size_t, kHighest + 1>, kHighest + 1>, kHighest + 1> places{};
    std::size_t next = 0;
    for (int degree = 0; degree <= kHighest; ++degree)
        for (int a = degree; a >= 0; --a)
            for (int b = degree - a; b >= 0; --b)
                places[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)][static_cast<std::size_t>(degree - a - b)] = next++;
    return places;
}();

/// The columns of a block.
enum Product { kX, kY, kZ, kXX, kXY, kXZ, kYY, kYZ, kZZ, kProducts };

struct Block {
    alignas(64) std::array<std::array<double, kBlockPoints>, kProducts> column;
};

/// The sums of a·b₁ … a·b₆ over a block.
LUBBERLINE_VECTOR_CLONES void addProducts(const double* a, const double* const* b, double* sums)
{
    FourDoubles s0{}, s1{}, s2{}, s3{}, s4{}, s5{};
    for (std::size_t i = 0; i < kBlockPoints; i += 4) {
        FourDoubles left, right;
        std::memcpy(&left, a + i, sizeof left);
        std::memcpy(&right, b[0] + i, sizeof right);
        s0 += left * right;
        std::memcpy(&right, b[1] + i, sizeof right);
        s1 += left * right;
        std::memcpy(&right, b[2] + i, sizeof right);
        s2 += left * right;
        std::memcpy(&right, b[3] + i, sizeof right);
        s3 += left * right;
        std::memcpy(&right, b[4] + i, sizeof right);
        s4 += left * right;
        std::memcpy(&right, b[5] + i, sizeof right);
        s5 += left * right;
    }
    sums[0] += (s0[0] + s0[1]) + (s0[2] + s0[3]);
    sums[1] += (s1[0] + s1[1]) + (s1[2] + s1[3]);
    sums[2] += (s2[0] + s2[1]) + (s2[2] + s2[3]);
    sums[3] += (s3[0] + s3[1]) + (s3[2] + s3[3]);
    sums[4] += (s4[0] + s4[1]) + (s4[2] + s4[3]);
    sums[5] += (s5[0] + s5[1]) + (s5[2] + s5[3]);
}

LUBBERLINE_VECTOR_CLONES void addSums(const Block& block, double* sums)
{
    for (std::size_t k = 0; k < kProducts; ++k) {
        const double* a = block.column[k].data();
        FourDoubles s0{}, s1{};
        for (std::size_t i = 0; i < kBlockPoints; i += 8) {
            FourDoubles one, two;
            std::memcpy(&one, a + i, sizeof one);
            std::memcpy(&two, a + i + 4, sizeof two);
            s0 += one;
            s1 += two;
        }
        s0 += s1;
        sums[k] += (s0[0] + s0[1]) + (s0[2] + s0[3]);
    }
}

LUBBERLINE_VECTOR_CLONES void fillProducts(Block& block)
{
    auto& c = block.column;
    for (std::size_t i = 0; i < kBlockPoints; ++i) {
        c[kXX][i] = c[kX][i] * c[kX][i];
        c[kXY][i] = c[kX][i] * c[kY][i];
        c[kXZ][i] = c[kX][i] * c[kZ][i];
        c[kYY][i] = c[kY][i] * c[kY][i];
        c[kYZ][i] = c[kY][i] * c[kZ][i];
        c[kZZ][i] = c[kZ][i] * c[kZ][i];
    }
}

LUBBERLINE_VECTOR_CLONES void fillBlock(
    Block& block, const double* x, const double* y, const double* z, const double* centre, double factor)
{
    auto& c = block.column;
    for (std::size_t i = 0; i < kBlockPoints; ++i) {
        c[kX][i] = (x[i] - centre[0]) * factor;
        c[kY][i] = (y[i] - centre[1]) * factor;
        c[kZ][i] = (z[i] - centre[2]) * factor;
    }
}

/// Of what is used; the rest is zero. @return how many are
LUBBERLINE_VECTOR_CLONES std::int64_t fillUsed(Block& block, const double* x, const double* y, const double* z, const std::uint8_t* used,
    std::size_t count, const double* centre, double factor)
{
    auto& c = block.column;
    std::int64_t points = 0;
    for (std::size_t i = 0; i < count; ++i) { // chosen and not multiplied: what is left out may be NaN
        const bool in = used[i] != 0;
        c[kX][i] = in ? (x[i] - centre[0]) * factor : 0.0;
        c[kY][i] = in ? (y[i] - centre[1]) * factor : 0.0;
        c[kZ][i] = in ? (z[i] - centre[2]) * factor : 0.0;
        points += in ? 1 : 0;
    }
    return points;
}

/// The products of a block whose X, Y and Z are filled; points that are not there are zero and add nothing.
void addBlock(Block& block, FieldMoments& moments)
{
    fillProducts(block);
    const auto of = [&](Product column) { return block.column[column].data(); };
    std::array<double, kProducts> sums{};
    addSums(block, sums.data());
    std::array<double, 6> bySquareX{}, bySquareY{}, bySquareZ{}, byX{}, byY{};
    const std::array<const double*, 6> pairs{of(kXX), of(kXY), of(kXZ), of(kYY), of(kYZ), of(kZZ)};
    const std::array<const double*, 6> forY{of(kYY), of(kYZ), of(kZZ), of(kYY), of(kYZ), of(kZZ)};
    const std::array<const double*, 6> forZ{of(kZ), of(kXY), of(kXZ), of(kYZ), of(kZZ), of(kZZ)};
    addProducts(of(kXX), pairs.data(), bySquareX.data());
    addProducts(of(kYY), pairs.data(), bySquareY.data());
    addProducts(of(kZZ), forZ.data(), bySquareZ.data());
    addProducts(of(kX), pairs.data(), byX.data());
    addProducts(of(kY), forY.data(), byY.data());
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c, double value) { moments.sum[kPlaces[a][b][c]] += value; };
    add(1, 0, 0, sums[kX]), add(0, 1, 0, sums[kY]), add(0, 0, 1, sums[kZ]);
    add(2, 0, 0, sums[kXX]), add(1, 1, 0, sums[kXY]), add(1, 0, 1, sums[kXZ]);
    add(0, 2, 0, sums[kYY]), add(0, 1, 1, sums[kYZ]), add(0, 0, 2, sums[kZZ]);
    add(3, 0, 0, byX[0]), add(2, 1, 0, byX[1]), add(2, 0, 1, byX[2]), add(1, 2, 0, byX[3]), add(1, 1, 1, byX[4]), add(1, 0, 2, byX[5]);
    add(0, 3, 0, byY[0]), add(0, 2, 1, byY[1]), add(0, 1, 2, byY[2]), add(0, 0, 3, bySquareZ[0]);
    add(4, 0, 0, bySquareX[0]), add(3, 1, 0, bySquareX[1]), add(3, 0, 1, bySquareX[2]);
    add(2, 2, 0, bySquareX[3]), add(2, 1, 1, bySquareX[4]), add(2, 0, 2, bySquareX[5]);
    add(1, 3, 0, bySquareY[1]), add(1, 2, 1, bySquareY[2]), add(0, 4, 0, bySquareY[3]), add(0, 3, 1, bySquareY[4]);
    add(0, 2, 2, bySquareY[5]), add(1, 1, 2, bySquareZ[1]), add(1, 0, 3, bySquareZ[2]), add(0, 1, 3, bySquareZ[3]);
    add(0, 0, 4, bySquareZ[4]);
}

} // namespace

double FieldMoments::of(int a, int b, int c) const
{
    LUBBERLINE_EXPECT(a >= 0 && b >= 0 && c >= 0 && a + b + c <= kHighest, "moments are known to the fourth order");
    return sum[kPlaces[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)][static_cast<std::size_t>(c)]];
}

namespace {

constexpr std::size_t kPart = 128 * kBlockPoints; ///< points that one hand sums: parts are added up in their order, whoever took which

/// Of the points [from, to).
void addPart(const FieldColumns& points, std::span<const std::uint8_t> used, std::size_t from, std::size_t to, FieldMoments& moments)
{
    constexpr auto allUsed = [] {
        std::array<std::uint8_t, kBlockPoints> all{};
        all.fill(1);
        return all;
    }();
    Block block;
    const double factor = 1.0 / moments.scale;
    for (; from < to; from += kBlockPoints) {
        const std::size_t here = std::min(kBlockPoints, to - from);
        const std::uint8_t* const mine = used.empty() ? allUsed.data() : used.data() + from;
        const double *x = points[0].data() + from, *y = points[1].data() + from, *z = points[2].data() + from;
        if (here == kBlockPoints && std::memchr(mine, 0, here) == nullptr) {
            fillBlock(block, x, y, z, moments.centre.data(), factor);
            moments.sum[0] += static_cast<double>(here);
        } else {
            for (std::size_t axis = 0; axis < 3; ++axis)
                std::fill(block.column[axis].begin() + static_cast<std::ptrdiff_t>(here), block.column[axis].end(), 0.0);
            moments.sum[0] += static_cast<double>(fillUsed(block, x, y, z, mine, here, moments.centre.data(), factor));
        }
        addBlock(block, moments);
    }
}

} // namespace

FieldMoments momentsOf(const FieldColumns& points, std::span<const std::uint8_t> used, const Eigen::Vector3d& centre, double scale)
{
    FieldMoments moments;
    moments.centre = centre;
    moments.scale = scale;
    const std::size_t count = points[0].size();
    std::vector<FieldMoments> parts((count + kPart - 1) / kPart, moments);
    alongside(
        parts.size(), [&](std::size_t part) { addPart(points, used, part * kPart, std::min(count, (part + 1) * kPart), parts[part]); });
    for (const FieldMoments& part : parts)
        for (std::size_t i = 0; i < moments.sum.size(); ++i)
            moments.sum[i] += part.sum[i];
    return moments;
}

} // namespace lubberline
