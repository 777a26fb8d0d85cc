#include "core/reference/Motion.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "core/angle/Angle.h"
#include "core/base/Number.h"

namespace lubberline {

namespace {

/// The mean of each step of what is `value` between two times, added.
void addBetween(std::vector<MotionPoint>& points, double step_s, double from_s, double to_s, double MotionPoint::*figure, double value)
{
    if (value == 0)
        return;
    const auto last = static_cast<double>(points.size());
    const auto begin = static_cast<std::size_t>(std::clamp(std::floor(from_s / step_s), 0.0, last));
    const auto end = static_cast<std::size_t>(std::clamp(std::ceil(to_s / step_s), 0.0, last));
    for (std::size_t i = begin; i < end; ++i) {
        const double at_s = static_cast<double>(i) * step_s;
        // Rounding of the times must leave no step a sliver of the neighbouring manoeuvre.
        const double part = std::round((std::min(to_s, at_s + step_s) - std::max(from_s, at_s)) / step_s * 1e9) / 1e9;
        if (part > 0)
            points[i].*figure += part * value;
    }
}

void takeManoeuvres(const Scenario& scenario, std::vector<MotionPoint>& points)
{
    const double step = scenario.step_s;
    for (const Manoeuvre& manoeuvre : scenario.manoeuvres) {
        const double from = manoeuvre.from_s, to = manoeuvre.to_s;
        addBetween(points, step, from, to, &MotionPoint::turnRate_rad_s, toRadians(manoeuvre.turnRate_deg_s));
        addBetween(points, step, from, to, &MotionPoint::forward_m_s2, manoeuvre.acceleration_m_s2);
        addBetween(points, step, from, to, &MotionPoint::climb_m_s, manoeuvre.climb_m_s);
        const double entry = std::min(kClimbEntry_s, (to - from) / 2);
        addBetween(points, step, from, from + entry, &MotionPoint::up_m_s2, manoeuvre.climb_m_s / entry);
        addBetween(points, step, to - entry, to, &MotionPoint::up_m_s2, -manoeuvre.climb_m_s / entry);
    }
}

/// About normal: the sum of twelve uniform numbers, the same on every machine.
class GustNoise {
public:
    explicit GustNoise(std::uint32_t seed) : m_engine(seed) {}
    double operator()()
    {
        double sum = -6;
        for (int i = 0; i < 12; ++i)
            sum += static_cast<double>(m_engine()) * 0x1p-32;
        return sum;
    }

private:
    std::mt19937 m_engine;
};

/// A resonance driven by noise, with this standard deviation from the first step on.
class GustAxis {
public:
    GustAxis(const Gusts& gusts, double step_s, GustNoise& noise) : m_noise(noise)
    {
        constexpr double kDamping = 0.3; // an aircraft's own
        const double natural = 2 * kPi / gusts.period_s / std::sqrt(1 - kDamping * kDamping);
        const double radius = std::exp(-kDamping * natural * step_s);
        m_first = 2 * radius * std::cos(2 * kPi * step_s / gusts.period_s);
        m_second = -radius * radius;
        // Of x = a x₋₁ + b x₋₂ + noise: correlation of neighbours a/(1 − b); variance of the noise by Yule and Walker.
        const double neighbours = m_first / (1 - m_second);
        m_before = gusts.rms_m_s2 * noise();
        m_now = neighbours * m_before + gusts.rms_m_s2 * std::sqrt(std::max(0.0, 1 - neighbours * neighbours)) * noise();
        const double two = m_first * neighbours + m_second;
        m_noiseSize = gusts.rms_m_s2 * std::sqrt(std::max(0.0, 1 - m_first * neighbours - m_second * two));
    }
    double next()
    {
        const double after = m_first * m_now + m_second * m_before + m_noiseSize * m_noise();
        m_before = m_now;
        m_now = after;
        return m_before;
    }

private:
    GustNoise& m_noise;
    double m_first = 0, m_second = 0, m_noiseSize = 0, m_now = 0, m_before = 0;
};

void takeGusts(const Gusts& gusts, double step_s, std::vector<MotionPoint>& points)
{
    if (gusts.regular) {
        for (std::size_t i = 0; i < points.size(); ++i)
            points[i].gustStarboard_m_s2
                = gusts.rms_m_s2 * std::sqrt(2.0) * std::sin(2 * kPi * (static_cast<double>(i) + 0.5) * step_s / gusts.period_s);
        return;
    }
    GustNoise noise(gusts.seed);
    GustAxis forward(gusts, step_s, noise), starboard(gusts, step_s, noise);
    for (MotionPoint& point : points) {
        point.gustForward_m_s2 = forward.next();
        point.gustStarboard_m_s2 = starboard.next();
    }
}

/// Speed and heading out of their rates. @return whether the aircraft came to a stand and was told to go slower still.
bool fly(const Scenario& scenario, std::vector<MotionPoint>& points)
{
    double heading = toRadians(scenario.heading_deg), speed = scenario.speed_m_s;
    bool stood = false;
    const double latitude = toRadians(scenario.latitude_deg);
    const double vertical = 2 * kEarthRate_rad_s * std::sin(latitude);
    const double meridians = std::abs(scenario.latitude_deg) <= kPoleward_deg ? std::tan(latitude) / kEarthRadius_m : 0;
    for (MotionPoint& point : points) {
        if (speed + point.forward_m_s2 * scenario.step_s < 0) {
            point.forward_m_s2 = -speed / scenario.step_s;
            stood = true;
        }
        point.heading_rad = heading;
        point.sinHeading = std::sin(heading);
        point.cosHeading = std::cos(heading);
        point.speed_m_s = speed;
        // f = v̇ + (2Ω sin Φ + v_E tan Φ/R) × v: north gains with v_E, east loses with v_N; along the heading nothing, to port the whole.
        const double rate = vertical + speed * point.sinHeading * meridians;
        point.earthStarboard_m_s2 = -rate * speed;
        const double after = speed + point.forward_m_s2 * scenario.step_s;
        point.starboard_m_s2 = (speed + after) / 2 * point.turnRate_rad_s;
        heading += point.turnRate_rad_s * scenario.step_s;
        speed = after;
    }
    return stood;
}

void doubt(const Scenario& scenario, const std::vector<MotionPoint>& points, std::vector<Message>& warnings)
{
    double fastest = 0, turning = 0, pulled = 0;
    for (const MotionPoint& point : points) {
        fastest = std::max(fastest, point.speed_m_s);
        turning = std::max(turning, std::abs(point.turnRate_rad_s));
        pulled = std::max(pulled, std::hypot(point.forward_m_s2, point.starboard_m_s2, point.up_m_s2));
    }
    if (fastest > 1000)
        warnings.push_back({MARKED("core", "the speed of %1 m/s is beyond an aircraft's"), figureText(fastest, 0)});
    if (toDegrees(turning) > 30)
        warnings.push_back({MARKED("core", "the turn of %1°/s is beyond an aircraft's"), figureText(toDegrees(turning), 0)});
    if (pulled > 9 * kGravity_m_s2)
        warnings.push_back({MARKED("core", "an acceleration of %1 g is beyond an aircraft's"), figureText(pulled / kGravity_m_s2, 1)});
    if (std::abs(scenario.latitude_deg) > kPoleward_deg)
        warnings.push_back(MARKED("core",
            "so near to a pole every track crosses meridians at once: what goes with tan of the latitude is left out; steer by grid"));
}

} // namespace

Motion motionOf(const Scenario& scenario)
{
    Motion motion;
    motion.points.resize(static_cast<std::size_t>(std::floor(scenario.duration_s / scenario.step_s + 1e-9)) + 1);
    takeManoeuvres(scenario, motion.points);
    if (scenario.gusts)
        takeGusts(*scenario.gusts, scenario.step_s, motion.points);
    if (fly(scenario, motion.points))
        motion.warnings.push_back(MARKED("core", "the aircraft is slowed below standing still; it stays at 0 m/s"));
    doubt(scenario, motion.points, motion.warnings);
    return motion;
}

} // namespace lubberline
