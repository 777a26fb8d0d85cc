#include "core/reference/VerticalRun.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/angle/Angle.h"
#include "core/base/Number.h"

namespace lubberline {

namespace {

constexpr double kStop_rad = kPi / 2;

double perHour(double rate_deg_h) { return toRadians(rate_deg_h) / 3600; }

} // namespace

/// What acts on the axis in a step: along the heading.
struct Acting {
    AxisTilt apparent;      ///< tilt of the vertical that is sensed, a/g
    AxisTilt driftLessRate; ///< ω_D − θ̇
};

class ActingForces {
public:
    ActingForces(const Scenario& scenario, const VerticalGyro& gyro)
        : m_gyro(gyro)
        , m_earth(kEarthRate_rad_s * std::cos(toRadians(scenario.latitude_deg)))
        , m_drift(perHour(gyro.drift_deg_h))
        , m_turnError(perHour(gyro.turnRateError_deg_h))
        , m_unbalance(perHour(gyro.accelerationDrift.unbalance_deg_h_g))
        , m_anisoelastic(perHour(gyro.accelerationDrift.anisoelastic_deg_h_g2))
    {
    }

    [[nodiscard]] Acting at(const MotionPoint& point) const
    {
        double forward = point.sensedForward_m_s2(), starboard = point.sensedStarboard_m_s2();
        if (m_gyro.accelerationCorrection) {
            forward = point.gustForward_m_s2;
            starboard = point.gustStarboard_m_s2 + point.speed_m_s * m_turnError;
        }
        const double gravity = point.gravity_m_s2();
        Acting acting{{forward / gravity, starboard / gravity}, {0, m_drift}};
        if (m_gyro.exactTilt)
            acting.apparent = {std::atan(acting.apparent.forward_rad), std::atan(acting.apparent.starboard_rad)};
        if (!m_gyro.rateCompensation) {
            // The true vertical turns with V/R along the track, and with Ω cos Φ towards the east.
            acting.driftLessRate.forward_rad -= point.speed_m_s / kEarthRadius_m + m_earth * point.sinHeading;
            acting.driftLessRate.starboard_rad -= m_earth * point.cosHeading;
        }
        const double along = point.sensedForward_m_s2() / kGravity_m_s2;
        acting.driftLessRate.starboard_rad += m_unbalance * along + m_anisoelastic * along * point.gravity_m_s2() / kGravity_m_s2;
        return acting;
    }

private:
    const VerticalGyro& m_gyro;
    double m_earth, m_drift, m_turnError, m_unbalance, m_anisoelastic;
};

namespace {

/// The same vector in north and east, where a gyro stays while the aircraft turns.
AxisTilt toNorthEast(const AxisTilt& tilt, const MotionPoint& point)
{
    return {tilt.forward_rad * point.cosHeading - tilt.starboard_rad * point.sinHeading,
        tilt.forward_rad * point.sinHeading + tilt.starboard_rad * point.cosHeading};
}
AxisTilt toHeading(const AxisTilt& northEast, const MotionPoint& point)
{
    return {northEast.forward_rad * point.cosHeading + northEast.starboard_rad * point.sinHeading,
        -northEast.forward_rad * point.sinHeading + northEast.starboard_rad * point.cosHeading};
}

bool needsShortSteps(const VerticalGyro& gyro)
{
    return gyro.cutoff_deg || gyro.rateLimit_deg_min || gyro.reverseLimit_deg_min || gyro.levelSwitch || gyro.fastUntil_s > 0;
}

/// Rate [rad/s] at which the axis is torqued, of one axis; positive leans it forward or to starboard.
double torqued(const VerticalGyro& gyro, bool fast, const LoopState& state)
{
    if (fast)
        return -state.sensed_rad / gyro.fastTau1_s;
    if (gyro.cutoff_deg && std::abs(state.sensed_rad) > toRadians(*gyro.cutoff_deg))
        return 0;
    const auto perMinute = [](double rate_deg_min) { return toRadians(rate_deg_min) / 60; };
    double wanted = state.sensed_rad;
    if (hasIntegral(gyro.loop))
        wanted += state.integral_rad_s / gyro.tau3_s;
    if (gyro.levelSwitch) {
        if (std::abs(wanted) <= toRadians(gyro.levelSwitch->deadZone_deg))
            return 0;
        return wanted > 0 ? -perMinute(gyro.levelSwitch->rate_deg_min) : perMinute(gyro.levelSwitch->reverseRate_deg_min);
    }
    const double rate = -wanted / gyro.tau1_s;
    if (!gyro.rateLimit_deg_min && !gyro.reverseLimit_deg_min)
        return rate;
    const double most = perMinute(gyro.rateLimit_deg_min.value_or(gyro.reverseLimit_deg_min.value_or(0)));
    return std::clamp(rate, -most, gyro.reverseLimit_deg_min ? perMinute(*gyro.reverseLimit_deg_min) : most);
}

} // namespace

/// Sensor and torques are fixed in the aircraft, the gyro's axis is not: the sensor's state turns with it.
class ShortSteps {
public:
    ShortSteps(const VerticalGyro& gyro, double step_s) : m_gyro(gyro)
    {
        double shortest = gyro.levelSwitch ? 10.0 : gyro.tau1_s;
        if (hasDamping(gyro.loop))
            shortest = std::min(shortest, gyro.tau2_s);
        if (gyro.fastUntil_s > 0)
            shortest = std::min(shortest, gyro.fastTau1_s);
        m_count = std::clamp(static_cast<int>(std::ceil(step_s * 100 / shortest)), 1, 1000);
        m_short_s = step_s / m_count;
        m_forget = hasDamping(gyro.loop) ? std::exp(-m_short_s / gyro.tau2_s) : 0;
    }

    void take(LoopState& axis, double apparent_rad, double driftLessRate, bool fast) const
    {
        for (int i = 0; i < m_count; ++i) {
            // The middle of the short step: second order, where the torque is smooth.
            LoopState middle = axis;
            sense(middle, apparent_rad, std::sqrt(m_forget));
            middle.integral_rad_s += middle.sensed_rad * m_short_s / 2;
            LoopState half = middle;
            half.tilt_rad += (torqued(m_gyro, fast, middle) + driftLessRate) * m_short_s / 2;
            sense(half, apparent_rad, m_forget > 0 ? 1.0 : 0.0);
            axis.tilt_rad += (torqued(m_gyro, fast, half) + driftLessRate) * m_short_s;
            axis.integral_rad_s += half.sensed_rad * m_short_s;
            const double before = axis.sensed_rad, error = half.tilt_rad - apparent_rad;
            axis.sensed_rad = m_forget > 0 ? error + (before - error) * m_forget : axis.tilt_rad - apparent_rad;
        }
    }

private:
    static void sense(LoopState& state, double apparent_rad, double forget)
    {
        const double error = state.tilt_rad - apparent_rad;
        state.sensed_rad = error + (state.sensed_rad - error) * forget;
    }

    const VerticalGyro& m_gyro;
    int m_count = 1;
    double m_short_s = 0, m_forget = 0;
};

namespace {

AxisTilt stopped(AxisTilt tilt, bool& atStop)
{
    const double square = tilt.forward_rad * tilt.forward_rad + tilt.starboard_rad * tilt.starboard_rad;
    if (square <= kStop_rad * kStop_rad)
        return tilt;
    atStop = true;
    const double size = std::sqrt(square);
    return {tilt.forward_rad * kStop_rad / size, tilt.starboard_rad * kStop_rad / size};
}

} // namespace

struct VerticalRun::State {
    State(const Scenario& scenario, const VerticalGyro& vertical)
        : gyro(vertical)
        , step_s(scenario.step_s)
        , forces(scenario, vertical)
        , linear(vertical, scenario.step_s)
        , shortSteps(vertical, scenario.step_s)
        , shortly(needsShortSteps(vertical))
    {
    }
    const VerticalGyro& gyro;
    double step_s;
    ActingForces forces;
    LinearLoop linear;
    ShortSteps shortSteps;
    bool shortly;
    std::size_t taken = 0;
    LoopState north, east;        // of the axis in north and east
    LoopState forward, starboard; // of what is fixed in the aircraft: m and ∫m
    std::optional<double> stopAt_s;
    double largestSquare = 0; ///< of the apparent vertical's lean

    AxisTilt next(const MotionPoint& point);
};

AxisTilt VerticalRun::State::next(const MotionPoint& point)
{
    if (taken == 0) {
        const AxisTilt initial = toNorthEast({toRadians(gyro.initialTilt_deg), 0}, point);
        north.tilt_rad = initial.forward_rad;
        east.tilt_rad = initial.starboard_rad;
    }
    const double time_s = static_cast<double>(taken++) * step_s;
    bool atStop = false;
    const AxisTilt now = stopped({north.tilt_rad, east.tilt_rad}, atStop);
    const AxisTilt tilt = toHeading(now, point);
    north.tilt_rad = now.forward_rad;
    east.tilt_rad = now.starboard_rad;
    if (atStop) { // what the loop remembers of a gyro at its stop is not its tilt
        if (!stopAt_s)
            stopAt_s = time_s;
        north.integral_rad_s = east.integral_rad_s = forward.integral_rad_s = starboard.integral_rad_s = 0;
        north.sensed_rad = std::clamp(north.sensed_rad, -kStop_rad, kStop_rad);
        east.sensed_rad = std::clamp(east.sensed_rad, -kStop_rad, kStop_rad);
    }
    const Acting acting = forces.at(point);
    const AxisTilt& vertical = acting.apparent;
    largestSquare = std::max(largestSquare, vertical.forward_rad * vertical.forward_rad + vertical.starboard_rad * vertical.starboard_rad);
    if (shortly) {
        const bool fast = time_s < gyro.fastUntil_s;
        forward.tilt_rad = tilt.forward_rad;
        starboard.tilt_rad = tilt.starboard_rad;
        shortSteps.take(forward, acting.apparent.forward_rad, acting.driftLessRate.forward_rad, fast);
        shortSteps.take(starboard, acting.apparent.starboard_rad, acting.driftLessRate.starboard_rad, fast);
        const AxisTilt after = toNorthEast({forward.tilt_rad, starboard.tilt_rad}, point);
        north.tilt_rad = after.forward_rad;
        east.tilt_rad = after.starboard_rad;
        return tilt;
    }
    const AxisTilt apparent = toNorthEast(acting.apparent, point), rate = toNorthEast(acting.driftLessRate, point);
    north = linear.next(north, apparent.forward_rad, rate.forward_rad);
    east = linear.next(east, apparent.starboard_rad, rate.starboard_rad);
    return tilt;
}

VerticalRun::VerticalRun(const Scenario& scenario, const VerticalGyro& gyro) : m_state(std::make_unique<State>(scenario, gyro)) {}
VerticalRun::~VerticalRun() = default;

void VerticalRun::take(std::span<const MotionPoint> points, std::vector<AxisTilt>& tilt)
{
    tilt.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        tilt[i] = m_state->next(points[i]);
}

std::vector<Message> VerticalRun::warnings() const
{
    std::vector<Message> warnings;
    if (auto unstable = whyUnstable(m_state->gyro); !unstable.empty())
        warnings.push_back(std::move(unstable));
    if (m_state->stopAt_s)
        warnings.push_back({MARKED("core", "the vertical gyro tumbles: it is at its stop, 90° from the vertical, from %1 s"),
            figureText(*m_state->stopAt_s, 1)});
    if (const double largest = std::sqrt(m_state->largestSquare); largest > 0.3 && !m_state->gyro.exactTilt)
        warnings.push_back(
            {MARKED("core",
                 "the apparent vertical leans by up to %1°, and the book's a/g takes it for %2°; exact_tilt takes the angle itself"),
                figureText(toDegrees(std::atan(largest)), 1), figureText(toDegrees(largest), 1)});
    return warnings;
}

AxisTilt standoffOf(const Scenario& scenario, const VerticalGyro& gyro)
{
    Scenario steady = scenario;
    steady.manoeuvres.clear();
    steady.gusts.reset();
    steady.duration_s = 0;
    const Acting acting = ActingForces(steady, gyro).at(motionOf(steady).points.front());
    return {standoff_rad(gyro, acting.driftLessRate.forward_rad), standoff_rad(gyro, acting.driftLessRate.starboard_rad)};
}

} // namespace lubberline
