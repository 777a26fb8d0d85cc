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

/// Which causes take part. The gimbals are not asked: they only add to what the gyro shows.
struct Causes {
    bool tilt = true, deviation = true, slaving = true, drift = true, card = true;
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
    LevelField withIron, withoutIron;
    std::vector<double> drift, gimbal;

    /// @param levelled by a vertical gyro, whose tilt is there already
    void complete(const Scenario& scenario, bool levelled)
    {
        bodyAttitudes(points, body);
        if (levelled)
            platformAttitudes(tilt, sensor);
        else
            hangingAttitudes(points, sensor);
        gimbal.assign(points.size(), 0.0);
        drift.assign(points.size(), 0.0);
        if (!scenario.gyro)
            return;
        driftOf(scenario, *scenario.gyro, points, drift);
        gimbalErrors(*scenario.gyro, points, body, gimbal);
    }
};

/// A run with some of the causes, part after part.
class Run {
public:
    Run(const Scenario& scenario, const Causes& causes, double smallest_nT) : m_causes(causes), m_sensor(smallest_nT)
    {
        if (scenario.compass.card && causes.card)
            m_card.emplace(*scenario.compass.card, scenario.step_s);
        if (scenario.gyro)
            m_gyro.emplace(*scenario.gyro, causes.slaving && scenario.gyro->slaved(), scenario.step_s);
    }

    /// What the magnetic compass reads. @param whole that of the run with all causes, whose sensor is this one's where neither tilt nor
    /// deviation is left out
    void sense(const Part& part, const Run* whole)
    {
        const std::span<const TurnedBy> attitudes = m_causes.tilt ? std::span<const TurnedBy>(part.sensor) : std::span<const TurnedBy>();
        m_read = whole && m_causes.tilt && m_causes.deviation ? &whole->m_sensed : &m_sensed;
        if (m_read == &m_sensed)
            m_sensor.take(part.points, m_causes.deviation ? part.withIron : part.withoutIron, attitudes, m_sensed);
        if (m_card) {
            m_card->take(part.points, part.body, attitudes, *m_read, m_carried);
            m_read = &m_carried;
        }
    }
    /// What the gyro makes of it, its gimbals apart.
    double show(const Part& part, std::size_t i)
    {
        const double read = (*m_read)[i];
        return m_gyro ? m_gyro->next(part.points[i].turnRate_rad_s, m_causes.drift ? part.drift[i] : 0.0, read) : read;
    }
    [[nodiscard]] bool vanished() const { return m_sensor.vanished(); }

private:
    Causes m_causes;
    MagneticSensor m_sensor;
    std::optional<LiquidCard> m_card;
    std::optional<ShownByGyro> m_gyro;
    ErrorSeries m_sensed, m_carried;
    const ErrorSeries* m_read = nullptr;
};

struct Without {
    ErrorSource source;
    bool Causes::*cause; ///< none: the gimbals
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
        sources.push_back({ErrorSource::Gimbal, nullptr});
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

/// Point after point for all runs at once: each waits for its own point before, and one fills the pauses of the others.
void share(const Part& part, Run& whole, std::vector<Run>& without, const std::vector<Without>& sources, std::vector<ErrorSeries>& shares,
    ErrorSeries& errors)
{
    for (std::size_t i = 0; i < part.points.size(); ++i) {
        const double shown = whole.show(part, i), gimbal = part.gimbal[i];
        const double all = gimbal != 0 ? difference(shown + gimbal, 0) : shown;
        double together = all;
        auto other = without.begin();
        for (std::size_t source = 0; source < sources.size(); ++source) {
            const double its = sources[source].cause ? difference(shown, (other++)->show(part, i)) : gimbal;
            shares[source][i] = its;
            together -= its;
        }
        errors[i] = all;
        shares.back()[i] = together;
    }
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
    const AircraftField iron(scenario, true), noIron(scenario, false);
    Run whole(scenario, {}, iron.smallest_nT());
    std::vector<Run> without; // by source; that of the gimbals needs none
    const std::vector<Without> sources = sourcesOf(scenario);
    const std::size_t size = motion.size();
    for (const Without& source : sources) {
        run.shares.push_back({source.source, {}});
        if (!source.cause)
            continue;
        Causes causes;
        causes.*source.cause = false;
        without.emplace_back(scenario, causes, (causes.deviation ? iron : noIron).smallest_nT());
    }
    run.shares.push_back({ErrorSource::Together, {}});
    for (ErrorShare& share : run.shares)
        share.error_rad.resize(size);
    run.time_s.resize(size);
    run.heading_rad.resize(size);
    run.tilt.resize(size);
    run.headingError_rad.resize(size);
    Part part;
    constexpr std::size_t kPart = 1024;                                     // points: what one part needs stays in the processor's cache
    std::vector<ErrorSeries> shares(run.shares.size(), ErrorSeries(kPart)); // of a part
    ErrorSeries errors(kPart);
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
        iron.take(part.points, part.body, part.withIron);
        if (scenario.compass.model)
            noIron.take(part.points, part.body, part.withoutIron);
        whole.sense(part, nullptr);
        for (Run& one : without)
            one.sense(part, &whole);
        share(part, whole, without, sources, shares, errors);
        const auto count = static_cast<std::ptrdiff_t>(part.points.size()), begin = static_cast<std::ptrdiff_t>(from);
        std::copy_n(part.tilt.begin(), count, run.tilt.begin() + begin);
        std::copy_n(errors.begin(), count, run.headingError_rad.begin() + begin);
        for (std::size_t one = 0; one < shares.size(); ++one)
            std::copy_n(shares[one].begin(), count, run.shares[one].error_rad.begin() + begin);
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
