// Closed forms of demagnetising factors against published values and limits.

#include <gtest/gtest.h>

#include <cmath>

#include "core/angle/Angle.h"
#include "core/iron/DemagnetisingFactors.h"

using namespace lubberline;

namespace {

/// R. Bozorth, Ferromagnetism (1951), table of demagnetising factors N/4π (from Osborn and Stoner, 1945), along the axis that
/// is m times the other two (prolate), or along one of the two that are m times the third (oblate). Quoted second-hand: the
/// printed page was not at hand, and these figures are those that also follow from Osborn's formulas.
struct Published {
    double ratio, prolate, oblate;
};
constexpr Published kEllipsoids[]
    = {{2, 0.1735, 0.2364}, {5, 0.0558, 0.1248}, {10, 0.0203, 0.0696}, {20, 0.00675, 0.0369}, {100, 0.000430, 0.00776}};

double unit(double printed) { return std::pow(10, std::floor(std::log10(printed)) - 2); }

} // namespace

TEST(DemagnetisingFactors, EllipsoidsOfRevolutionAreThoseOfBozorthsTable)
{
    for (const auto& published : kEllipsoids) {
        EXPECT_NEAR(factorsOfEllipsoid({published.ratio, 1, 1}).x(), published.prolate, unit(published.prolate)) << published.ratio;
        EXPECT_NEAR(factorsOfEllipsoid({published.ratio, published.ratio, 1}).x(), published.oblate, unit(published.oblate))
            << published.ratio;
    }
}

/// Osborn 1945, equations 2.13 … 2.21: spheroids in elementary functions, a different way to the same number.
TEST(DemagnetisingFactors, SpheroidsAgreeWithOsbornsElementaryForms)
{
    for (const double m : {1.1, 1.5, 3.0, 20.0, 1000.0}) {
        const double root = std::sqrt(m * m - 1);
        const double prolate = (m / (2 * root) * std::log((m + root) / (m - root)) - 1) / (m * m - 1);
        const double oblate = m * m / (m * m - 1) * (1 - std::asin(root / m) / root);
        EXPECT_NEAR(factorsOfEllipsoid({m, 1, 1}).x() / prolate, 1, 1e-9) << m;
        EXPECT_NEAR(factorsOfEllipsoid({m, m, 1}).z() / oblate, 1, 1e-9) << m;
    }
}

TEST(DemagnetisingFactors, SphereAndCubeAreAThirdExactly)
{
    for (const double side : {1e-3, 1.0, 40.0}) {
        EXPECT_NEAR((factorsOfEllipsoid({side, side, side}) - Eigen::Vector3d::Constant(1.0 / 3)).norm(), 0, 1e-14);
        EXPECT_NEAR((factorsOfBox({side, side, side}) - Eigen::Vector3d::Constant(1.0 / 3)).norm(), 0, 1e-14);
    }
}

/// Aharoni 1998, eq. (2): the square bar 2a × 2a × 2pa has a shorter closed form of its own.
TEST(DemagnetisingFactors, SquareBarsAgreeWithAharonisShorterForm)
{
    for (const double p : {0.05, 0.5, 1.0, 2.0, 10.0}) {
        const double p2 = p * p;
        const double along
            = ((p - 1 / p) * std::log((std::sqrt(p2 + 2) + 1) / (std::sqrt(p2 + 2) - 1)) + 2 / p * std::log(std::sqrt(2.0) + 1)
                  + p * std::log((std::sqrt(p2 + 1) - 1) / (std::sqrt(p2 + 1) + 1)) + 2 * std::atan(1 / (p * std::sqrt(p2 + 2)))
                  + 2 * (1 - p2 * p) / (3 * p) + 2 * (1 - p2) / (3 * p) * std::sqrt(p2 + 2) + 4 * p * 0.5 * std::sqrt(1 + p2)
                  - std::pow(2, 1.5) / (3 * p) - 2 * std::pow(1 + p2, 1.5) / (3 * p))
            / kPi;
        EXPECT_NEAR(factorsOfBox({1, 1, p}).z(), along, 1e-12) << p;
    }
}

/// D.-X. Chen, J. Brug, R. Goldfarb, IEEE Trans. Magn. 27, 3601 (1991), table I: magnetometric factors of cylinders, χ = 0.
/// Quoted second-hand: the printed page was not at hand.
TEST(DemagnetisingFactors, CylindersAreThoseOfChenBrugAndGoldfarb)
{
    EXPECT_NEAR(factorsOfCylinder(1, 1).x(), 0.3116, 5e-5);
    EXPECT_NEAR(factorsOfCylinder(1, 2).x(), 0.1819, 5e-5);
}

TEST(DemagnetisingFactors, AddUpToOneAndKnowNoScale)
{
    const Shape shapes[] = {Box{{3, 2, 0.01}}, Box{{1000, 1, 1}}, Ellipsoid{{1, 30, 0.2}}, Cylinder{1, 100}, Cylinder{100, 1}, Sphere{2}};
    for (const auto& shape : shapes) {
        EXPECT_NEAR(factorsOf(shape).sum(), 1, 1e-12);
        EXPECT_GT(factorsOf(shape).minCoeff(), 0);
    }
    EXPECT_NEAR((factorsOfBox({3, 2, 1}) - factorsOfBox({0.003, 0.002, 0.001})).norm(), 0, 1e-13);
}

TEST(DemagnetisingFactors, FollowTheAxesWhenTheyChangePlaces)
{
    const Eigen::Vector3d box = factorsOfBox({3, 2, 1}), ellipsoid = factorsOfEllipsoid({3, 2, 1});
    EXPECT_NEAR((factorsOfBox({1, 3, 2}) - Eigen::Vector3d(box.z(), box.x(), box.y())).norm(), 0, 1e-14);
    EXPECT_NEAR((factorsOfEllipsoid({1, 3, 2}) - Eigen::Vector3d(ellipsoid.z(), ellipsoid.x(), ellipsoid.y())).norm(), 0, 1e-14);
}

TEST(DemagnetisingFactors, NeedlesAndSheetsReachTheirLimits)
{
    EXPECT_LT(factorsOfBox({1000, 1, 1}).x(), 6e-4);
    EXPECT_NEAR(factorsOfBox({1000, 1, 1}).y(), 0.5, 3e-4);
    EXPECT_GT(factorsOfBox({1000, 1000, 1}).z(), 0.995);
    EXPECT_NEAR(factorsOfCylinder(1, 1000).y(), 0.5, 3e-4);
    EXPECT_GT(factorsOfCylinder(1000, 1).x(), 0.99);
}
