// The tensor by FFT against closed forms inside, dipoles outside.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "core/iron/DemagnetisationTensor.h"
#include "core/iron/ShapeGeometry.h"

using namespace lubberline;

namespace {

DemagnetisationTensor tensorOf(const Shape& shape, int cells, double cell_m)
{
    auto tensor = demagnetisationTensor(shape, {cells, cell_m});
    EXPECT_TRUE(tensor.ok());
    return std::move(*tensor);
}

Eigen::Matrix3d dipole(double volume_m3, const Eigen::Vector3d& place_m)
{
    const Eigen::Vector3d direction = place_m.normalized();
    return volume_m3 / (4 * std::numbers::pi * std::pow(place_m.norm(), 3))
        * (Eigen::Matrix3d::Identity() - 3 * direction * direction.transpose());
}

/// Directions that favour no axis, and the axes.
std::vector<Eigen::Vector3d> directions()
{
    std::vector<Eigen::Vector3d> all{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, 1, 1}};
    for (int i = 0; i < 200; ++i) {
        const double z = 1 - (2 * i + 1) / 200.0, turn = 2.399963 * i;
        all.emplace_back(std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z);
    }
    for (auto& direction : all)
        direction.normalize();
    return all;
}

void expectDiagonal(const Eigen::Matrix3d& average, const Eigen::Vector3d& factors, double tolerance)
{
    EXPECT_NEAR((average - Eigen::Matrix3d(factors.asDiagonal())).cwiseAbs().maxCoeff(), 0, tolerance) << average;
}

} // namespace

TEST(DemagnetisationTensor, SphereIsAThird)
{
    expectDiagonal(tensorOf(Sphere{1}, 64, 1 / 32.0).averageInside(), Eigen::Vector3d::Constant(1.0 / 3), 1e-4);
    expectDiagonal(tensorOf(Sphere{1}, 32, 1 / 16.0).averageInside(), Eigen::Vector3d::Constant(1.0 / 3), 3e-4);
}

TEST(DemagnetisationTensor, CubeAndPrismsAreAharonis)
{
    for (const Eigen::Vector3d& size : {Eigen::Vector3d(1, 1, 1), {1, 0.5, 0.5}, {0.25, 1, 1}, {1, 0.625, 0.25}})
        expectDiagonal(tensorOf(Box{size}, 64, 1 / 32.0).averageInside(), factorsOfBox(size), 5e-5);
    for (const Eigen::Vector3d& size : {Eigen::Vector3d(0.97, 0.97, 0.97), {0.3, 1, 1}, {1, 0.6, 0.21}}) // faces within cells
        expectDiagonal(tensorOf(Box{size}, 64, 1 / 32.0).averageInside(), factorsOfBox(size), 0.0035);
}

TEST(DemagnetisationTensor, EllipsoidsAreOsborns)
{
    for (const Eigen::Vector3d& size : {Eigen::Vector3d(1, 0.5, 0.5), {0.5, 1, 1}, {1, 0.7, 0.4}})
        expectDiagonal(tensorOf(Ellipsoid{size}, 64, 1 / 40.0).averageInside(), factorsOfEllipsoid(size), 0.0035);
}

TEST(DemagnetisationTensor, CylindersAreJosephs)
{
    expectDiagonal(tensorOf(Cylinder{1, 1}, 64, 1 / 40.0).averageInside(), factorsOfCylinder(1, 1), 0.002);
    expectDiagonal(tensorOf(Cylinder{0.5, 1}, 64, 1 / 40.0).averageInside(), factorsOfCylinder(0.5, 1), 0.002);
}

/// An ellipsoid's tensor is the same everywhere inside; its trace is 1 there and 0 outside.
TEST(DemagnetisationTensor, InsideAnEllipsoidItIsUniform)
{
    const Eigen::Vector3d size(1, 0.7, 0.5);
    const auto tensor = tensorOf(Ellipsoid{size}, 64, 1 / 40.0);
    for (const auto& direction : directions()) {
        const Eigen::Vector3d place = 0.35 * direction.cwiseProduct(size);
        expectDiagonal(tensor.at(place), factorsOfEllipsoid(size), 0.006);
    }
}

TEST(DemagnetisationTensor, TraceIsOneInsideAndZeroOutside)
{
    const auto tensor = tensorOf(Box{{0.6, 0.5, 0.4}}, 64, 1 / 50.0);
    for (const auto& direction : directions()) {
        EXPECT_NEAR(tensor.at(0.12 * direction).trace(), 1, 1e-6);
        EXPECT_NEAR(tensor.at(0.52 * direction).trace(), 0, 1e-6);
    }
    EXPECT_NEAR(tensor.averageInside().trace(), 1, 1e-9);
}

/// Not put in by the trace: the sum over all cells is the volume's share, and each cell's trace its fill.
TEST(DemagnetisationTensor, XxAndYyOfACubeAreAsItsZz)
{
    const auto tensor = tensorOf(Box{{0.5, 0.5, 0.5}}, 48, 1 / 48.0);
    for (const auto& direction : directions()) {
        const Eigen::Vector3d place = 0.42 * direction;
        const Eigen::Vector3d turned(place.y(), place.z(), place.x());
        EXPECT_NEAR(tensor.at(place)(0, 0), tensor.at(turned)(2, 2), 6e-4);
        EXPECT_NEAR(tensor.at(place)(0, 1), tensor.at(turned)(0, 2), 6e-4);
    }
}

/// The field outside a uniform sphere is exactly a dipole's.
TEST(DemagnetisationTensor, OutsideASphereItIsTheDipole)
{
    for (const double radius : {16.0, 10.0}) { // in cells
        const auto tensor = tensorOf(Sphere{2 * radius}, 64, 1);
        for (double reach = 1.25; reach * radius <= 29; reach += 0.25)
            for (const auto& direction : directions()) {
                const Eigen::Vector3d place = reach * radius * direction;
                const auto expected = dipole(volume_m3(Sphere{2 * radius}), place);
                EXPECT_LT((tensor.at(place) - expected).norm() / expected.norm(), 0.01) << radius << " cells, " << reach << " radii";
            }
    }
}

TEST(DemagnetisationTensor, KnowsNoScaleAndMirrorsWithTheBody)
{
    const auto one = tensorOf(Box{{0.5, 0.3, 0.2}}, 32, 1 / 32.0), large = tensorOf(Box{{50, 30, 20}}, 32, 100 / 32.0);
    const Eigen::Vector3d place(0.31, 0.22, -0.17);
    EXPECT_NEAR((one.at(place) - large.at(100 * place)).norm(), 0, 1e-9);
    const Eigen::Vector3d mirrored = place.cwiseProduct(Eigen::Vector3d(-1, 1, 1));
    EXPECT_NEAR(one.at(place)(0, 1), -one.at(mirrored)(0, 1), 1e-9);
    EXPECT_NEAR(one.at(place)(0, 0), one.at(mirrored)(0, 0), 1e-9);
}

TEST(DemagnetisationTensor, FillHoldsTheVolumeOfThinAndRoundBodies)
{
    const Shape shapes[] = {Sphere{1}, Box{{0.9, 0.001, 0.3}}, Cylinder{0.013, 0.95}, Cylinder{0.9, 0.004}, Ellipsoid{{0.01, 0.9, 0.02}},
        Ellipsoid{{0.9, 0.01, 0.3}}};
    for (const auto& shape : shapes) {
        double sum = 0;
        for (const float part : fillOf(shape, 40, 1 / 36.0)) {
            ASSERT_GE(part, 0);
            ASSERT_LE(part, 1);
            sum += static_cast<double>(part);
        }
        EXPECT_NEAR(sum / (36.0 * 36 * 36) / volume_m3(shape), 1, 2e-5);
    }
}

TEST(DemagnetisationTensor, RefusesWhatDoesNotFitBeforeItTakesMemory)
{
    const auto code = [](const Shape& shape, int cells, double cell_m) {
        const auto tensor = demagnetisationTensor(shape, {cells, cell_m});
        return tensor.ok() ? std::string("ok") : tensor.error().message.english();
    };
    EXPECT_NE(code(Sphere{1}, 4000, 1).find("MiB"), std::string::npos);
    EXPECT_NE(code(Sphere{1}, std::numeric_limits<int>::max(), 1).find("MiB"), std::string::npos);
    EXPECT_NE(code(Sphere{1}, 7, 1).find("too coarse"), std::string::npos);
    EXPECT_NE(code(Sphere{1}, -5, 1).find("too coarse"), std::string::npos);
    EXPECT_NE(code(Sphere{1}, 16, 1 / 17.0).find("larger than its grid"), std::string::npos);
    EXPECT_NE(code(Sphere{0}, 16, 1).find("sizes above 0"), std::string::npos);
    EXPECT_NE(code(Sphere{std::nan("")}, 16, 1).find("sizes above 0"), std::string::npos);
    EXPECT_NE(code(Box{{1, -1, 1}}, 16, 1).find("sizes above 0"), std::string::npos);
    EXPECT_NE(code(Sphere{1}, 16, 0).find("sizes above 0"), std::string::npos);
    EXPECT_LT(memoryFor({64, 0.01}), std::size_t{80} << 20);
    EXPECT_GT(memoryFor({64, 0.01}), std::size_t{48} << 20);
}

TEST(DemagnetisationTensor, StopsWhenAsked)
{
    double last = -1;
    const auto tensor = demagnetisationTensor(Sphere{1}, {16, 0.1}, [&](double done) {
        last = done;
        return done < 0.4;
    });
    ASSERT_FALSE(tensor.ok());
    EXPECT_EQ(tensor.error().code, ErrorCode::Cancelled);
    EXPECT_LT(last, 0.7);
}
