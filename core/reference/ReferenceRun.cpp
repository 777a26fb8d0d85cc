#include "core/reference/ReferenceRun.h"

#include <algorithm>
#include <cmath>

#include "core/angle/Angle.h"
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

/// What all runs of a scenario share.
class Runs {
public:
    Runs(const Scenario& scenario, const Motion& motion, const std::vector<AxisTilt>& platform)
        : m_scenario(scenario)
        , m_motion(motion)
        , m_body(bodyAttitudes(motion))
        , m_sensor(platform.empty() ? hangingAttitudes(motion) : platformAttitudes(platform))
        , m_all(sensorErrors(scenario, motion, m_body, m_sensor, true, m_vanished))
    {
        if (scenario.gyro) {
            m_drift = driftOf(scenario, *scenario.gyro, motion);
            m_gimbal = gimbalErrors(*scenario.gyro, motion, m_body);
        }
    }

    [[nodiscard]] std::vector<double> errors(const Causes& causes)
    {
        const bool whole = causes.tilt && causes.deviation;
        const std::vector<TurnedBy> level;
        std::vector<double> part;
        if (!whole)
            part = sensorErrors(m_scenario, m_motion, m_body, causes.tilt ? m_sensor : level, causes.deviation, m_vanished);
        const std::vector<double>* error = whole ? &m_all : &part;
        std::vector<double> card;
        if (m_scenario.compass.card && causes.card) {
            card = throughCard(*m_scenario.compass.card, m_scenario.step_s, m_motion, m_body, causes.tilt ? m_sensor : level, *error);
            error = &card;
        }
        if (!m_scenario.gyro)
            return *error;
        const HeadingGyro& gyro = *m_scenario.gyro;
        auto shown = throughGyro(
            gyro, causes.slaving && gyro.slaved(), m_scenario.step_s, m_motion, causes.drift ? m_drift : std::vector<double>(), *error);
        if (causes.gimbal)
            for (std::size_t i = 0; i < shown.size(); ++i)
                shown[i] = difference(shown[i] + m_gimbal[i], 0);
        return shown;
    }

    [[nodiscard]] bool vanished() const { return m_vanished; }
    [[nodiscard]] double firstDrift_rad_s() const { return m_drift.front(); }

private:
    const Scenario& m_scenario;
    const Motion& m_motion;
    bool m_vanished = false;
    std::vector<TurnedBy> m_body, m_sensor;
    std::vector<double> m_all, m_drift, m_gimbal;
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

std::vector<AxisTilt> apparentTilt(const Motion& motion)
{
    std::vector<AxisTilt> tilt;
    tilt.reserve(motion.points.size());
    for (const MotionPoint& point : motion.points)
        tilt.push_back(
            {std::atan2(point.sensedForward_m_s2(), point.gravity_m_s2()), std::atan2(point.sensedStarboard_m_s2(), point.gravity_m_s2())});
    return tilt;
}

} // namespace

Result<ReferenceRun> runScenario(const Scenario& scenario, const Progress& progress)
{
    if (const auto fine = checkScenario(scenario); !fine)
        return fine.error();
    const auto cancelled = [&progress](double fraction) { return progress && !progress(fraction); };
    const Error stopped{ErrorCode::Cancelled, MARKED("core", "cancelled")};
    Motion motion = motionOf(scenario);
    ReferenceRun run;
    run.warnings = std::move(motion.warnings);
    VerticalRun vertical;
    if (scenario.vertical) {
        vertical = verticalRun(scenario, *scenario.vertical, motion);
        run.warnings.insert(run.warnings.end(), vertical.warnings.begin(), vertical.warnings.end());
        const AxisTilt standoff = standoffOf(scenario, *scenario.vertical);
        run.standoff_rad = std::hypot(standoff.forward_rad, standoff.starboard_rad);
    }
    const bool levelled = scenario.vertical && scenario.compass.type == CompassType::FluxValve;
    Runs runs(scenario, motion, levelled ? vertical.tilt : std::vector<AxisTilt>());
    run.headingError_rad = runs.errors({});
    if (cancelled(0.4))
        return stopped;
    std::vector<double> together = run.headingError_rad;
    for (const Without& without : sourcesOf(scenario)) {
        Causes causes;
        causes.*without.cause = false;
        ErrorShare share{without.source, runs.errors(causes)};
        for (std::size_t i = 0; i < together.size(); ++i) {
            share.error_rad[i] = difference(run.headingError_rad[i], share.error_rad[i]);
            together[i] -= share.error_rad[i];
        }
        run.shares.push_back(std::move(share));
        if (cancelled(0.8))
            return stopped;
    }
    run.shares.push_back({ErrorSource::Together, std::move(together)});
    if (scenario.gyro && scenario.gyro->slavingTau_s)
        run.slavingStandoff_rad = slavingStandoff_rad(*scenario.gyro->slavingTau_s, runs.firstDrift_rad_s());
    if (runs.vanished())
        run.warnings.push_back(MARKED("core", "no horizontal field is left at the sensor at times: what it read before is held there"));
    run.tilt = scenario.vertical ? std::move(vertical.tilt) : apparentTilt(motion);
    run.time_s.reserve(motion.points.size());
    run.heading_rad.reserve(motion.points.size());
    for (std::size_t i = 0; i < motion.points.size(); ++i) {
        run.time_s.push_back(static_cast<double>(i) * scenario.step_s);
        run.heading_rad.push_back(std::fmod(std::fmod(motion.points[i].heading_rad, 2 * kPi) + 2 * kPi, 2 * kPi));
    }
    return run;
}

} // namespace lubberline
