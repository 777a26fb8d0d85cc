// Loops and wires against closed forms, Ampère's law and one another.

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

#include "core/iron/CurrentField.h"

using namespace lubberline;
using std::numbers::pi;

namespace {

constexpr double kMu0_nT_m_per_A = 400 * pi;

/// ∮ B·dl / μ0 round a circle of points: the current that goes through it.
template <class Field>
double enclosed_A(const Field& field, const Eigen::Vector3d& centre, const Eigen::Vector3d& u, const Eigen::Vector3d& v, double radius)
{
    constexpr int kSteps = 2000;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double t = 2 * pi * i / kSteps;
        const Eigen::Vector3d place = centre + radius * (std::cos(t) * u + std::sin(t) * v);
        sum += field(place).dot(-std::sin(t) * u + std::cos(t) * v) * 2 * pi * radius / kSteps;
    }
    return sum / kMu0_nT_m_per_A;
}

WirePath polygon(const CurrentLoop& loop, int corners, double radius)
{
    const Eigen::Vector3d n = loop.normal.normalized(), u = n.unitOrthogonal(), v = n.cross(u);
    WirePath path;
    for (int i = 0; i <= corners; ++i)
        path.points_m.push_back(loop.centre_m + radius * (std::cos(2 * pi * i / corners) * u + std::sin(2 * pi * i / corners) * v));
    return path;
}

} // namespace

/// B = μ0 a² / (2 (a² + z²)^1.5), along the normal: clockwise seen along it is the right-hand screw.
TEST(CurrentField, OnItsAxisALoopHasTheClosedForm)
{
    const CurrentLoop loop{{1, 2, 3}, {0, 0, 2}, 0.4, 7};
    for (const double z : {-1.0, -0.1, 0.0, 0.2, 5.0, 1000.0}) {
        const auto field = fieldOfLoop_nT_per_A(loop, {1, 2, 3 + z});
        const double expected = 7 * kMu0_nT_m_per_A * 0.04 / (2 * std::pow(0.04 + z * z, 1.5));
        EXPECT_NEAR(field.z() / expected, 1, 1e-12) << z;
        EXPECT_EQ(field.head<2>().norm(), 0);
    }
}

TEST(CurrentField, FarAwayALoopIsADipole)
{
    const CurrentLoop loop{{0, 0, 0}, {1, -2, 0.5}, 0.02, 3};
    const Eigen::Vector3d moment = 3 * pi * 1e-4 * loop.normal.normalized();
    for (const double distance : {20.0, 200.0})
        for (const Eigen::Vector3d& towards : {Eigen::Vector3d(1, 0, 0), {0.3, 0.5, -0.9}, {2, 1, 0}}) {
            const Eigen::Vector3d n = towards.normalized();
            const Eigen::Vector3d expected = 100 / std::pow(distance, 3) * (3 * n.dot(moment) * n - moment);
            EXPECT_LT((fieldOfLoop_nT_per_A(loop, distance * n) - expected).norm() / expected.norm(), 2e-6) << distance;
        }
}

/// Where the series takes over from the elliptic integrals, nothing jumps.
TEST(CurrentField, NearTheAxisTheLoopIsSmooth)
{
    const CurrentLoop loop{{0, 0, 0}, {0, 0, 1}, 2, 1};
    const double z = 0.7, slope = 0.75 * kMu0_nT_m_per_A * z / std::pow(1 + z * z, 2.5); // B_ρ = ρ · this
    for (const double rho : {1e-9, 1e-5, 1e-4})
        EXPECT_NEAR(fieldOfLoop_nT_per_A(loop, {rho, 0, z}).x() / rho / slope, 1, 1e-7) << rho;
    const double at = 1e-3 * (1 + z * z) / 4; // m = 4ρ/β² = 1e-3
    const double below = fieldOfLoop_nT_per_A(loop, {at * 0.999999, 0, z}).x(),
                 above = fieldOfLoop_nT_per_A(loop, {at * 1.000001, 0, z}).x();
    EXPECT_NEAR(above / below, 1.000002, 1e-8);
}

TEST(CurrentField, OffItsAxisALoopIsAPolygonOfManyWires)
{
    const CurrentLoop loop{{0.1, -0.2, 0.3}, {1, 1, 0.2}, 1, 1};
    const int corners = 4000;
    const double sameArea = 0.5 * std::sqrt(2 * pi / corners / std::sin(2 * pi / corners));
    const auto path = polygon(loop, corners, sameArea);
    for (const Eigen::Vector3d& place :
        {Eigen::Vector3d(0.9, 0.1, 0.2), {0.2, 0.1, 0.4}, {-0.3, -0.9, 1.5}, {0.12, -0.21, 0.5}, {3, 4, -5}}) {
        const auto exact = fieldOfLoop_nT_per_A(loop, place);
        EXPECT_LT((fieldOfWire_nT_per_A(path, place) - exact).norm() / exact.norm(), 2e-6) << place.transpose();
    }
}

TEST(CurrentField, ALongWireIsTheInfiniteOne)
{
    const WirePath wire{{{-1e4, 0, 0}, {1e4, 0, 0}}};
    const auto field = fieldOfWire_nT_per_A(wire, {0, 2, 0}); // current forward, the place to starboard: down
    EXPECT_NEAR(field.z(), kMu0_nT_m_per_A / (2 * pi * 2), 1e-5);
    EXPECT_NEAR(field.head<2>().norm(), 0, 1e-12);
}

/// μ0/(4πd) (sin of the angles to both ends).
TEST(CurrentField, AFiniteWireHasTheAnglesOfItsEnds)
{
    const WirePath wire{{{-1, 0, 0}, {3, 0, 0}}};
    const double expected = 100 / 0.5 * (1 / std::hypot(1, 0.5) + 3 / std::hypot(3, 0.5));
    EXPECT_NEAR(fieldOfWire_nT_per_A(wire, {0, 0, 0.5}).y(), -expected, 1e-9);
    EXPECT_EQ(fieldOfWire_nT_per_A(wire, {5, 0, 0}).norm(), 0); // in line with it
}

TEST(CurrentField, SplittingAWireOrTurningItRoundChangesNothingButTheSign)
{
    const WirePath whole{{{0, 0, 0}, {2, 1, 0}}}, halves{{{0, 0, 0}, {1, 0.5, 0}, {2, 1, 0}}}, back{{{2, 1, 0}, {0, 0, 0}}};
    const Eigen::Vector3d place(0.3, -0.4, 0.8);
    EXPECT_NEAR((fieldOfWire_nT_per_A(whole, place) - fieldOfWire_nT_per_A(halves, place)).norm(), 0, 1e-11);
    EXPECT_NEAR((fieldOfWire_nT_per_A(whole, place) + fieldOfWire_nT_per_A(back, place)).norm(), 0, 1e-11);
}

TEST(CurrentField, AmperesLawGivesTheCurrentBack)
{
    const CurrentLoop loop{{0, 0, 0}, {0, 0, 1}, 2, 5};
    const auto ofLoop = [&](const Eigen::Vector3d& place) { return fieldOfLoop_nT_per_A(loop, place); };
    // The wire crosses the x–z plane at (1, 0, 0), flowing along +y; the way round has +y for its screw.
    EXPECT_NEAR(enclosed_A(ofLoop, {1, 0, 0}, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX(), 0.4), 5, 1e-9);
    EXPECT_NEAR(enclosed_A(ofLoop, {1, 0, 0}, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX(), 1.7), 5, 1e-6);
    EXPECT_NEAR(enclosed_A(ofLoop, {2, 0, 0}, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX(), 0.4), 0, 1e-9);

    const WirePath frame{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}}};
    const auto ofFrame = [&](const Eigen::Vector3d& place) { return fieldOfWire_nT_per_A(frame, place); };
    EXPECT_NEAR(enclosed_A(ofFrame, {0.5, 0, 0}, Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ(), 0.3), 1, 1e-9);
    EXPECT_NEAR(enclosed_A(ofFrame, {0.5, 2, 0}, Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ(), 0.5), 0, 1e-9);
}

TEST(CurrentField, DistancesAreToTheConductorItself)
{
    EXPECT_NEAR(distanceTo(CurrentLoop{{0, 0, 1}, {0, 0, 3}, 2, 1}, {0, 4, 5}), 5, 1e-12);
    EXPECT_NEAR(distanceTo(WirePath{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}}, {4, 1, 4}), 5, 1e-12);
    EXPECT_NEAR(distanceTo(WirePath{{{0, 0, 0}, {0, 0, 0}}}, {0, 3, 4}), 5, 1e-12);
}
