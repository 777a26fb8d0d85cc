#pragma once
/// The loops that level a gyro to the apparent vertical [K 9.2–9.7]. σ is the gyro axis from the true vertical, ε = σ − a_H/g the
/// axis from the apparent one, θ̇ the rate of the true vertical in inertial space, ω_D the gyro's drift, u = ω_D − θ̇:
///   first order   (τ1 s + 1) σ = a_H/g + τ1 u                                                               [K 9.4]
///   damped        (τ1τ2 s² + τ1 s + 1) σ = a_H/g + (τ1τ2 s + τ1) u                                          [K 9.5]
///   integral      (τ1τ3 s² + τ3 s + 1) σ = (τ3 s + 1) a_H/g + τ1τ3 s u                                      [K 9.7]
///   third order   (τ1τ2τ3 s³ + τ1τ3 s² + τ3 s + 1) σ = (τ3 s + 1) a_H/g + τ1τ3 s(1 + τ2 s) u    (in words in the book)
/// Together: τ2 ṁ + m = ε, İ = m, σ̇ = −(m + I/τ3)/τ1 + u, with m = ε where nothing damps.

#include <array>

#include <Eigen/Core>

#include "core/base/Message.h"
#include "core/reference/Scenario.h"

namespace lubberline {

[[nodiscard]] bool hasDamping(LoopKind kind);
[[nodiscard]] bool hasIntegral(LoopKind kind);

/// |σ| over the tilt a_H/g of the apparent vertical, at an angular frequency.
[[nodiscard]] double gainAt(const VerticalGyro& loop, double frequency_rad_s);
/// What σ settles at under a constant u = ω_D − θ̇ [rad/s]: τ1 u, and 0 with an integral.
[[nodiscard]] double standoff_rad(const VerticalGyro& loop, double driftLessRate_rad_s);

struct LoopCharacter {
    double natural_rad_s = 0; ///< ω_n: 1/√(τ1τ2) or 1/√(τ1τ3); 1/τ1 of first order
    double damping = 1;       ///< ζ = ½√(τ1/τ2) or ½√(τ3/τ1); 1 of first order; of third order that of its slowest pair
    double largestGain = 1;   ///< over all frequencies
    bool stable = true;       ///< third order: τ3 > τ2 (Routh)
};
[[nodiscard]] LoopCharacter characterOf(const VerticalGyro& loop);
/// Empty where the loop is stable.
[[nodiscard]] Message whyUnstable(const VerticalGyro& loop);

/// σ, m and ∫m of one axis.
struct LoopState {
    double tilt_rad = 0, sensed_rad = 0, integral_rad_s = 0;
};

/// One axis over a step in which tilt a_H/g of the apparent vertical and u are constant: exact, whatever the step.
class LinearLoop {
public:
    LinearLoop(const VerticalGyro& loop, double step_s);
    [[nodiscard]] LoopState next(const LoopState& state, double apparentTilt_rad, double driftLessRate_rad_s) const
    {
        const auto row = [&](int i) {
            // What does not wait for the state before is added first.
            const double driven = m_step(i, 3) * apparentTilt_rad + m_step(i, 4) * driftLessRate_rad_s;
            return driven + m_step(i, 0) * state.tilt_rad + m_step(i, 1) * state.sensed_rad + m_step(i, 2) * state.integral_rad_s;
        };
        LoopState after{row(0), 0, row(2)};
        after.sensed_rad = m_damped ? row(1) : after.tilt_rad - apparentTilt_rad;
        return after;
    }

private:
    Eigen::Matrix<double, 3, 5> m_step; ///< of σ, m, I, a_H/g, u
    bool m_damped;
};

} // namespace lubberline
