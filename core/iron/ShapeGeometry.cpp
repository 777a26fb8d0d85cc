#include "core/iron/ShapeGeometry.h"

#include <algorithm>
#include <cmath>

#include "core/angle/Angle.h"
#include "core/base/Cases.h"

namespace lubberline {

namespace {

/// Samples across a cell, where the height of the chord depends on the direction: 64 chords through each cell.
constexpr int kSamples = 8;

/// Half the length of the chord along z at (x, y) inside the box around the shape; 0 where none is.
double halfChord(const Shape& shape, double x, double y)
{
    const auto ellipse = [](double rest) { return rest > 0 ? std::sqrt(rest) : 0.0; };
    return std::visit(Cases{[](const Box& box) { return box.size_m.z() / 2; },
                          [&](const Cylinder& cylinder) { return ellipse(cylinder.diameter_m * cylinder.diameter_m / 4 - y * y); },
                          [&](const Sphere& sphere) { return ellipse(sphere.diameter_m * sphere.diameter_m / 4 - x * x - y * y); },
                          [&](const Ellipsoid& ellipsoid) {
                              const double u = 2 * x / ellipsoid.size_m.x(), v = 2 * y / ellipsoid.size_m.y();
                              return ellipsoid.size_m.z() / 2 * ellipse(1 - u * u - v * v);
                          }},
        shape);
}

struct Sample {
    std::size_t cell = 0;
    double place_m = 0, weight = 0; ///< weight: part of the cell that it stands for
};

/// Samples along one axis in the lower half of the cells, only where the shape is: a rod thinner than a cell gets as many as a
/// thick one.
std::vector<Sample> samplesAlong(double half_m, int cells, double cell_m, int perCell)
{
    std::vector<Sample> samples;
    for (int i = 0; i < (cells + 1) / 2; ++i) {
        const double begin_m = (i - cells / 2.0) * cell_m;
        const double from_m = std::max(begin_m, -half_m), to_m = std::min(begin_m + cell_m, half_m);
        for (int s = 0; s < perCell && to_m > from_m; ++s)
            samples.push_back(
                {static_cast<std::size_t>(i), from_m + (to_m - from_m) * (s + 0.5) / perCell, (to_m - from_m) / (cell_m * perCell)});
    }
    return samples;
}

/// Adds a chord from −half to +half to the cells of a column.
void addChord(float* column, int cells, double cell_m, double half_m, double weight)
{
    const double middle = cells / 2.0, reach = half_m / cell_m;
    const int last = std::min(cells - 1, static_cast<int>(std::floor(middle + reach)));
    for (int k = std::max(0, static_cast<int>(std::floor(middle - reach))); k <= last; ++k) {
        const double from = std::max(k - middle, -reach), to = std::min(k + 1 - middle, reach);
        column[k] += static_cast<float>(weight * std::max(0.0, to - from));
    }
}

/// All shapes are their own mirror images: from the columns with x and y in the lower half to all others.
void mirror(std::vector<float>& fill, std::size_t n)
{
    const auto column = [&](std::size_t x, std::size_t y) { return fill.data() + (x * n + y) * n; };
    for (std::size_t x = 0; x < (n + 1) / 2; ++x) {
        for (std::size_t y = (n + 1) / 2; y < n; ++y)
            std::copy_n(column(x, n - 1 - y), n, column(x, y));
        if (x != n - 1 - x)
            std::copy_n(column(x, 0), n * n, column(n - 1 - x, 0));
    }
}

/// Scales the cells that are filled in part, so that all together hold the volume.
void makeVolumeExact(std::vector<float>& fill, double cellsFilled)
{
    constexpr float kFull = 1 - 1e-5F;
    double full = 0, partly = 0;
    for (float& part : fill) {
        part = part > kFull ? 1.0F : part;
        (part > kFull ? full : partly) += part;
    }
    if (partly <= 0)
        return;
    const auto factor = static_cast<float>((cellsFilled - full) / partly);
    for (float& part : fill)
        if (part < 1)
            part = std::clamp(part * factor, 0.0F, 1.0F);
}

} // namespace

Eigen::Vector3d sizeOf(const Shape& shape)
{
    return std::visit(Cases{[](const Box& box) -> Eigen::Vector3d { return box.size_m; },
                          [](const Cylinder& cylinder) -> Eigen::Vector3d {
                              return {cylinder.length_m, cylinder.diameter_m, cylinder.diameter_m};
                          },
                          [](const Ellipsoid& ellipsoid) -> Eigen::Vector3d { return ellipsoid.size_m; },
                          [](const Sphere& sphere) -> Eigen::Vector3d { return Eigen::Vector3d::Constant(sphere.diameter_m); }},
        shape);
}

double largestLength_m(const Shape& shape) { return sizeOf(shape).maxCoeff(); }

double volume_m3(const Shape& shape)
{
    const double around_m3 = sizeOf(shape).prod();
    return std::visit(Cases{[&](const Box&) { return around_m3; }, [&](const Cylinder&) { return kPi / 4 * around_m3; },
                          [&](const auto&) { return kPi / 6 * around_m3; }},
        shape);
}

bool contains(const Shape& shape, const Eigen::Vector3d& place_m)
{
    const Eigen::Vector3d half_m = sizeOf(shape) / 2;
    const Eigen::Vector3d part = place_m.cwiseQuotient(half_m);
    return std::visit(Cases{[&](const Box&) { return part.lpNorm<Eigen::Infinity>() <= 1; },
                          [&](const Cylinder&) { return std::abs(part.x()) <= 1 && std::hypot(part.y(), part.z()) <= 1; },
                          [&](const auto&) { return part.norm() <= 1; }},
        shape);
}

Shape scaled(const Shape& shape, double factor)
{
    return std::visit(Cases{[&](const Box& box) -> Shape { return Box{box.size_m * factor}; },
                          [&](const Cylinder& cylinder) -> Shape {
                              return Cylinder{cylinder.diameter_m * factor, cylinder.length_m * factor};
                          },
                          [&](const Ellipsoid& ellipsoid) -> Shape { return Ellipsoid{ellipsoid.size_m * factor}; },
                          [&](const Sphere& sphere) -> Shape { return Sphere{sphere.diameter_m * factor}; }},
        shape);
}

std::vector<float> fillOf(const Shape& shape, int cells, double cell_m)
{
    const auto n = static_cast<std::size_t>(cells);
    std::vector<float> fill(n * n * n);
    const Eigen::Vector3d half_m = sizeOf(shape) / 2;
    const bool straight = std::holds_alternative<Box>(shape);
    const auto alongX = samplesAlong(half_m.x(), cells, cell_m, straight || std::holds_alternative<Cylinder>(shape) ? 1 : kSamples);
    const auto alongY = samplesAlong(half_m.y(), cells, cell_m, straight ? 1 : kSamples);
    for (const auto& x : alongX)
        for (const auto& y : alongY)
            addChord(fill.data() + (x.cell * n + y.cell) * n, cells, cell_m, halfChord(shape, x.place_m, y.place_m), x.weight * y.weight);
    mirror(fill, n);
    makeVolumeExact(fill, volume_m3(shape) / (cell_m * cell_m * cell_m));
    return fill;
}

} // namespace lubberline
