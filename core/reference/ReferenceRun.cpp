#include "core/reference/ReferenceRun.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "core/angle/Angle.h"
#include "core/angle/QuickAngle.h"
#include "core/reference/DirectionalGyro.h"
#include "core/reference/HeadingChain.h"

namespace lubberline {

namespace {

/// Which causes take part.
struct Causes {
    bool tilt = true, deviation = true, slaving = true, drift = true, gimbal = true, card = true;
};

/// The short way round.
double difference(double all_rad, double without_rad)
{
    const double share = all_rad - without_rad;
    return std::abs(share) <= kPi ? share : std::remainder(share, 2 * kPi);
}

/// One part of the flight, as every run sees it.
struct Part {
    std::vector<MotionPoint> points;
    std::vector<AxisTilt> tilt; ///< of the vertical
    std::vector<TurnedBy> body, sensor;
    std::vector<double> drift, gimbal;

    /// @param levelled by a vertical gyro, whose tilt is there already
    void complete(const Scenario& scenario, bool levelled)
    {
        bodyAttitudes(points, body);
        if (levelled)
            platformAttitudes(tilt, sensor);
        else
            hangingAttitudes(points, sensor);
        if (!scenario.gyro)
            return;
        driftOf(scenario, *scenario.gyro, points, drift);
        gimbalErrors(*scenario.gyro, points, body, gimbal);
    }
};

/// A run with some of the causes, part after part.
class Run {
public:
    Run(const Scenario& scenario, const Causes& causes) : m_causes(causes), m_sensor(scenario, causes.deviation)
    {
        if (scenario.compass.card && causes.card)
            m_card.emplace(*scenario.compass.card, scenario.step_s);
        if (scenario.gyro)
            m_gyro.emplace(*scenario.gyro, causes.slaving && scenario.gyro->slaved(), scenario.step_s);
    }

    /// What the sensor reads where neither tilt nor deviation is left out is known from the whole run.
    const ErrorSeries& take(const Part& part, const ErrorSeries* sensed)
    {
        const std::span<const TurnedBy> attitudes = m_causes.tilt ? std::span<const TurnedBy>(part.sensor) : std::span<const TurnedBy>();
        if (!sensed || !(m_causes.tilt && m_causes.deviation)) {
            m_sensor.take(part.points, part.body, attitudes, m_sensed);
            sensed = &m_sensed;
        }
        if (m_card) {
            m_card->take(part.points, part.body, attitudes, *sensed, m_carried);
            sensed = &m_carried;
        }
        if (!m_gyro)
            return *sensed;
        m_gyro->take(part.points, m_causes.drift ? std::span<const double>(part.drift) : std::span<const double>(), *sensed, m_shown);
        if (m_causes.gimbal)
            for (std::size_t i = 0; i < m_shown.size(); ++i)
                m_shown[i] = difference(m_shown[i] + part.gimbal[i], 0);
        return m_shown;
    }
    [[nodiscard]] const ErrorSeries& sensed() const { return m_sensed; }
    [[nodiscard]] bool vanished() const { return m_sensor.vanished(); }

private:
    Causes m_causes;
    MagneticSensor m_sensor;
    std::optional<LiquidCard> m_card;
    std::optional<ShownByGyro> m_gyro;
    ErrorSeries m_sensed, m_carried, m_shown;
};

struct Without {
    ErrorSource source;
    bool Causes::*cause;
};

std::vector<Without> sourcesOf(const Scenario& scenario)
{
    std::vector<Without> sources{{ErrorSource::Tilt, &Causes::tilt}};
    if (scenario.compass.model)
        sources.push_back({ErrorSource::OwnDeviation, &Causes::deviation});
    if (scenario.gyro) {
        if (scenario.gyro->slaved())
            sources.push_back({ErrorSource::Slaving, &Causes::slaving});
        sources.push_back({ErrorSource::Drift, &Causes::drift});
        sources.push_back({ErrorSource::Gimbal, &Causes::gimbal});
    }
    if (scenario.compass.card)
        sources.push_back({ErrorSource::Card, &Causes::card});
    return sources;
}

void apparentTilt(const std::vector<MotionPoint>& points, std::vector<AxisTilt>& tilt)
{
    tilt.resize(points.size());
    std::transform(points.begin(), points.end(), tilt.begin(), [](const MotionPoint& point) {
        const double gravity = point.gravity_m_s2();
        return AxisTilt{quickArctangent(point.sensedForward_m_s2(), gravity), quickArctangent(point.sensedStarboard_m_s2(), gravity)};
    });
}

/// [0, 2π)
double aroundOnce(double angle_rad)
{
    if (angle_rad >= 0 && angle_rad < 2 * kPi)
        return angle_rad;
    return std::fmod(std::fmod(angle_rad, 2 * kPi) + 2 * kPi, 2 * kPi);
}

} // namespace

Result<ReferenceRun> runScenario(const Scenario& scenario, const Progress& progress)
{
    if (const auto fine = checkScenario(scenario); !fine)
        return fine.error();
    ReferenceRun run;
    MotionParts motion(scenario);
    std::optional<VerticalRun> vertical;
    if (scenario.vertical) {
        vertical.emplace(scenario, *scenario.vertical);
        const AxisTilt standoff = standoffOf(scenario, *scenario.vertical);
        run.standoff_rad = std::hypot(standoff.forward_rad, standoff.starboard_rad);
    }
    const bool levelled = scenario.vertical && scenario.compass.type == CompassType::FluxValve;
    Run whole(scenario, {});
    const std::vector<Without> sources = sourcesOf(scenario);
    std::vector<Run> without;
    const std::size_t size = motion.size();
    for (const Without& source : sources) {
        Causes causes;
        causes.*source.cause = false;
        without.emplace_back(scenario, causes);
        run.shares.push_back({source.source, {}});
    }
    run.shares.push_back({ErrorSource::Together, {}});
    for (ErrorShare& share : run.shares)
        share.error_rad.resize(size);
    run.time_s.resize(size);
    run.heading_rad.resize(size);
    run.tilt.resize(size);
    run.headingError_rad.resize(size);
    Part part;
    constexpr std::size_t kPart = 1024; // points: what one part needs stays in the processor's cache
    for (std::size_t from = 0; from < size; from += part.points.size()) {
        if (progress && !progress(static_cast<double>(from) / static_cast<double>(size)))
            return Error{ErrorCode::Cancelled, MARKED("core", "cancelled")};
        motion.next(part.points, kPart);
        if (vertical)
            vertical->take(part.points, part.tilt);
        else
            apparentTilt(part.points, part.tilt);
        part.complete(scenario, levelled);
        if (from == 0 && scenario.gyro && scenario.gyro->slavingTau_s)
            run.slavingStandoff_rad = slavingStandoff_rad(*scenario.gyro->slavingTau_s, part.drift.front());
        const ErrorSeries& all = whole.take(part, nullptr);
        double* const together = run.shares.back().error_rad.data() + from;
        std::copy(all.begin(), all.end(), together);
        std::copy(all.begin(), all.end(), run.headingError_rad.begin() + static_cast<std::ptrdiff_t>(from));
        std::copy(part.tilt.begin(), part.tilt.end(), run.tilt.begin() + static_cast<std::ptrdiff_t>(from));
        for (std::size_t source = 0; source < sources.size(); ++source) {
            const ErrorSeries& errors = without[source].take(part, &whole.sensed());
            double* const share = run.shares[source].error_rad.data() + from;
            for (std::size_t i = 0; i < errors.size(); ++i) {
                share[i] = difference(all[i], errors[i]);
                together[i] -= share[i];
            }
        }
        for (std::size_t i = 0; i < part.points.size(); ++i) {
            run.time_s[from + i] = static_cast<double>(from + i) * scenario.step_s;
            run.heading_rad[from + i] = aroundOnce(part.points[i].heading_rad);
        }
    }
    run.warnings = motion.warnings();
    if (vertical) {
        const auto own = vertical->warnings();
        run.warnings.insert(run.warnings.end(), own.begin(), own.end());
    }
    if (whole.vanished() || std::any_of(without.begin(), without.end(), [](const Run& one) { return one.vanished(); }))
        run.warnings.push_back(MARKED("core", "no horizontal field is left at the sensor at times: what it read before is held there"));
    return run;
}

} // namespace lubberline
