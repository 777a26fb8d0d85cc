#include "core/reference/LevellingLoop.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>

#include "core/algebra/Exponential.h"
#include "core/algebra/Spectra.h"
#include "core/base/Number.h"

namespace lubberline {

bool hasDamping(LoopKind kind) { return kind == LoopKind::Damped || kind == LoopKind::Third; }
bool hasIntegral(LoopKind kind) { return kind == LoopKind::Integral || kind == LoopKind::Third; }

double gainAt(const VerticalGyro& loop, double frequency_rad_s)
{
    const std::complex<double> s(0, frequency_rad_s);
    const double tau2 = hasDamping(loop.loop) ? loop.tau2_s : 0;
    const auto inner = loop.tau1_s * s * (1.0 + tau2 * s); // τ1 s(1 + τ2 s)
    if (!hasIntegral(loop.loop))
        return std::abs(1.0 / (inner + 1.0));
    const auto correction = loop.tau3_s * s + 1.0;
    return std::abs(correction / (loop.tau3_s * s * inner + correction));
}

double standoff_rad(const VerticalGyro& loop, double driftLessRate_rad_s)
{
    return hasIntegral(loop.loop) ? 0.0 : loop.tau1_s * driftLessRate_rad_s;
}

LoopCharacter characterOf(const VerticalGyro& loop)
{
    LoopCharacter character;
    const double tau1 = loop.tau1_s, tau2 = loop.tau2_s, tau3 = loop.tau3_s;
    switch (loop.loop) {
    case LoopKind::First: character.natural_rad_s = 1 / tau1; break;
    case LoopKind::Damped:
        character.natural_rad_s = 1 / std::sqrt(tau1 * tau2);
        character.damping = std::sqrt(tau1 / tau2) / 2;
        break;
    case LoopKind::Integral:
        character.natural_rad_s = 1 / std::sqrt(tau1 * tau3);
        character.damping = std::sqrt(tau3 / tau1) / 2;
        break;
    case LoopKind::Third: {
        // The companion matrix of s³ + s²/τ2 + s/(τ1τ2) + 1/(τ1τ2τ3).
        Eigen::Matrix3d companion;
        companion << 0, 1, 0, 0, 0, 1, -1 / (tau1 * tau2 * tau3), -1 / (tau1 * tau2), -1 / tau2;
        const auto poles = generalParts(companion);
        if (!poles)
            break;
        std::complex<double> slowest = poles->values[0];
        for (const auto& pole : poles->values)
            if (pole.real() > slowest.real())
                slowest = pole;
        character.natural_rad_s = std::abs(slowest);
        character.damping = -slowest.real() / std::abs(slowest);
        character.stable = tau3 > tau2;
        break;
    }
    }
    for (int i = -300; i <= 300; ++i)
        character.largestGain = std::max(character.largestGain, gainAt(loop, std::pow(10.0, i / 100.0) / tau1));
    return character;
}

Message whyUnstable(const VerticalGyro& loop)
{
    if (loop.loop != LoopKind::Third || loop.tau3_s > loop.tau2_s)
        return {};
    return {MARKED("core", "the levelling loop is unstable: third order needs tau3 > tau2, and tau3 is %1 s with tau2 %2 s"),
        shortestNumber(loop.tau3_s), shortestNumber(loop.tau2_s)};
}

LinearLoop::LinearLoop(const VerticalGyro& loop, double step_s) : m_damped(hasDamping(loop.loop))
{
    const double per1 = 1 / loop.tau1_s, per3 = hasIntegral(loop.loop) ? 1 / loop.tau3_s : 0;
    Eigen::Matrix<double, 5, 5> rate = Eigen::Matrix<double, 5, 5>::Zero();
    if (m_damped) {
        rate.row(0) << 0, -per1, -per1 * per3, 0, 1;
        rate.row(1) << 1 / loop.tau2_s, -1 / loop.tau2_s, 0, -1 / loop.tau2_s, 0;
        rate.row(2) << 0, 1, 0, 0, 0;
    } else { // m = σ − a_H/g
        rate.row(0) << -per1, 0, -per1 * per3, per1, 1;
        rate.row(2) << 1, 0, 0, -1, 0;
    }
    m_step = exponential(rate * step_s).topRows<3>();
}

} // namespace lubberline
