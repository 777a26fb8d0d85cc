#pragma once
/// From the magnetic sensor to the heading that is shown, a function a stage. All errors are read − magnetic [rad], (−π, π], one at
/// every point of the motion.

#include <span>
#include <vector>

#include "core/earth/EarthField.h"
#include "core/reference/Motion.h"
#include "core/reference/VerticalRun.h"
#include "core/sensor/SensorModel.h"

namespace lubberline {

/// Sines and cosines of pitch and roll.
struct TurnedBy {
    double sinPitch = 0, cosPitch = 1, sinRoll = 0, cosRoll = 1;
};

/// Points of a motion that follow one another, a part of the flight: each stage takes part after part and fills a figure for each point.
using MotionPart = std::span<const MotionPoint>;
using ErrorSeries = std::vector<double>;

/// The aircraft's attitude: the bank of its turn, the pitch of its climb.
void bodyAttitudes(MotionPart points, std::vector<TurnedBy>& attitudes);
/// Of a sensor that hangs freely.
void hangingAttitudes(MotionPart points, std::vector<TurnedBy>& attitudes);
/// Of a sensor on a platform with this tilt.
void platformAttitudes(const std::vector<AxisTilt>& tilt, std::vector<TurnedBy>& attitudes);

/// The field where the sensor is, forward, starboard and down in level axes along the heading [nT].
struct LevelField {
    std::vector<double> forward, starboard, down;
};

/// The Earth's field in the aircraft, with its iron or without; the iron turns with the aircraft.
class AircraftField {
public:
    AircraftField(const Scenario& scenario, bool iron);
    void take(MotionPart points, const std::vector<TurnedBy>& body, LevelField& field) const;
    /// Less of it across the sensor tells no heading [nT].
    [[nodiscard]] double smallest_nT() const;

private:
    bool m_iron;
    SensorResponse m_response;
    MeridianField m_field;
};

/// What the sensor reads in a field.
class MagneticSensor {
public:
    explicit MagneticSensor(double smallest_nT) : m_smallest_nT(smallest_nT) {}
    /// @param sensor empty: level
    void take(MotionPart points, const LevelField& field, std::span<const TurnedBy> sensor, ErrorSeries& errors);
    /// No horizontal field was left at times: what was read before stays.
    [[nodiscard]] bool vanished() const { return m_vanished; }

private:
    double m_smallest_nT, m_last = 0;
    bool m_vanished = false;
    std::vector<double> m_north, m_east;
};

/// The card in its liquid [own]: ë + 2ζω(ė + ω_liquid) + ω² sin(e − e_m) = 0, τ_L ω̇_liquid = ψ̇ − ω_liquid; where it binds it turns with
/// the bowl. It begins at rest where the magnet points.
class LiquidCard {
public:
    LiquidCard(const CardInLiquid& card, double step_s) : m_card(card), m_step_s(step_s) {}
    void take(MotionPart points, const std::vector<TurnedBy>& body, std::span<const TurnedBy> sensor, const ErrorSeries& sensor_rad,
        ErrorSeries& errors);

private:
    const CardInLiquid& m_card;
    double m_step_s;
    bool m_begun = false;
    double m_error = 0, m_rate = 0, m_liquid = 0;
};

/// Drift of a gyro's reading at every point [rad/s].
void driftOf(const Scenario& scenario, const HeadingGyro& gyro, MotionPart points, std::vector<double>& drift);
/// Gimbal error of the outer axis that is the body's z axis, tilted to starboard by what the gyro says.
void gimbalErrors(const HeadingGyro& gyro, MotionPart points, const std::vector<TurnedBy>& body, ErrorSeries& errors);

/// Slaved: τ_s ė + e = e_m + τ_s d, no faster than its rate; free: ė = d.
class ShownByGyro {
public:
    ShownByGyro(const HeadingGyro& gyro, bool slaved, double step_s);
    /// What it shows at a point; then it goes on to the next.
    double next(double turnRate_rad_s, double drift_rad_s, double sensor_rad);

private:
    bool m_slaved;
    double m_step_s, m_tau_s, m_follow, m_most, m_fast, m_fastAbove, m_cutout;
    double m_error;
};

} // namespace lubberline
