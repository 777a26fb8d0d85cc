#pragma once
/// What a compass may come to read: its coefficients' levels and drifts as far as they are known, and futures drawn from them.

#include <array>
#include <vector>

#include "core/fleet/SwingCurve.h"

namespace lubberline {

/// Level and drift of one coefficient with their covariance: a Kalman filter.
struct LevelAndDrift {
    double level = 0, slope = 0, p00 = 0, p01 = 0, p11 = 0;

    void wait(double years, double walkVariance);
    void see(double value, double variance);
};

struct CompassOutlook {
    std::array<LevelAndDrift, kCoefficientCount> state;
    std::array<double, kCoefficientCount> walk{}; ///< variance by which each wanders in a year
    int day = 0;
};

/// Standard normals, drawn once and the same for every compass: what tells two compasses apart is what is known of them, not the draw.
class FutureNormals {
public:
    FutureNormals(int futures, int steps);
    [[nodiscard]] const double* of(int future) const { return m_values.data() + m_each * static_cast<std::size_t>(future); }

private:
    std::size_t m_each;
    std::vector<double> m_values;
};

/// Futures of a compass in steps.
class Futures {
public:
    Futures(const CompassOutlook& now, double step_years);
    /// @return the step at the end of which it is out of the limit, 0: never; the first is where it is now
    [[nodiscard]] int goesOut(const double* normal, int steps, double limit_deg) const;

private:
    FiveTerms m_level{}, m_levelRoot{}, m_slope{}, m_along{}, m_slopeRoot{}, m_walkRoot{};
};

} // namespace lubberline
