#pragma once
/// The whole chain (field → attitude → iron → currents → misalignment → heading) a second time, written from directions in
/// space instead of rotation matrices, in long double: what the program's chain is held against.

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "core/sensor/SensorReading.h"

namespace lubberline::test {

using Direction = std::array<long double, 3>;

inline long double dot(const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Direction cross(const Direction& a, const Direction& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Where nose, starboard wing and floor point to, in axes north, east, down of whatever carries the body.
struct Axes {
    Direction nose, starboard, floor;
};

inline Axes axesAt(long double heading_rad, long double pitch_rad, long double roll_rad)
{
    const Direction nose{std::cos(pitch_rad) * std::cos(heading_rad), std::cos(pitch_rad) * std::sin(heading_rad), -std::sin(pitch_rad)};
    const Direction levelWing{-std::sin(heading_rad), std::cos(heading_rad), 0};
    const Direction levelFloor = cross(nose, levelWing);
    Axes axes{nose, {}, {}};
    for (std::size_t i = 0; i < 3; ++i)
        axes.starboard[i] = levelWing[i] * std::cos(roll_rad) + levelFloor[i] * std::sin(roll_rad); // the starboard wing goes down
    axes.floor = cross(axes.nose, axes.starboard);
    return axes;
}

inline Direction seenFrom(const Axes& axes, const Direction& vector)
{
    return {dot(axes.nose, vector), dot(axes.starboard, vector), dot(axes.floor, vector)};
}

/// What acts at the sensor besides the Earth, term by term as [P 6, 9, 17] write it.
inline Direction withIron(const SensorModel& m, const Direction& B)
{
    Direction sum{};
    for (int i = 0; i < 3; ++i) {
        const auto at = static_cast<std::size_t>(i);
        sum[at] = B[at] + m.hardIron_nT(i) + m.softConstant_nT(i);
        for (int j = 0; j < 3; ++j)
            sum[at] += static_cast<long double>(m.softIron(i, j)) * B[static_cast<std::size_t>(j)];
        for (const auto& circuit : m.circuits)
            sum[at] += circuit.on ? static_cast<long double>(circuit.field_nT_per_A(i)) * circuit.current_A : 0.0L;
    }
    return sum;
}

struct ChainReading {
    long double compass_rad = 0; ///< (−π, π]
    long double horizontal_nT = 0, total_nT = 0;
};

inline ChainReading chainReading(
    const SensorModel& model, const MeridianField& field, long double heading_rad, long double pitch_rad, long double roll_rad)
{
    const Direction earth{field.horizontal_nT, 0, field.down_nT};
    const Direction atSensor = withIron(model, seenFrom(axesAt(heading_rad, pitch_rad, roll_rad), earth));
    const Misalignment& turned = model.misalignment;
    const Direction measured = seenFrom(axesAt(turned.yaw_rad, turned.pitch_rad, turned.roll_rad), atSensor);
    // The system takes the sensor's axes for the body's, and looks where the horizontal part of what it measured lies from the
    // nose.
    const Axes body = axesAt(0, pitch_rad, roll_rad);
    Direction level{};
    for (std::size_t i = 0; i < 3; ++i)
        level[i] = measured[0] * body.nose[i] + measured[1] * body.starboard[i] + measured[2] * body.floor[i];
    return {-std::atan2(level[1], level[0]), std::hypot(level[0], level[1]), std::sqrt(dot(measured, measured))};
}

/// A model with everything in it: iron of tenths, tenths of the Earth's field in constants, a mount turned by some degrees.
inline SensorModel randomModel(std::mt19937& random, double softIron = 0.2, double constant_nT = 4000, double turned_rad = 0.2)
{
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto vector = [&](double size) { return Eigen::Vector3d{size * unit(random), size * unit(random), size * unit(random)}; };
    SensorModel model;
    for (int i = 0; i < 9; ++i)
        model.softIron(i / 3, i % 3) = softIron * unit(random);
    model.hardIron_nT = vector(constant_nT);
    model.softConstant_nT = vector(constant_nT / 4);
    model.circuits = {{"one", vector(constant_nT / 100), 10 * unit(random), true}, {"two", vector(constant_nT / 100), 10, false}};
    model.misalignment = {turned_rad * unit(random), turned_rad * unit(random), turned_rad * unit(random)};
    return model;
}

inline MeridianField dipField(double horizontal_nT, double dip_deg)
{
    return {horizontal_nT, horizontal_nT * std::tan(toRadians(dip_deg))};
}

inline SensorReading readLevel(const SensorModel& model, const MeridianField& field, double heading_deg)
{
    return readSensor(model, field, {MagneticHeading::fromDegrees(heading_deg), 0, 0});
}

} // namespace lubberline::test
