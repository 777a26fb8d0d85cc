#include "core/reference/Motion.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/angle/Angle.h"
#include "core/base/Number.h"

namespace lubberline {

namespace {

/// The mean of each step of what is `value` between two times, added. @param first the place of the first point in the flight
void addBetween(std::vector<MotionPoint>& points, std::size_t first, double step_s, double from_s, double to_s, double MotionPoint::*figure,
    double value)
{
    if (value == 0)
        return;
    const auto least = static_cast<double>(first), last = static_cast<double>(first + points.size());
    const auto begin = static_cast<std::size_t>(std::clamp(std::floor(from_s / step_s), least, last));
    const auto end = static_cast<std::size_t>(std::clamp(std::ceil(to_s / step_s), least, last));
    for (std::size_t i = begin; i < end; ++i) {
        const double at_s = static_cast<double>(i) * step_s;
        // Rounding of the times must leave no step a sliver of the neighbouring manoeuvre.
        const double part = std::round((std::min(to_s, at_s + step_s) - std::max(from_s, at_s)) / step_s * 1e9) / 1e9;
        if (part > 0)
            points[i - first].*figure += part * value;
    }
}

} // namespace

/// About normal: the sum of twelve uniform numbers, the same on every machine [splitmix64, Steele et al. 2014].
class GustNoise {
public:
    explicit GustNoise(std::uint32_t seed) : m_state(seed) {}
    double operator()()
    {
        constexpr std::uint64_t kSecondParts = 0x0000FFFF0000FFFFULL; // of four parts of 16 bits, with room to add them
        std::uint64_t sums = 0;
        for (int draw = 0; draw < 3; ++draw) {
            std::uint64_t bits = m_state += 0x9E3779B97F4A7C15ULL;
            bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9ULL;
            bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBULL;
            bits ^= bits >> 31;
            sums += (bits & kSecondParts) + (bits >> 16 & kSecondParts);
        }
        const std::uint64_t sum = (sums & 0xFFFFFFFF) + (sums >> 32);
        return (static_cast<double>(sum) + 6.0) * 0x1p-16 - 6.0; // each in the middle of its step
    }

private:
    std::uint64_t m_state;
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

struct MotionParts::Random {
    Random(const Gusts& gusts, double step_s) : noise(gusts.seed), forward(gusts, step_s, noise), starboard(gusts, step_s, noise) {}
    GustNoise noise;
    GustAxis forward, starboard;
};

MotionParts::MotionParts(const Scenario& scenario)
    : m_scenario(scenario)
    , m_size(static_cast<std::size_t>(std::floor(scenario.duration_s / scenario.step_s + 1e-9)) + 1)
    , m_heading_rad(toRadians(scenario.heading_deg))
    , m_speed_m_s(scenario.speed_m_s)
{
    if (scenario.gusts && !scenario.gusts->regular)
        m_gusts = std::make_unique<Random>(*scenario.gusts, scenario.step_s);
}

MotionParts::~MotionParts() = default;

void MotionParts::takeManoeuvres(std::vector<MotionPoint>& points) const
{
    const double step = m_scenario.step_s;
    for (const Manoeuvre& manoeuvre : m_scenario.manoeuvres) {
        const double from = manoeuvre.from_s, to = manoeuvre.to_s;
        const auto add = [&](double begin, double end, double MotionPoint::*figure, double value) {
            addBetween(points, m_from, step, begin, end, figure, value);
        };
        add(from, to, &MotionPoint::turnRate_rad_s, toRadians(manoeuvre.turnRate_deg_s));
        add(from, to, &MotionPoint::forward_m_s2, manoeuvre.acceleration_m_s2);
        add(from, to, &MotionPoint::climb_m_s, manoeuvre.climb_m_s);
        const double entry = std::min(kClimbEntry_s, (to - from) / 2);
        add(from, from + entry, &MotionPoint::up_m_s2, manoeuvre.climb_m_s / entry);
        add(to - entry, to, &MotionPoint::up_m_s2, -manoeuvre.climb_m_s / entry);
    }
}

void MotionParts::takeGusts(std::vector<MotionPoint>& points)
{
    if (m_gusts) {
        for (MotionPoint& point : points) {
            point.gustForward_m_s2 = m_gusts->forward.next();
            point.gustStarboard_m_s2 = m_gusts->starboard.next();
        }
        return;
    }
    const Gusts& gusts = *m_scenario.gusts;
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i].gustStarboard_m_s2 = gusts.rms_m_s2 * std::sqrt(2.0)
            * std::sin(2 * kPi * (static_cast<double>(m_from + i) + 0.5) * m_scenario.step_s / gusts.period_s);
}

/// Speed and heading out of their rates.
void MotionParts::fly(std::vector<MotionPoint>& points)
{
    const double latitude = toRadians(m_scenario.latitude_deg), step_s = m_scenario.step_s;
    const double vertical = 2 * kEarthRate_rad_s * std::sin(latitude);
    const double meridians = std::abs(m_scenario.latitude_deg) <= kPoleward_deg ? std::tan(latitude) / kEarthRadius_m : 0;
    // A turn is one rotation after another, exact again with each part of the flight.
    double heading = m_heading_rad, speed = m_speed_m_s, sine = std::sin(heading), cosine = std::cos(heading);
    double turned = 0, sineTurned = 0, cosineTurned = 1;
    for (MotionPoint& point : points) {
        if (speed + point.forward_m_s2 * step_s < 0) {
            point.forward_m_s2 = -speed / step_s;
            m_stood = true;
        }
        point.heading_rad = heading;
        point.sinHeading = sine;
        point.cosHeading = cosine;
        point.speed_m_s = speed;
        // f = v̇ + (2Ω sin Φ + v_E tan Φ/R) × v: north gains with v_E, east loses with v_N; along the heading nothing, to port the whole.
        const double rate = vertical + speed * point.sinHeading * meridians;
        point.earthStarboard_m_s2 = -rate * speed;
        const double after = speed + point.forward_m_s2 * step_s;
        point.starboard_m_s2 = (speed + after) / 2 * point.turnRate_rad_s;
        m_fastest_m_s = std::max(m_fastest_m_s, speed);
        m_turning_rad_s = std::max(m_turning_rad_s, std::abs(point.turnRate_rad_s));
        m_pulled2_m2_s4 = std::max(m_pulled2_m2_s4,
            point.forward_m_s2 * point.forward_m_s2 + point.starboard_m_s2 * point.starboard_m_s2 + point.up_m_s2 * point.up_m_s2);
        speed = after;
        if (point.turnRate_rad_s != 0) {
            const double turn = point.turnRate_rad_s * step_s;
            if (turn != turned) {
                turned = turn;
                sineTurned = std::sin(turn);
                cosineTurned = std::cos(turn);
            }
            heading += turn;
            const double before = sine;
            sine = before * cosineTurned + cosine * sineTurned;
            cosine = cosine * cosineTurned - before * sineTurned;
        }
    }
    m_heading_rad = heading;
    m_speed_m_s = speed;
}

void MotionParts::next(std::vector<MotionPoint>& points, std::size_t most)
{
    points.assign(std::min(most, m_size - m_from), MotionPoint{});
    takeManoeuvres(points);
    if (m_scenario.gusts)
        takeGusts(points);
    fly(points);
    m_from += points.size();
}

std::vector<Message> MotionParts::warnings() const
{
    std::vector<Message> warnings;
    if (m_stood)
        warnings.push_back(MARKED("core", "the aircraft is slowed below standing still; it stays at 0 m/s"));
    if (m_fastest_m_s > 1000)
        warnings.push_back({MARKED("core", "the speed of %1 m/s is beyond an aircraft's"), figureText(m_fastest_m_s, 0)});
    if (toDegrees(m_turning_rad_s) > 30)
        warnings.push_back({MARKED("core", "the turn of %1°/s is beyond an aircraft's"), figureText(toDegrees(m_turning_rad_s), 0)});
    if (const double pulled = std::sqrt(m_pulled2_m2_s4); pulled > 9 * kGravity_m_s2)
        warnings.push_back({MARKED("core", "an acceleration of %1 g is beyond an aircraft's"), figureText(pulled / kGravity_m_s2, 1)});
    if (std::abs(m_scenario.latitude_deg) > kPoleward_deg)
        warnings.push_back(MARKED("core",
            "so near to a pole every track crosses meridians at once: what goes with tan of the latitude is left out; steer by grid"));
    return warnings;
}

Motion motionOf(const Scenario& scenario)
{
    MotionParts parts(scenario);
    Motion motion;
    parts.next(motion.points, parts.size());
    motion.warnings = parts.warnings();
    return motion;
}

} // namespace lubberline
