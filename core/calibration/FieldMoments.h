#pragma once
/// Sums of all products x^a y^b z^c, a + b + c ≤ 4, of a cloud of points, in one pass: all that an algebraic fit of an ellipsoid asks of it.

#include <array>
#include <cstdint>
#include <span>

#include <Eigen/Core>

namespace lubberline {

/// Points as three columns of one length.
using FieldColumns = std::array<std::span<const double>, 3>;

/// Of u = (m − centre)/scale: numbers near 1, so that fourth powers keep their digits.
struct FieldMoments {
    static constexpr std::size_t kCount = 35;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    double scale = 1;
    std::array<double, kCount> sum{}; ///< in the order of momentIndex(); the first is the number of points

    [[nodiscard]] double of(int a, int b, int c) const;
    [[nodiscard]] double points() const { return sum[0]; }
};

/// @param used one byte a point, 0: left out; empty: all. What is left out may be NaN, what is used is finite.
[[nodiscard]] FieldMoments momentsOf(
    const FieldColumns& points, std::span<const std::uint8_t> used, const Eigen::Vector3d& centre, double scale);

} // namespace lubberline
