#include "core/calibration/QuickLook.h"

#include <algorithm>
#include <cstring>

#include "core/base/VectorClones.h"

namespace lubberline {

namespace {

constexpr double kLargest = std::numeric_limits<double>::max();

/// The finite ends of a block: no comparison with NaN is true.
LUBBERLINE_VECTOR_CLONES void endsOfBlock(const double* values, std::size_t count, double* lowest, double* highest)
{
    constexpr double infinite = std::numeric_limits<double>::infinity();
    FourDoubles low{infinite, infinite, infinite, infinite}, high{-infinite, -infinite, -infinite, -infinite};
    const FourDoubles least{-kLargest, -kLargest, -kLargest, -kLargest}, most{kLargest, kLargest, kLargest, kLargest};
    std::size_t i = 0;
    for (; i + 4 <= count; i += 4) {
        FourDoubles x;
        std::memcpy(&x, values + i, sizeof x);
        low = ((x < low) & (x >= least)) ? x : low;
        high = ((x > high) & (x <= most)) ? x : high;
    }
    double below = std::min(std::min(low[0], low[1]), std::min(low[2], low[3]));
    double above = std::max(std::max(high[0], high[1]), std::max(high[2], high[3]));
    for (; i < count; ++i) {
        below = values[i] < below && values[i] >= -kLargest ? values[i] : below;
        above = values[i] > above && values[i] <= kLargest ? values[i] : above;
    }
    *lowest = below;
    *highest = above;
}

LUBBERLINE_VECTOR_CLONES std::int64_t rowsAt(const double* values, std::size_t count, double figure)
{
    std::int64_t rows = 0;
    for (std::size_t i = 0; i < count; ++i)
        rows += values[i] == figure ? 1 : 0;
    return rows;
}

void addEnds(const double* values, std::size_t count, AxisEnds& ends)
{
    double lowest = 0, highest = 0;
    endsOfBlock(values, count, &lowest, &highest);
    const auto at = [&](double end) { return static_cast<std::size_t>(rowsAt(values, count, end)); };
    if (lowest <= ends.lowest) {
        ends.atLowest = at(lowest) + (lowest == ends.lowest ? ends.atLowest : 0);
        ends.lowest = lowest;
    }
    if (highest >= ends.highest) {
        ends.atHighest = at(highest) + (highest == ends.highest ? ends.atHighest : 0);
        ends.highest = highest;
    }
}

inline double offMiddle(double a, double b, double c, double d, double e)
{
    const auto least = [](double one, double other) { return one < other ? one : other; };
    const auto most = [](double one, double other) { return one < other ? other : one; };
    // Neither the least of four nor the most of them is the middle of five.
    const double inner = most(least(a, b), least(d, e)), outer = least(most(a, b), most(d, e));
    const double middle = most(least(inner, outer), least(c, most(inner, outer)));
    const double nothing = (a - a) + (b - b) + (d - d) + (e - e); // or NaN
    return c - middle + nothing;
}

LUBBERLINE_VECTOR_CLONES void fillOffMiddle(const double* v, std::size_t count, double* away)
{
    for (std::size_t i = 0; i < count; ++i)
        away[i] = offMiddle(v[i], v[i + 1], v[i + 2], v[i + 3], v[i + 4]);
}

/// Rows that leave the middle of five by more than a limit.
LUBBERLINE_VECTOR_CLONES std::int64_t leaving(const double* v, std::size_t count, double limit)
{
    std::int64_t rows = 0;
    for (std::size_t i = 0; i < count; ++i)
        rows += std::abs(offMiddle(v[i], v[i + 1], v[i + 2], v[i + 3], v[i + 4])) > limit ? 1 : 0;
    return rows;
}

/// Rows behind the first that have no whole field, or are the row before once more.
LUBBERLINE_VECTOR_CLONES std::int64_t incompleteRows(const double* x, const double* y, const double* z, std::size_t count)
{
    std::int64_t rows = 0;
    for (std::size_t i = 1; i < count; ++i) {
        const double nothing = (x[i] - x[i]) + (y[i] - y[i]) + (z[i] - z[i]);
        const bool whole = nothing == 0, again = (x[i] == x[i - 1]) & (y[i] == y[i - 1]) & (z[i] == z[i - 1]);
        rows += !whole | again ? 1 : 0;
    }
    return rows;
}

bool standsSomewhere(const std::vector<double>& values)
{
    constexpr std::size_t apart = kStuckRows / 2;
    for (std::size_t row = 0; row + apart < values.size(); row += apart)
        if (values[row] == values[row + apart])
            return true;
    return false;
}

} // namespace

void awayFromMiddle(const double* v, std::size_t count, double* away) { fillOffMiddle(v, count, away); }

QuickLook lookOver(const SensorLog& log, const std::array<double, 3>& limits)
{
    constexpr std::size_t block = 1024; // rows of three axes stay in the first cache
    constexpr std::size_t reach = 4;    // of five rows behind the first
    QuickLook look;
    const std::size_t rows = log.size();
    look.incomplete = rows > 0 && !log.hasField(0);
    for (std::size_t from = 0; from < rows; from += block) {
        const std::size_t to = std::min(from + block, rows);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double* const values = log.field[axis].data();
            addEnds(values + from, to - from, look.ends[axis]);
            if (rows > reach && from < rows - reach && !look.leaves[axis])
                look.leaves[axis] = leaving(values + from, std::min(to, rows - reach) - from, limits[axis]) > 0;
        }
        const std::size_t first = from > 0 ? from - 1 : 0;
        look.incomplete
            = look.incomplete || incompleteRows(&log.field[0][first], &log.field[1][first], &log.field[2][first], to - first) > 0;
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
        look.stands[axis] = standsSomewhere(log.field[axis]);
    return look;
}

} // namespace lubberline
