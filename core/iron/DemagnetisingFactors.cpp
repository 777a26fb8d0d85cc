#include "core/iron/DemagnetisingFactors.h"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/ellint_rd.hpp>

#include <cmath>

#include "core/angle/Angle.h"

namespace lubberline {

namespace {

/// [Aharoni 1: D_z of a prism 2a × 2b × 2c along c.] Its terms grow with the slenderness and cancel: summed in long double.
double factorOfPrism(long double a, long double b, long double c)
{
    using std::atan, std::sqrt;
    const long double ab = a * a + b * b, bc = b * b + c * c, ca = c * c + a * a, abc = ab + c * c;
    const auto log = [](long double x, long double rest) { return 2 * std::asinh(x / std::sqrt(rest)); };
    const long double logs = -(b * b - c * c) / (2 * b * c) * log(a, bc) - (a * a - c * c) / (2 * a * c) * log(b, ca)
        + b / (2 * c) * log(a, b * b) + a / (2 * c) * log(b, a * a) - c / (2 * a) * log(b, c * c) - c / (2 * b) * log(a, c * c);
    const long double powers = (a * a * a + b * b * b - 2 * c * c * c) / (3 * a * b * c)
        + (a * a + b * b - 2 * c * c) / (3 * a * b * c) * sqrt(abc) + c / (a * b) * (sqrt(ca) + sqrt(bc))
        - (ab * sqrt(ab) + bc * sqrt(bc) + ca * sqrt(ca)) / (3 * a * b * c);
    return static_cast<double>((logs + 2 * atan(a * b / (c * sqrt(abc))) + powers) / std::numbers::pi_v<long double>);
}

} // namespace

Eigen::Vector3d factorsOfBox(const Eigen::Vector3d& size_m)
{
    const double a = size_m.x(), b = size_m.y(), c = size_m.z();
    return {factorOfPrism(b, c, a), factorOfPrism(c, a, b), factorOfPrism(a, b, c)};
}

Eigen::Vector3d factorsOfEllipsoid(const Eigen::Vector3d& size_m)
{
    const Eigen::Vector3d axes = size_m / size_m.maxCoeff(); // a factor knows no scale; squares stay in range
    const Eigen::Vector3d squares = axes.cwiseProduct(axes);
    const auto factor = [&](int i, int j, int k) { return axes.prod() / 3 * boost::math::ellint_rd(squares[j], squares[k], squares[i]); };
    return {factor(0, 1, 2), factor(1, 2, 0), factor(2, 0, 1)};
}

Eigen::Vector3d factorsOfCylinder(double diameter_m, double length_m)
{
    const double g = length_m / diameter_m;
    const double k = 1 / std::hypot(1.0, g);
    const double along = 1 - 4 / (3 * kPi * g) * ((g * g * boost::math::ellint_1(k) + (1 - g * g) * boost::math::ellint_2(k)) / k - 1);
    return {along, (1 - along) / 2, (1 - along) / 2};
}

Eigen::Vector3d factorsOf(const Shape& shape)
{
    struct Factors {
        Eigen::Vector3d operator()(const Box& box) const { return factorsOfBox(box.size_m); }
        Eigen::Vector3d operator()(const Cylinder& cylinder) const { return factorsOfCylinder(cylinder.diameter_m, cylinder.length_m); }
        Eigen::Vector3d operator()(const Ellipsoid& ellipsoid) const { return factorsOfEllipsoid(ellipsoid.size_m); }
        Eigen::Vector3d operator()(const Sphere&) const { return Eigen::Vector3d::Constant(1.0 / 3); }
    };
    return std::visit(Factors{}, shape);
}

} // namespace lubberline
