#pragma once
/// A flight and the instruments that are carried through it: what a user writes down, in the units in which it is written.

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/Result.h"
#include "core/sensor/SensorModel.h"

namespace lubberline {

inline constexpr double kGravity_m_s2 = 9.80665;
inline constexpr double kEarthRadius_m = 6378137.0; ///< equatorial: the book's 20 925 646 ft
inline constexpr double kMeanEarthRadius_m = 6371008.8;
inline constexpr double kEarthRate_rad_s = 7.292115e-5; ///< 15.0411°/h

/// What the aircraft does for a time. Those that overlap add up.
struct Manoeuvre {
    double from_s = 0, to_s = 0;
    double turnRate_deg_s = 0; ///< to the right positive; coordinated: the bank is that of the turn
    double acceleration_m_s2 = 0;
    double climb_m_s = 0; ///< taken up and given up within kClimbEntry_s
    friend bool operator==(const Manoeuvre&, const Manoeuvre&) = default;
};
inline constexpr double kClimbEntry_s = 5.0;

/// Horizontal accelerations that nobody wants, along and across, independent: a resonance at the period. A regular one is a sine across.
struct Gusts {
    double rms_m_s2 = 0;
    double period_s = 15;
    std::uint32_t seed = 1;
    bool regular = false;
    friend bool operator==(const Gusts&, const Gusts&) = default;
};

enum class LoopKind { First, Damped, Integral, Third };

/// A sensor that only switches: no torque within the dead zone, a fixed rate beyond, which may differ between the sides.
struct LevelSwitch {
    double deadZone_deg = 0.1;
    double rate_deg_min = 4;        ///< when the axis leans forward or to starboard
    double reverseRate_deg_min = 4; ///< when it leans aft or to port
    friend bool operator==(const LevelSwitch&, const LevelSwitch&) = default;
};

/// What unbalance and compliance add to a gyro's drift: unbalance × g along + anisoelastic × g along × g vertical.
struct AccelerationDrift {
    double unbalance_deg_h_g = 0;
    double anisoelastic_deg_h_g2 = 0;
    friend bool operator==(const AccelerationDrift&, const AccelerationDrift&) = default;
};

/// A gyro that is levelled by the apparent vertical (core/reference/LevellingLoop.h).
struct VerticalGyro {
    LoopKind loop = LoopKind::First;
    double tau1_s = 60;
    double tau2_s = 15;  ///< damped and third order
    double tau3_s = 600; ///< integral and third order
    double drift_deg_h = 0;
    std::optional<double> cutoff_deg;           ///< no torque while the tilt that is sensed exceeds it
    std::optional<double> rateLimit_deg_min;    ///< of the torque
    std::optional<double> reverseLimit_deg_min; ///< of that aft and to port, where it differs
    std::optional<LevelSwitch> levelSwitch;     ///< in place of a sensor that measures
    bool rateCompensation = false;              ///< Earth rate and V/R are torqued out
    bool accelerationCorrection = false;        ///< dV/dt, V ψ̇ and Coriolis are taken off the sensor
    double turnRateError_deg_h = 0;             ///< of the ψ̇ in that correction [K 9.9]
    bool exactTilt = false;                     ///< atan(a/g) in place of the book's a/g
    double initialTilt_deg = 0;                 ///< forward
    double fastUntil_s = 0;                     ///< fast initial levelling: without cut-off and limits, with fastTau1_s
    double fastTau1_s = 6;
    AccelerationDrift accelerationDrift;
    friend bool operator==(const VerticalGyro&, const VerticalGyro&) = default;
};

/// A directional gyro, free or slaved.
struct HeadingGyro {
    double drift_deg_h = 0;
    bool apparentDrift = false;                ///< Earth rate and meridians are not compensated
    std::optional<double> slavingTau_s;        ///< first order
    std::optional<double> slavingRate_deg_min; ///< no faster than this; without a time constant: always at this rate
    std::optional<double> fastAbove_deg;       ///< errors beyond it are slaved at fastRate_deg_min
    double fastRate_deg_min = 180;
    std::optional<double> cutoutTurnRate_deg_s; ///< no slaving while the aircraft turns faster
    double outerAxisTilt_deg = 0;               ///< to starboard, beside the aircraft's own attitude
    double spinAxis_deg = 0;                    ///< magnetic azimuth
    bool levelOuterAxis = false;                ///< held vertical, whatever the attitude
    double initialError_deg = 0;
    AccelerationDrift accelerationDrift;
    [[nodiscard]] bool slaved() const { return slavingTau_s || slavingRate_deg_min; }
    friend bool operator==(const HeadingGyro&, const HeadingGyro&) = default;
};

enum class CompassType { Needle, FluxValve };

/// A card in liquid: J κ̈ + c(κ̇ − ω_liquid) + K sin(κ − κ_m) = 0, as period and damping.
struct CardInLiquid {
    double period_s = 15;
    double damping = 0.5;           ///< part of critical
    double liquidLag_s = 10;        ///< in which the liquid takes up the aircraft's turn
    std::optional<double> stop_deg; ///< tilt of the card in its bowl at which it binds
    friend bool operator==(const CardInLiquid&, const CardInLiquid&) = default;
};

/// The magnetic sensor. A needle levels itself to the apparent vertical; a flux valve is levelled by the vertical gyro, or hangs as well
/// where there is none.
struct CompassSensor {
    CompassType type = CompassType::FluxValve;
    std::optional<SensorModel> model; ///< the aircraft's own iron and currents
    double horizontal_nT = 0;         ///< that the model stands in
    std::optional<CardInLiquid> card;
    friend bool operator==(const CompassSensor&, const CompassSensor&) = default;
};

struct Scenario {
    double latitude_deg = 0;
    double dip_deg = 0;
    double speed_m_s = 0;   ///< at the beginning
    double heading_deg = 0; ///< magnetic, at the beginning; for the Earth's rotation magnetic north counts as north
    double step_s = 0.1;
    double duration_s = 0;
    std::vector<Manoeuvre> manoeuvres;
    std::optional<Gusts> gusts;
    std::optional<VerticalGyro> vertical;
    std::optional<HeadingGyro> gyro;
    CompassSensor compass;
    friend bool operator==(const Scenario&, const Scenario&) = default;
};

inline constexpr double kMostSteps = 2'000'000;

/// Errors: InvalidInput: a step or time constant that is not above 0, a manoeuvre that ends before it begins, more than kMostSteps steps.
Result<void> checkScenario(const Scenario& scenario);

} // namespace lubberline
