// What parts and currents do at the sensor: closed forms, signs by what the compass reads, states, limits.

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

#include "core/iron/BenchModel.h"
#include "core/iron/Coercivity.h"
#include "core/sensor/Attitude.h"
#include "core/sensor/PoissonSmith.h"
#include "core/sensor/SensorReading.h"

using namespace lubberline;
using std::numbers::pi;

namespace {

constexpr double kDegree = pi / 180;

FerrousPart part(const std::string& name, const Shape& shape, double susceptibility, const Eigen::Vector3d& centre_m)
{
    FerrousPart made;
    made.name = name;
    made.shape = shape;
    made.susceptibility = susceptibility;
    made.placements = {{{}, centre_m, 0, 0, 0}};
    return made;
}

BenchModel modelOf(const IronBench& bench, const BenchStates& states = {})
{
    auto model = benchModel(bench, states);
    EXPECT_TRUE(model.ok()) << (model.ok() ? "" : model.error().message.english());
    return model.ok() ? std::move(*model) : BenchModel{};
}

std::string faultOf(const IronBench& bench, const BenchStates& states = {})
{
    const auto model = benchModel(bench, states);
    EXPECT_TRUE(model.ok() || model.error().code == ErrorCode::InvalidInput);
    return model.ok() ? "ok" : model.error().message.english();
}

/// The deviation [°] at a level heading in central Europe: H 18,500 nT, dip 67°.
double deviation_deg(const SensorModel& model, double heading_deg)
{
    Attitude attitude;
    attitude.heading = MagneticHeading::fromDegrees(heading_deg);
    return readSensor(model, MeridianField::fromDip(18'500, 67 * kDegree), attitude).deviation->degrees();
}

/// Outside a sphere: a dipole of moment 4πa³ χ/(3 + χ) B/μ0: S = (a/r)³ χ/(3 + χ) (3 n nᵀ − 1).
Eigen::Matrix3d sphereSoftIron(double radius_m, double susceptibility, const Eigen::Vector3d& fromCentre_m)
{
    const Eigen::Vector3d n = fromCentre_m.normalized();
    return std::pow(radius_m / fromCentre_m.norm(), 3) * susceptibility / (3 + susceptibility)
        * (3 * n * n.transpose() - Eigen::Matrix3d::Identity());
}

} // namespace

TEST(BenchModel, AnEmptyBenchDoesNothing)
{
    const auto model = modelOf({});
    EXPECT_EQ(model.model, SensorModel{});
    EXPECT_TRUE(model.parts.empty());
    EXPECT_TRUE(model.warnings.empty());
}

TEST(BenchModel, ASphereIsADipoleNearAndFar)
{
    const double radius_m = 0.1;
    for (const double chi : {0.5, 20.0, 1e6})
        for (const double radii : {1.2, 1.6, 2.0, 2.5, 3.0, 5.0, 5.99, 6.01, 12.0, 300.0})
            for (const Eigen::Vector3d& towards : {Eigen::Vector3d(1, 0, 0), {0, 0, 1}, {1, 1, 0}, {0.3, -0.5, 0.8}}) {
                const Eigen::Vector3d from_m = radii * radius_m * towards.normalized();
                IronBench bench;
                bench.sensor_m = Eigen::Vector3d(1, 2, 3) + from_m;
                bench.parts = {part("ball", Sphere{2 * radius_m}, chi, {1, 2, 3})};
                const auto model = modelOf(bench);
                EXPECT_EQ(model.parts[0].dipole, radii > 6);
                EXPECT_NEAR(model.parts[0].distance_m, radii * radius_m, 1e-12);
                const auto expected = sphereSoftIron(radius_m, chi, from_m);
                EXPECT_LT((model.model.softIron - expected).norm() / expected.norm(), radii > 6 ? 1e-12 : 0.01) << radii << " radii";
            }
}

/// B on the axis of a bar magnet M: a cylinder's, μ0M/2 (cos of the angles to the rims of both ends).
TEST(BenchModel, AMagnetisedCylinderHasTheFieldOfItsTwoEnds)
{
    IronBench bench;
    bench.parts = {part("magnet", Cylinder{0.1, 0.2}, 0, {0, 0, 0})};
    bench.parts[0].remanence_T = {1.2, 0, 0};
    for (const double x : {0.15, 0.2, 0.4, 0.59}) {
        bench.sensor_m = {x, 0, 0};
        const double expected_nT = 0.6e9 * ((x + 0.1) / std::hypot(x + 0.1, 0.05) - (x - 0.1) / std::hypot(x - 0.1, 0.05));
        EXPECT_NEAR(modelOf(bench).model.hardIron_nT.x() / expected_nT, 1, 0.01) << x;
    }
}

/// The tensor hands over to the dipole without a jump worth speaking of: a box of 3 : 1 : 1 at three lengths.
TEST(BenchModel, TensorAndDipoleMeetAtThreeLengths)
{
    IronBench bench;
    bench.parts = {part("box", Box{{0.3, 0.1, 0.1}}, 50, {0, 0, 0})};
    bench.sensor_m = {0.6, 0.5, 0.4429};
    bench.sensor_m *= 0.8999 / bench.sensor_m.norm();
    const auto near = modelOf(bench);
    bench.sensor_m *= 0.9001 / 0.8999;
    const auto far = modelOf(bench);
    EXPECT_FALSE(near.parts[0].dipole);
    EXPECT_TRUE(far.parts[0].dipole);
    EXPECT_LT((near.model.softIron - far.model.softIron).norm() / far.model.softIron.norm(), 0.05);
}

/// Ahead of the compass a vertical rod of soft iron is magnetised by Z, its lower end red (north-seeking) in the northern
/// hemisphere. Level with its blue upper end the north end of the needle is drawn forward: on east that is eastwards, deviation
/// positive. Level with the red lower end it is pushed back: negative. South of the magnetic equator both turn round.
TEST(BenchModel, AVerticalRodAheadDrawsTheNeedleByItsBlueEnd)
{
    IronBench bench;
    bench.parts = {part("rod", Cylinder{0.04, 1}, 200, {0.6, 0, 0})};
    bench.parts[0].placements[0].pitch_rad = pi / 2; // its axis vertical
    bench.sensor_m = {0, 0, -0.5};
    const auto top = modelOf(bench);
    EXPECT_GT(top.model.softIron(0, 2), 0.001); // c
    EXPECT_GT(deviation_deg(top.model, 90), 0.1);
    EXPECT_LT(deviation_deg(top.model, 270), -0.1);
    bench.sensor_m = {0, 0, 0.5};
    const auto bottom = modelOf(bench);
    EXPECT_LT(deviation_deg(bottom.model, 90), -0.1);
    EXPECT_NEAR(top.model.softIron(0, 2), -bottom.model.softIron(0, 2), 1e-9);
    Attitude east;
    east.heading = MagneticHeading::fromDegrees(90);
    EXPECT_LT(readSensor(top.model, MeridianField::fromDip(18'500, -67 * kDegree), east).deviation->degrees(), -0.1);
}

/// A magnet whose red end points at the compass from ahead pushes the field back: P < 0, and on east the deviation is westerly.
TEST(BenchModel, AMagnetAheadPointingAftHasNegativeP)
{
    IronBench bench;
    bench.parts = {part("magnet", Box{{0.1, 0.02, 0.02}}, 0, {1, 0, 0})};
    bench.parts[0].remanence_T = {0.1, 0, 0};
    bench.parts[0].placements[0].yaw_rad = pi; // its own x looks aft
    const auto model = modelOf(bench);
    const double moment = 0.1e9 * 0.1 * 0.02 * 0.02; // μ0 m [nT m³]
    EXPECT_NEAR(model.model.hardIron_nT.x(), -2 * moment / (4 * pi), 1e-6);
    EXPECT_NEAR(model.model.hardIron_nT.tail<2>().norm(), 0, 1e-9);
    EXPECT_LT(deviation_deg(model.model, 90), 0);
    EXPECT_GT(deviation_deg(model.model, 270), 0);
}

/// Remanence along a part's own axes: an attitude's senses. Nose up (pitch 90°) turns forward into up, starboard wing down into
/// down.
TEST(BenchModel, PartsTurnAsAnAircraftDoes)
{
    IronBench bench;
    bench.sensor_m = {0, 0, 50};
    bench.parts = {part("magnet", Sphere{0.1}, 0, {0, 0, 0})};
    const double size_nT = 1e9 * pi / 6 * 1e-3 / (4 * pi * 125'000); // at right angles to the dipole; twice that on its axis
    const auto hardIron = [&](const Eigen::Vector3d& remanence_T, double roll, double pitch, double yaw) -> Eigen::Vector3d {
        bench.parts[0].remanence_T = remanence_T;
        bench.parts[0].placements = {{{}, {0, 0, 0}, roll, pitch, yaw}};
        return modelOf(bench).model.hardIron_nT / size_nT;
    };
    const auto near = [](const Eigen::Vector3d& is, const Eigen::Vector3d& expected) { return (is - expected).norm() < 1e-9; };
    EXPECT_TRUE(near(hardIron({1, 0, 0}, 0, 0, 0), {-1, 0, 0}));
    EXPECT_TRUE(near(hardIron({1, 0, 0}, 0, pi / 2, 0), {0, 0, -2}));
    EXPECT_TRUE(near(hardIron({0, 1, 0}, pi / 2, 0, 0), {0, 0, 2}));
    EXPECT_TRUE(near(hardIron({1, 0, 0}, 0, 0, pi / 2), {0, -1, 0}));
}

TEST(BenchModel, TurningTheWholeBenchTurnsTheModel)
{
    IronBench bench;
    bench.sensor_m = {0.5, 0.2, -0.1};
    bench.parts = {part("box", Box{{0.4, 0.2, 0.1}}, 30, {0, 0, 0}), part("far", Cylinder{0.05, 0.3}, 80, {3, -1, 0.5})};
    bench.parts[0].remanence_T = {0.01, -0.02, 0.005};
    bench.parts[1].placements[0].pitch_rad = 0.4;
    const auto straight = modelOf(bench).model;
    const Eigen::Matrix3d quarter = rotation(0, 0, pi / 2).transpose(); // everything a quarter turn to starboard
    bench.sensor_m = quarter * bench.sensor_m;
    for (auto& one : bench.parts) {
        one.placements[0].centre_m = quarter * one.placements[0].centre_m;
        one.placements[0].yaw_rad += pi / 2;
    }
    const auto turned = modelOf(bench).model;
    EXPECT_NEAR((turned.softIron - quarter * straight.softIron * quarter.transpose()).norm(), 0, 1e-12);
    EXPECT_NEAR((turned.hardIron_nT - quarter * straight.hardIron_nT).norm(), 0, 1e-9 * straight.hardIron_nT.norm());
}

TEST(BenchModel, SharesAddUpAndTheirOrderIsTheBenchs)
{
    IronBench bench;
    for (int i = 0; i < 6; ++i) {
        bench.parts.push_back(
            part("part " + std::to_string(i), i % 2 ? Shape(Box{{0.2, 0.1, 0.3}}) : Shape(Sphere{0.1}), 5 + i, {0.4 + 0.3 * i, 0.1, -0.2}));
        bench.parts.back().remanence_T = {0.001 * i, 0, 0.002};
    }
    const auto model = modelOf(bench);
    Eigen::Matrix3d softIron = Eigen::Matrix3d::Zero();
    Eigen::Vector3d hardIron_nT = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(model.parts[i].part, bench.parts[i].name);
        softIron += model.parts[i].softIron;
        hardIron_nT += model.parts[i].hardIron_nT;
    }
    EXPECT_NEAR((softIron - model.model.softIron).norm(), 0, 1e-15);
    EXPECT_NEAR((hardIron_nT - model.model.hardIron_nT).norm(), 0, 1e-9);
    EXPECT_EQ(model.warnings.size(), 1U); // one another
}

TEST(BenchModel, StatesMoveThePartsOfTheirGroup)
{
    IronBench bench;
    bench.parts = {part("leg", Cylinder{0.06, 0.9}, 80, {0, 0, 0}), part("door", Box{{0.5, 0.3, 0.002}}, 80, {0, 0, 0}),
        part("seat", Sphere{0.1}, 50, {2, 1, 1})};
    for (std::size_t i = 0; i < 2; ++i) {
        bench.parts[i].group = "gear";
        bench.parts[i].placements = {{"retracted", {1.5, 0.3 * static_cast<double>(i), 0.5}, 0, 0, 0},
            {"extended", {1.5, 0.3 * static_cast<double>(i), 1.2}, 0, pi / 2, 0}};
    }
    const auto groups = groupsOf(bench);
    ASSERT_EQ(groups.size(), 1U);
    EXPECT_EQ(groups[0].first, "gear");
    EXPECT_EQ(groups[0].second, (std::vector<std::string>{"retracted", "extended"}));
    const auto unsaid = modelOf(bench), retracted = modelOf(bench, {{"gear", "retracted"}}),
               extended = modelOf(bench, {{"gear", "extended"}});
    EXPECT_EQ(unsaid.model, retracted.model);
    EXPECT_GT((extended.model.softIron - retracted.model.softIron).norm(), 1e-4);
    EXPECT_EQ(extended.parts[2].softIron, retracted.parts[2].softIron);
    EXPECT_NE(faultOf(bench, {{"gear", "half"}}).find("expected retracted, extended"), std::string::npos);
    EXPECT_NE(faultOf(bench, {{"flaps", "up"}}).find("expected gear"), std::string::npos);
    bench.parts[1].placements.pop_back();
    EXPECT_NE(faultOf(bench).find("part “door”"), std::string::npos);
}

TEST(BenchModel, CircuitsSumTheirConductors)
{
    IronBench bench;
    bench.sensor_m = {0.3, 0.1, 0};
    const CurrentLoop loop{{1, 0, 0}, {0, 0, 1}, 0.3, 2};
    const WirePath wire{{{-1, 0.5, 0}, {1, 0.5, 0.2}}};
    bench.circuits = {{"light", {loop, wire}, 12, true}, {"pump", {wire}, 3, false}};
    const auto model = modelOf(bench).model;
    ASSERT_EQ(model.circuits.size(), 2U);
    EXPECT_EQ(model.circuits[0].field_nT_per_A,
        Eigen::Vector3d(fieldOfLoop_nT_per_A(loop, bench.sensor_m) + fieldOfWire_nT_per_A(wire, bench.sensor_m)));
    EXPECT_EQ(model.circuits[1].field_nT_per_A, fieldOfWire_nT_per_A(wire, bench.sensor_m));
    EXPECT_EQ(model.circuits[0].current_A, 12);
    EXPECT_TRUE(model.circuits[0].on);
    EXPECT_FALSE(model.circuits[1].on);
}

/// Current forward in a wire above the compass (Ørsted's experiment, aircraft nose north): the field under it points to port,
/// so the needle's north end goes west: on north the deviation is westerly, negative.
TEST(BenchModel, CurrentForwardAboveTheCompassTurnsTheNeedleWest)
{
    IronBench bench;
    bench.circuits = {{"feeder", {WirePath{{{-5, 0, -0.3}, {5, 0, -0.3}}}}, 10, true}};
    const auto model = modelOf(bench).model;
    EXPECT_LT(model.circuits[0].field_nT_per_A.y(), -600);
    EXPECT_LT(deviation_deg(model, 0), -10);
}

TEST(BenchModel, RefusesWhatCannotBeAndNamesIt)
{
    const auto withPart = [](auto change) {
        IronBench bench;
        bench.sensor_m = {5, 0, 0};
        bench.parts = {part("bracket", Box{{0.1, 0.1, 0.1}}, 10, {0, 0, 0})};
        change(bench, bench.parts[0]);
        return faultOf(bench);
    };
    const auto names = [](const std::string& message, const char* what) {
        return message.find("bracket") != std::string::npos && message.find(what) != std::string::npos;
    };
    EXPECT_TRUE(names(withPart([](auto& bench, auto&) { bench.sensor_m = {0.05, 0, 0}; }), "inside"));
    EXPECT_TRUE(names(withPart([](auto&, auto& one) { one.shape = Box{{0.1, 0, 0.1}}; }), "sizes"));
    EXPECT_TRUE(names(withPart([](auto&, auto& one) { one.shape = Sphere{-1}; }), "sizes"));
    EXPECT_TRUE(names(withPart([](auto&, auto& one) { one.shape = Cylinder{std::nan(""), 1}; }), "sizes"));
    EXPECT_TRUE(names(withPart([](auto&, auto& one) { one.shape = Box{{1, 1, 1e-5}}; }), "10,000"));
    EXPECT_TRUE(names(withPart([](auto&, auto& one) { one.susceptibility = -0.1; }), "susceptibility"));
    EXPECT_TRUE(names(withPart([](auto&, auto& one) { one.susceptibility = std::nan(""); }), "susceptibility"));
    EXPECT_TRUE(names(withPart([](auto&, auto& one) { one.remanence_T.y() = INFINITY; }), "remanence"));
    EXPECT_TRUE(names(withPart([](auto&, auto& one) { one.placements.clear(); }), "nowhere"));
    EXPECT_TRUE(names(withPart([](auto&, auto& one) { one.placements[0].state = "up"; }), "no group"));
    EXPECT_TRUE(names(withPart([](auto&, auto& one) { one.placements[0].centre_m.z() = 1e9; }), "1000 m"));
    EXPECT_TRUE(names(withPart([](auto&, auto& one) { one.placements[0].yaw_rad = NAN; }), "finite"));
    EXPECT_TRUE(names(withPart([](auto&, auto& one) { one.group = "gear"; }), "names its state"));
    EXPECT_NE(withPart([](auto& bench, auto&) { bench.sensor_m.x() = NAN; }).find("sensor"), std::string::npos);
}

TEST(BenchModel, RefusesASensorOnAWireAndDamagedCircuits)
{
    IronBench bench;
    const auto with = [&](std::variant<CurrentLoop, WirePath> conductor) {
        bench.circuits = {{"lamp", {std::move(conductor)}, 1, true}};
        return faultOf(bench);
    };
    EXPECT_NE(with(WirePath{{{-1, 0, 0}, {1, 0, 0}}}).find("“lamp”: the sensor stands on its wire"), std::string::npos);
    EXPECT_NE(with(CurrentLoop{{0.5, 0, 0}, {0, 0, 1}, 1, 1}).find("stands on its wire"), std::string::npos);
    EXPECT_NE(with(CurrentLoop{{0.5, 0, 0}, {0, 0, 0}, 1, 1}).find("no direction"), std::string::npos);
    EXPECT_NE(with(CurrentLoop{{0.5, 0, 0}, {0, 0, 1}, 0, 1}).find("diameter"), std::string::npos);
    EXPECT_NE(with(CurrentLoop{{0.5, 0, 0}, {0, 0, 1}, 1, 0}).find("one turn"), std::string::npos);
    EXPECT_NE(with(WirePath{{{1, 0, 0}}}).find("two points"), std::string::npos);
    EXPECT_NE(with(WirePath{{{1, 0, 0}, {NAN, 0, 0}}}).find("1000 m"), std::string::npos);
    EXPECT_EQ(with(WirePath{{{1, 0, 0}, {1, 0, 0}, {2, 1, 0}}}), "ok"); // a point twice does no harm
    bench.circuits[0].conductors.clear();
    EXPECT_NE(faultOf(bench).find("no loop and no wire"), std::string::npos);
}

TEST(BenchModel, TenThousandPartsCanBeWatchedAndStopped)
{
    IronBench bench;
    for (int i = 0; i < 10'000; ++i) // every hundredth near enough for a tensor, all of these alike
        bench.parts.push_back(part("rivet " + std::to_string(i), i % 100 ? Shape(Sphere{0.004 + 1e-6 * i}) : Shape(Box{{0.3, 0.2, 0.1}}),
            100, {std::cos(i) * 0.8, std::sin(i) * 0.8, i % 100 ? 0.1 + 1e-4 * i : 0.2}));
    int calls = 0;
    double last = 0;
    const auto all = benchModel(bench, {}, [&](double done) {
        EXPECT_GE(done, last);
        EXPECT_LE(done, 1);
        last = done;
        ++calls;
        return true;
    });
    ASSERT_TRUE(all.ok());
    EXPECT_GT(calls, 10'000);
    EXPECT_GT(last, 0.99);
    const auto half = benchModel(bench, {}, [&](double done) { return done < 0.5; });
    ASSERT_FALSE(half.ok());
    EXPECT_EQ(half.error().code, ErrorCode::Cancelled);
}

TEST(BenchModel, SaysWhereItIsUncertain)
{
    IronBench bench;
    bench.parts = {part("bracket", Box{{0.5, 0.3, 0.3}}, 10, {0, 0, 0})};
    bench.sensor_m = {0.27, 0, 0};
    const auto near = modelOf(bench);
    ASSERT_EQ(near.warnings.size(), 1U);
    EXPECT_NE(near.warnings[0].english().find("bracket"), std::string::npos);
    bench.sensor_m = {0.5, 0, 0};
    EXPECT_TRUE(modelOf(bench).warnings.empty());
}

/// A ball of χ 1000 at 1 m of 0.1 m radius: S along the line to it 2 (0.1)³ χ/(3 + χ), so a shock may leave 50 000 nT times that behind.
TEST(BenchModel, WhatMayDriftIsToldByCoercivity)
{
    EXPECT_EQ(ironClassOf(49), IronClass::Soft);
    EXPECT_EQ(ironClassOf(50), IronClass::Between);
    EXPECT_EQ(ironClassOf(3000), IronClass::Between);
    EXPECT_EQ(ironClassOf(3001), IronClass::Hard);
    IronBench bench;
    bench.parts = {part("ball", Sphere{0.2}, 1000, {1, 0, 0})};
    EXPECT_EQ(mayDrift_nT(modelOf(bench).parts[0]), std::nullopt) << "not known";
    EXPECT_TRUE(modelOf(bench).warnings.empty());
    bench.parts[0].coercivity_A_per_m = 400;
    const double induced_nT = 2e-3 * 1000 / 1003 * 50000;
    EXPECT_NEAR(*mayDrift_nT(modelOf(bench).parts[0]), induced_nT, 0.1);
    bench.parts[0].remanence_T = {0.1, 0, 0};
    const auto steel = modelOf(bench);
    EXPECT_NEAR(*mayDrift_nT(steel.parts[0]), induced_nT + steel.parts[0].hardIron_nT.norm(), 0.1);
    ASSERT_EQ(steel.warnings.size(), 1u);
    EXPECT_NE(steel.warnings[0].english().find("between soft and hard (400 A/m)"), std::string::npos);
    bench.parts[0].coercivity_A_per_m = 4;
    EXPECT_NEAR(*mayDrift_nT(modelOf(bench).parts[0]), steel.parts[0].hardIron_nT.norm(), 1e-9) << "what it kept may go";
    bench.parts[0].coercivity_A_per_m = 800000;
    EXPECT_EQ(*mayDrift_nT(modelOf(bench).parts[0]), 0) << "a magnet stays";
    EXPECT_TRUE(modelOf(bench).warnings.empty());
}
