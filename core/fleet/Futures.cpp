#include "core/fleet/Futures.h"

#include <algorithm>
#include <cmath>

#include "core/fleet/FleetRandom.h"

namespace lubberline {

namespace {

/// The amplitudes together bound the curve: most need no look at its headings.
bool isBeyond(const FiveTerms& v, double limit_deg)
{
    const double most = std::abs(v[0]) + std::sqrt(v[1] * v[1] + v[2] * v[2]) + std::sqrt(v[3] * v[3] + v[4] * v[4]);
    return most > limit_deg && largestOf_deg(v) > limit_deg;
}

constexpr std::size_t kAtFirst = 2 * kCoefficientCount; ///< normals for levels and drifts

} // namespace

void LevelAndDrift::wait(double years, double walkVariance)
{
    level += slope * years;
    p00 += 2 * years * p01 + years * years * p11 + walkVariance * years;
    p01 += years * p11;
}

void LevelAndDrift::see(double value, double variance)
{
    const double s = p00 + variance, k0 = p00 / s, k1 = p01 / s, off = value - level;
    level += k0 * off;
    slope += k1 * off;
    p11 -= k1 * p01;
    p01 -= k0 * p01;
    p00 -= k0 * p00;
}

FutureNormals::FutureNormals(int futures, int steps) : m_each(kAtFirst + kCoefficientCount * static_cast<std::size_t>(steps))
{
    FleetRandom random(ContentSeed{}.add(futures).add(steps).value());
    m_values.resize(m_each * static_cast<std::size_t>(futures));
    for (double& value : m_values)
        value = random.normal();
}

Futures::Futures(const CompassOutlook& now, double step_years)
{
    for (std::size_t c = 0; c < kCoefficientCount; ++c) {
        const LevelAndDrift& s = now.state[c];
        m_level[c] = s.level;
        m_levelRoot[c] = std::sqrt(std::max(s.p00, 0.0));
        const double along = m_levelRoot[c] > 0 ? s.p01 / m_levelRoot[c] : 0.0;
        m_slope[c] = s.slope * step_years;
        m_along[c] = along * step_years;
        m_slopeRoot[c] = std::sqrt(std::max(0.0, s.p11 - along * along)) * step_years;
        m_walkRoot[c] = std::sqrt(std::max(0.0, now.walk[c] * step_years));
    }
}

int Futures::goesOut(const double* normal, int steps, double limit_deg) const
{
    FiveTerms level{}, slope{};
    for (std::size_t c = 0; c < kCoefficientCount; ++c) {
        const double a = normal[2 * c];
        level[c] = m_level[c] + m_levelRoot[c] * a;
        slope[c] = m_slope[c] + m_along[c] * a + m_slopeRoot[c] * normal[2 * c + 1];
    }
    normal += kAtFirst;
    for (int step = 0;; ++step, normal += kCoefficientCount) {
        if (isBeyond(level, limit_deg))
            return step + 1;
        if (step == steps)
            return 0;
        for (std::size_t c = 0; c < kCoefficientCount; ++c)
            level[c] += slope[c] + m_walkRoot[c] * normal[c];
    }
}

} // namespace lubberline
