// The fast map held against the plain formula, and what is read off a map.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>

#include "core/sensor/map/DeviationMap.h"
#include "core/sensor/map/VectorAtan2.h"

namespace lubberline {
namespace {

constexpr std::array kAxes{AttitudeAxis::Heading, AttitudeAxis::Pitch, AttitudeAxis::Roll};

MapRequest request(AttitudeAxis x, AttitudeAxis y, int columns, int rows, double held_deg = 0)
{
    return {{x, fullRange(x), columns}, {y, fullRange(y), rows}, held_deg};
}

SensorModel someIron()
{
    SensorModel model;
    model.softIron << 0.03, 0.01, -0.02, -0.015, 0.05, 0.01, 0.02, -0.01, 0.04;
    model.hardIron_nT = {2000, -1500, 800};
    return model;
}

MeridianField warsaw() { return MeridianField::fromDip(18500, toRadians(67)); }

DeviationMap mapOf(const SensorModel& model, const MapRequest& request, const MeridianField& field = warsaw())
{
    DeviationMap map;
    computeMap(responseOf(model), field, request, map);
    return map;
}

double apart(double a, double b) { return std::abs(std::remainder(a - b, 2 * kPi)); }

TEST(DeviationMap, fastIsPlainOnRandomModels)
{
    std::mt19937_64 random(11);
    std::normal_distribution<double> normal;
    for (int round = 0; round < 120; ++round) {
        SensorResponse sensor;
        const double size = round % 3 == 0 ? 1.0 : round % 3 == 1 ? 0.2 : 0.01; // wild, strong and usual iron
        for (int i = 0; i < 9; ++i)
            sensor.gain(i / 3, i % 3) += size * normal(random);
        for (int i = 0; i < 3; ++i)
            sensor.offset_nT[i] = size * 30000 * normal(random);
        const MeridianField field{std::abs(20000 + 15000 * normal(random)), 40000 * normal(random)};
        const auto x = kAxes[static_cast<std::size_t>(round % 3)], y = kAxes[static_cast<std::size_t>((round + 1 + round / 3 % 2) % 3)];
        const auto asked = request(x, y, 37 + round % 9, 19 + round % 5, 40 * normal(random));
        DeviationMap fast, plain;
        computeMap(sensor, field, asked, fast);
        computeMapPlainly(sensor, field, asked, plain);
        ASSERT_EQ(fast.defined, plain.defined);
        for (std::size_t i = 0; i < fast.deviation_rad.size(); ++i) {
            ASSERT_LT(apart(fast.deviation_rad[i], plain.deviation_rad[i]), 1e-12) << round << ' ' << i;
            ASSERT_LE(std::abs(fast.deviation_rad[i]), kPi);
        }
    }
}

TEST(DeviationMap, fieldsThatLeaveNothingForTheCompass)
{
    for (const MeridianField field : {MeridianField{0, 0}, MeridianField{0, 56000}, MeridianField{0, -56000}}) {
        const auto map = mapOf({}, request(AttitudeAxis::Heading, AttitudeAxis::Pitch, 37, 19), field);
        for (std::size_t i = 0; i < map.defined.size(); ++i) {
            EXPECT_EQ(map.defined[i], 0) << i;
            EXPECT_EQ(map.deviation_rad[i], 0.0);
        }
        EXPECT_TRUE(extremesOf(map).empty());
        EXPECT_TRUE(vanishingPlaces(map).empty());
    }
}

TEST(DeviationMap, aMapIsReusedForAnotherModelAndSize)
{
    DeviationMap map;
    computeMap(responseOf({}), {0, 0}, request(AttitudeAxis::Heading, AttitudeAxis::Pitch, 37, 19), map);
    computeMap(responseOf(someIron()), warsaw(), request(AttitudeAxis::Pitch, AttitudeAxis::Roll, 11, 7), map);
    EXPECT_EQ(map.deviation_rad.size(), 77u);
    EXPECT_EQ(std::count(map.defined.begin(), map.defined.end(), 1), 77);
}

TEST(DeviationMap, withoutIronThereIsNoDeviation)
{
    for (const auto x : kAxes)
        for (const auto y : kAxes) {
            if (x == y)
                continue;
            for (const double value : mapOf({}, request(x, y, 37, 19, 25)).deviation_rad)
                EXPECT_LT(std::abs(value), 1e-12);
        }
}

TEST(DeviationMap, aTurnedSensorReadsTheSameEverywhereOnALevel)
{
    SensorModel model;
    model.misalignment.yaw_rad = toRadians(3.0);
    auto level = request(AttitudeAxis::Heading, AttitudeAxis::Pitch, 73, 3);
    level.y.range = {-0.0, 0.0001};
    const auto map = mapOf(model, level);
    for (int x = 0; x < 73; ++x)
        EXPECT_NEAR(map.deviation_rad[map.index(x, 0)], -toRadians(3.0), 1e-12); // turned clockwise it reads high
}

TEST(DeviationMap, noseStraightUpAndDown)
{
    SensorModel model = someIron();
    model.misalignment = {0.02, -0.03, 0.05};
    for (const auto axis : {AttitudeAxis::Heading, AttitudeAxis::Roll}) {
        auto asked = request(axis, AttitudeAxis::Pitch, 73, 2, 33);
        ASSERT_EQ(asked.y.range.from_deg, -90.0);
        DeviationMap plain;
        computeMapPlainly(responseOf(model), warsaw(), asked, plain);
        const auto fast = mapOf(model, asked);
        for (std::size_t i = 0; i < fast.deviation_rad.size(); ++i)
            EXPECT_LT(apart(fast.deviation_rad[i], plain.deviation_rad[i]), 1e-12) << i;
    }
}

TEST(DeviationMap, aWholeTurnLaterItIsTheSame)
{
    auto asked = request(AttitudeAxis::Heading, AttitudeAxis::Roll, 73, 37, 20);
    const auto first = mapOf(someIron(), asked);
    asked.x.range = {360, 720};
    const auto later = mapOf(someIron(), asked);
    for (std::size_t i = 0; i < first.deviation_rad.size(); ++i)
        EXPECT_NEAR(first.deviation_rad[i], later.deviation_rad[i], 1e-12);
    for (int y = 0; y < 37; ++y)
        EXPECT_NEAR(first.deviation_rad[first.index(0, y)], first.deviation_rad[first.index(72, y)], 1e-12);
}

/// Port and starboard exchanged: what was read on 030 with the starboard wing down is read on 330 with the port wing down, and
/// the deviation has the other sign.
TEST(DeviationMap, seenInAMirror)
{
    SensorModel model = someIron(), mirrored = model;
    for (const auto& [row, column] : {std::pair{0, 1}, {1, 0}, {1, 2}, {2, 1}})
        mirrored.softIron(row, column) *= -1;
    mirrored.hardIron_nT.y() *= -1;
    const auto asked = request(AttitudeAxis::Heading, AttitudeAxis::Roll, 73, 37, 15);
    const auto map = mapOf(model, asked), mirror = mapOf(mirrored, asked);
    for (int y = 0; y < 37; ++y)
        for (int x = 0; x < 73; ++x)
            EXPECT_NEAR(map.deviation_rad[map.index(x, y)], -mirror.deviation_rad[mirror.index(72 - x, 36 - y)], 1e-12);
}

/// On a line through the place where the field vanishes, a thousandth of a degree a node: the nearer, the larger the part that
/// rounding would have in a polynomial.
TEST(DeviationMap, fastIsPlainBesideAVanishingPlace)
{
    SensorModel model;
    model.hardIron_nT = {-18500, 0, 0};
    auto asked = request(AttitudeAxis::Heading, AttitudeAxis::Pitch, 2001, 3);
    asked.x.range = {-1, 1};
    asked.y.range = {-1, 1};
    DeviationMap plain;
    computeMapPlainly(responseOf(model), warsaw(), asked, plain);
    const auto fast = mapOf(model, asked);
    EXPECT_EQ(fast.defined, plain.defined);
    EXPECT_EQ(fast.defined[fast.index(1000, 1)], 0);
    EXPECT_EQ(std::count(fast.defined.begin(), fast.defined.end(), 0), 1);
    for (std::size_t i = 0; i < fast.deviation_rad.size(); ++i)
        EXPECT_LT(apart(fast.deviation_rad[i], plain.deviation_rad[i]), 1e-12) << i;
}

TEST(DeviationMap, nodesAreTheAttitudesThatTheySay)
{
    const auto asked = request(AttitudeAxis::Roll, AttitudeAxis::Heading, 25, 13, 10);
    const auto map = mapOf(someIron(), asked);
    const Attitude attitude{MagneticHeading::fromDegrees(asked.y.at_deg(4)), toRadians(10), toRadians(asked.x.at_deg(9))};
    EXPECT_DOUBLE_EQ(asked.x.at_deg(9), -45.0);
    EXPECT_DOUBLE_EQ(asked.y.at_deg(4), 120.0);
    EXPECT_NEAR(map.deviation_rad[map.index(9, 4)], readSensor(someIron(), warsaw(), attitude).deviation->radians(), 1e-12);
}

TEST(DeviationMap, requestsThatCannotBe)
{
    EXPECT_FALSE(checkMapRequest(request(AttitudeAxis::Roll, AttitudeAxis::Roll, 10, 10)));
    EXPECT_FALSE(checkMapRequest(request(AttitudeAxis::Heading, AttitudeAxis::Roll, 1, 10)));
    const auto large = checkMapRequest(request(AttitudeAxis::Heading, AttitudeAxis::Roll, 100'000, 100'000));
    ASSERT_FALSE(large);
    EXPECT_NE(large.error().message.english().find("10000000000 points"), std::string::npos) << large.error().message.english();
    EXPECT_NE(large.error().message.english().find("MiB"), std::string::npos);
    EXPECT_TRUE(checkMapRequest(request(AttitudeAxis::Heading, AttitudeAxis::Roll, 361, 181)));
}

TEST(DeviationMap, differenceIsWrappedAndUndefinedWhereEitherIs)
{
    DeviationMap a, b;
    a.request = b.request = request(AttitudeAxis::Heading, AttitudeAxis::Roll, 2, 2);
    a.deviation_rad = {3.0, 0.1, 0, 1};
    b.deviation_rad = {-3.0, 0.3, 0, 1};
    a.defined = {1, 1, 0, 1};
    b.defined = {1, 1, 1, 0};
    const auto difference = differenceOf(a, b);
    EXPECT_NEAR(difference.deviation_rad[0], 2 * kPi - 6.0, 1e-12);
    EXPECT_NEAR(difference.deviation_rad[1], 0.2, 1e-12);
    EXPECT_EQ(difference.defined, (std::vector<std::uint8_t>{1, 1, 0, 0}));
}

TEST(MapExtremes, ofAHillThatCrossesNorth)
{
    DeviationMap map;
    map.request = request(AttitudeAxis::Heading, AttitudeAxis::Pitch, 37, 19);
    for (int y = 0; y < 19; ++y)
        for (int x = 0; x < 37; ++x) {
            const double heading = toRadians(map.request.x.at_deg(x)), pitch = toRadians(map.request.y.at_deg(y));
            map.deviation_rad.push_back(0.2 * std::cos(heading) * std::cos(pitch) + 0.05 * std::cos(2 * heading) * std::cos(pitch));
            map.defined.push_back(1);
        }
    const auto extremes = extremesOf(map);
    ASSERT_EQ(extremes.size(), 2u); // south is the only other place where the slope is nothing
    EXPECT_TRUE(extremes[0].maximum);
    EXPECT_EQ(extremes[0].x_deg, 0.0); // north is one place, though two columns show it
    EXPECT_EQ(extremes[0].y_deg, 0.0);
    EXPECT_NEAR(extremes[0].deviation_rad, 0.25, 1e-12);
    EXPECT_FALSE(extremes[1].maximum);
    EXPECT_EQ(extremes[1].x_deg, 180.0);
    EXPECT_EQ(extremesOf(map, 1).size(), 1u);
}

TEST(MapExtremes, aSlantingRidgeHasOneTop)
{
    DeviationMap map;
    map.request = request(AttitudeAxis::Heading, AttitudeAxis::Roll, 361, 181);
    for (int y = 0; y < 181; ++y)
        for (int x = 0; x < 361; ++x) { // its top is in the middle of a cell; the nodes at both ends of the cell's diagonal are equal
            const double u = map.request.x.at_deg(x) - 90.5, v = map.request.y.at_deg(y) - 11;
            map.deviation_rad.push_back(0.1 * std::exp(-(u - v) * (u - v) / 40 - (u + v) * (u + v) / 4000));
            map.defined.push_back(1);
        }
    const auto extremes = extremesOf(map);
    EXPECT_EQ(std::count_if(extremes.begin(), extremes.end(), [](const MapExtreme& each) { return each.maximum; }), 1);
}

TEST(VanishingPlaces, whereHardIronCancelsTheField)
{
    // On heading 090 the Earth's horizontal field at the sensor is H to port; hard iron Q to starboard leaves H − Q cos φ of
    // it. On heading 270 it is to starboard, and upside down the iron is to port.
    SensorModel model;
    model.hardIron_nT = {0, 20000, 0};
    const auto asked = request(AttitudeAxis::Heading, AttitudeAxis::Roll, 360, 360); // no node hits the places
    const auto places = vanishingPlaces(mapOf(model, asked));
    ASSERT_EQ(places.size(), 4u);
    const double tilt_deg = toDegrees(std::acos(18500.0 / 20000.0));
    for (const auto& place : places) {
        const bool upright = std::abs(place.y_deg) < 90;
        EXPECT_NEAR(place.x_deg, upright ? 90.0 : 270.0, 1.0);
        EXPECT_NEAR(std::abs(place.y_deg), upright ? tilt_deg : 180.0 - tilt_deg, 1.0);
    }
    EXPECT_TRUE(vanishingPlaces(mapOf(someIron(), asked)).empty());
}

TEST(VectorAtan2, isTheLibrarysWithinAFewUnits)
{
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> exponent(-12, 12), sign(-1, 1);
    std::vector<double> y(10007), x(10007), out(10007);
    for (std::size_t i = 0; i < y.size(); ++i) {
        y[i] = std::copysign(std::pow(10, exponent(random)), sign(random));
        x[i] = std::copysign(std::pow(10, exponent(random)), sign(random));
    }
    vectorAtan2(y.data(), x.data(), out.data(), y.size());
    for (std::size_t i = 0; i < y.size(); ++i)
        EXPECT_NEAR(std::remainder(out[i] - std::atan2(y[i], x[i]), 2 * kPi), 0.0, 4 * std::abs(std::nextafter(out[i], 10) - out[i]))
            << y[i] << ' ' << x[i]; // where the library says −π, ours is π
}

/// Due south of nothing but rounding: π from either side, never −π, and finite where there is no direction.
TEST(VectorAtan2, halfATurnIsPositive)
{
    const std::vector<double> y{0.0, -0.0, -1e-300, 0.0, 0.0}, x{-1.0, -1.0, -1.0, 1.0, 0.0};
    std::vector<double> out(y.size());
    vectorAtan2(y.data(), x.data(), out.data(), y.size());
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(out[i], kPi) << i;
    EXPECT_EQ(out[3], 0.0);
    EXPECT_TRUE(std::isfinite(out[4]));
}

TEST(VectorAtan2, anglesOfARowAndItsWeakestPlace)
{
    const TrigonometricRow row{{0.1, 2.0, -0.5, 0.3, 0.2}, {1.0, 0.4, 3.0, -0.2, 0.1}};
    std::vector<double> cosine, sine, out(777);
    double least = 1e300;
    std::vector<double> expected;
    for (std::size_t i = 0; i < out.size(); ++i) {
        const double x = 0.0081 * static_cast<double>(i);
        cosine.push_back(std::cos(x));
        sine.push_back(std::sin(x));
        const double basis[] = {1, std::cos(x), std::sin(x), std::cos(2 * x), std::sin(2 * x)};
        const double up = std::inner_product(basis, basis + 5, row.sine, 0.0),
                     across = std::inner_product(basis, basis + 5, row.cosine, 0.0);
        expected.push_back(std::atan2(up, across));
        least = std::min(least, up * up + across * across);
    }
    EXPECT_NEAR(vectorAngles(row, cosine.data(), sine.data(), out.data(), out.size()), least, 1e-13);
    for (std::size_t i = 0; i < out.size(); ++i)
        EXPECT_NEAR(out[i], expected[i], 1e-13) << i;
}

} // namespace
} // namespace lubberline
