#include "core/reference/HeadingChain.h"

#include <algorithm>
#include <cmath>

#include "core/angle/Angle.h"
#include "core/angle/QuickAngle.h"
#include "core/base/VectorClones.h"
#include "core/reference/DirectionalGyro.h"

namespace lubberline {

namespace {

double wrapped(double angle_rad) { return angle_rad > -kPi && angle_rad <= kPi ? angle_rad : std::remainder(angle_rad, 2 * kPi); }

/// Rx(φ) Ry(θ) of a vector.
Eigen::Vector3d into(const TurnedBy& by, const Eigen::Vector3d& v)
{
    const double x = by.cosPitch * v.x() - by.sinPitch * v.z(), z = by.sinPitch * v.x() + by.cosPitch * v.z();
    return {x, by.cosRoll * v.y() + by.sinRoll * z, -by.sinRoll * v.y() + by.cosRoll * z};
}
/// Back again.
Eigen::Vector3d outOf(const TurnedBy& by, const Eigen::Vector3d& v)
{
    const double y = by.cosRoll * v.y() - by.sinRoll * v.z(), z = by.sinRoll * v.y() + by.cosRoll * v.z();
    return {by.cosPitch * v.x() + by.sinPitch * z, y, -by.sinPitch * v.x() + by.cosPitch * z};
}

MeridianField meridianOf(const Scenario& scenario)
{
    if (std::abs(scenario.dip_deg) >= 90)
        return {0, std::copysign(1.0, scenario.dip_deg)};
    const double horizontal = scenario.compass.model ? scenario.compass.horizontal_nT : 1.0;
    return {horizontal, horizontal * std::tan(toRadians(scenario.dip_deg))};
}

} // namespace

void bodyAttitudes(MotionPart points, std::vector<TurnedBy>& attitudes)
{
    attitudes.resize(points.size());
    for (std::size_t i = 0; i < attitudes.size(); ++i) {
        const MotionPoint& point = points[i];
        TurnedBy& by = attitudes[i];
        const double gravity = point.gravity_m_s2(), bank = 1 / std::sqrt(point.starboard_m_s2 * point.starboard_m_s2 + gravity * gravity);
        by = {0, 1, point.starboard_m_s2 * bank, gravity * bank};
        if (point.climb_m_s != 0) {
            by.sinPitch = std::clamp(point.climb_m_s / std::max(point.speed_m_s, 1e-9), -1.0, 1.0);
            by.cosPitch = std::sqrt(1 - by.sinPitch * by.sinPitch);
        }
    }
}

void hangingAttitudes(MotionPart points, std::vector<TurnedBy>& attitudes)
{
    attitudes.resize(points.size());
    for (std::size_t i = 0; i < attitudes.size(); ++i) {
        const MotionPoint& point = points[i];
        // Its z axis lies along (−forward, −starboard, gravity), and is (sin θ cos φ, −sin φ, cos θ cos φ).
        const double forward = point.sensedForward_m_s2(), starboard = point.sensedStarboard_m_s2(), gravity = point.gravity_m_s2();
        const double fore = std::sqrt(forward * forward + gravity * gravity), whole = std::sqrt(fore * fore + starboard * starboard);
        attitudes[i] = {-forward / fore, gravity / fore, starboard / whole, fore / whole};
    }
}

AircraftField::AircraftField(const Scenario& scenario, bool iron)
    : m_iron(iron && scenario.compass.model)
    , m_response(m_iron ? responseOf(*scenario.compass.model) : SensorResponse{})
    , m_field(meridianOf(scenario))
{
}

double AircraftField::smallest_nT() const { return 1e-9 * (m_response.gain.norm() * m_field.total_nT() + m_response.offset_nT.norm()); }

void AircraftField::take(MotionPart points, const std::vector<TurnedBy>& body, LevelField& field) const
{
    for (auto* const along : {&field.forward, &field.starboard, &field.down})
        along->resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        Eigen::Vector3d seen(m_field.horizontal_nT * points[i].cosHeading, -m_field.horizontal_nT * points[i].sinHeading, m_field.down_nT);
        if (m_iron)
            seen = outOf(body[i], m_response.gain * into(body[i], seen) + m_response.offset_nT);
        field.forward[i] = seen.x();
        field.starboard[i] = seen.y();
        field.down[i] = seen.z();
    }
}

namespace {

/// The field across the sensor, turned back by the true heading: read heading less true heading is one arctangent of it.
LUBBERLINE_VECTOR_CLONES void acrossTilted(
    const MotionPoint* points, const LevelField& field, const TurnedBy* sensor, std::size_t count, double* north, double* east)
{
    const double *forward = field.forward.data(), *starboard = field.starboard.data(), *down = field.down.data();
    for (std::size_t i = 0; i < count; ++i) {
        const double x = sensor[i].cosPitch * forward[i] - sensor[i].sinPitch * down[i];
        const double z = sensor[i].sinPitch * forward[i] + sensor[i].cosPitch * down[i];
        const double y = sensor[i].cosRoll * starboard[i] + sensor[i].sinRoll * z;
        north[i] = x * points[i].cosHeading - y * points[i].sinHeading;
        east[i] = -y * points[i].cosHeading - x * points[i].sinHeading;
    }
}

LUBBERLINE_VECTOR_CLONES void acrossLevel(
    const MotionPoint* points, const LevelField& field, std::size_t count, double* north, double* east)
{
    const double *forward = field.forward.data(), *starboard = field.starboard.data();
    for (std::size_t i = 0; i < count; ++i) {
        north[i] = forward[i] * points[i].cosHeading - starboard[i] * points[i].sinHeading;
        east[i] = -starboard[i] * points[i].cosHeading - forward[i] * points[i].sinHeading;
    }
}

LUBBERLINE_VECTOR_CLONES void arctangents(const double* east, const double* north, std::size_t count, double* angle)
{
    for (std::size_t i = 0; i < count; ++i)
        angle[i] = arctangentAround(east[i], north[i]);
}

LUBBERLINE_VECTOR_CLONES void sinesNearZero(const AxisTilt* tilt, std::size_t count, TurnedBy* attitudes)
{
    for (std::size_t i = 0; i < count; ++i) {
        const SineCosine pitch = sineCosineNearZero(tilt[i].forward_rad), roll = sineCosineNearZero(tilt[i].starboard_rad);
        attitudes[i] = {-pitch.sine, pitch.cosine, roll.sine, roll.cosine};
    }
}

} // namespace

void platformAttitudes(const std::vector<AxisTilt>& tilt, std::vector<TurnedBy>& attitudes)
{
    attitudes.resize(tilt.size());
    sinesNearZero(tilt.data(), tilt.size(), attitudes.data());
    for (std::size_t i = 0; i < tilt.size(); ++i)
        if (!nearZero(tilt[i].forward_rad) || !nearZero(tilt[i].starboard_rad)) {
            const SineCosine pitch = quickSineCosine(tilt[i].forward_rad), roll = quickSineCosine(tilt[i].starboard_rad);
            attitudes[i] = {-pitch.sine, pitch.cosine, roll.sine, roll.cosine};
        }
}

void MagneticSensor::take(MotionPart points, const LevelField& field, std::span<const TurnedBy> sensor, ErrorSeries& errors)
{
    const std::size_t count = points.size();
    m_north.resize(count);
    m_east.resize(count);
    errors.resize(count);
    if (sensor.empty())
        acrossLevel(points.data(), field, count, m_north.data(), m_east.data());
    else
        acrossTilted(points.data(), field, sensor.data(), count, m_north.data(), m_east.data());
    arctangents(m_east.data(), m_north.data(), count, errors.data());
    for (std::size_t i = 0; i < count; ++i) {
        if (std::abs(m_north[i]) + std::abs(m_east[i]) > m_smallest_nT)
            continue;
        m_vanished = true;
        errors[i] = i > 0 ? errors[i - 1] : m_last;
    }
    if (count > 0)
        m_last = errors.back();
}

void LiquidCard::take(MotionPart points, const std::vector<TurnedBy>& body, std::span<const TurnedBy> sensor, const ErrorSeries& sensor_rad,
    ErrorSeries& errors)
{
    errors.resize(points.size());
    const double natural = 2 * kPi / m_card.period_s, twice = 2 * m_card.damping * natural;
    const int count = std::clamp(static_cast<int>(std::ceil(m_step_s * std::max(natural, twice) * 20)), 1, 1000);
    const double dt = m_step_s / count, keep = m_card.liquidLag_s > 0 ? std::exp(-dt / m_card.liquidLag_s) : 0.0;
    const double decay = std::exp(-twice * dt), stop = m_card.stop_deg ? std::cos(toRadians(*m_card.stop_deg)) : -2;
    if (!m_begun && !points.empty()) {
        m_error = sensor_rad.front();
        m_liquid = points.front().turnRate_rad_s;
        m_begun = true;
    }
    double error = m_error, rate = m_rate, liquid = m_liquid;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        errors[i] = error = wrapped(error);
        const double turn = points[i].turnRate_rad_s;
        bool binds = false;
        if (m_card.stop_deg && !sensor.empty()) { // between the card's plane and the bowl's
            const TurnedBy &of = sensor[i], &bowl = body[i];
            const double cosine = of.sinPitch * of.cosRoll * bowl.sinPitch * bowl.cosRoll + of.sinRoll * bowl.sinRoll
                + of.cosPitch * of.cosRoll * bowl.cosPitch * bowl.cosRoll;
            binds = cosine < stop;
        }
        for (int n = 0; n < count; ++n) {
            liquid = turn + (liquid - turn) * keep;
            if (binds) {
                rate = -turn;
            } else {
                const double pull = natural * natural * quickSineCosine(error - sensor_rad[i]).sine;
                rate = twice > 0 ? -liquid - pull / twice + (rate + liquid + pull / twice) * decay : rate - pull * dt;
            }
            error += rate * dt;
        }
    }
    m_error = error;
    m_rate = rate;
    m_liquid = liquid;
}

void driftOf(const Scenario& scenario, const HeadingGyro& gyro, MotionPart points, std::vector<double>& drift)
{
    const auto perHour = [](double rate_deg_h) { return toRadians(rate_deg_h) / 3600; };
    drift.assign(points.size(), perHour(gyro.drift_deg_h));
    const double unbalance = perHour(gyro.accelerationDrift.unbalance_deg_h_g);
    const double anisoelastic = perHour(gyro.accelerationDrift.anisoelastic_deg_h_g2);
    const double latitude = toRadians(scenario.latitude_deg);
    const bool meridians = std::abs(scenario.latitude_deg) <= kPoleward_deg;
    const double still = apparentDrift_rad_s(latitude, 0), perSpeed = meridians ? apparentDrift_rad_s(latitude, 1) - still : 0;
    for (std::size_t i = 0; i < drift.size(); ++i) {
        const MotionPoint& point = points[i];
        const double along = point.sensedForward_m_s2() / kGravity_m_s2;
        drift[i] += unbalance * along + anisoelastic * along * point.gravity_m_s2() / kGravity_m_s2;
        if (gyro.apparentDrift)
            drift[i] += still + perSpeed * point.speed_m_s * point.sinHeading;
    }
}

void gimbalErrors(const HeadingGyro& gyro, MotionPart points, const std::vector<TurnedBy>& body, ErrorSeries& errors)
{
    errors.assign(points.size(), 0.0);
    const double tilt = toRadians(gyro.outerAxisTilt_deg), sinTilt = std::sin(tilt), cosTilt = std::cos(tilt);
    const double sinSpin = std::sin(toRadians(gyro.spinAxis_deg)), cosSpin = std::cos(toRadians(gyro.spinAxis_deg));
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const MotionPoint& point = points[i];
        TurnedBy axis = gyro.levelOuterAxis ? TurnedBy{} : body[i];
        axis = {
            axis.sinPitch, axis.cosPitch, axis.sinRoll * cosTilt + axis.cosRoll * sinTilt, axis.cosRoll * cosTilt - axis.sinRoll * sinTilt};
        if (axis.sinRoll == 0 && axis.sinPitch == 0)
            continue;
        const double sine = point.sinHeading * cosSpin - point.cosHeading * sinSpin,
                     cosine = point.cosHeading * cosSpin + point.sinHeading * sinSpin;
        const double east = axis.cosRoll * sine - axis.sinRoll * axis.sinPitch * cosine, north = axis.cosPitch * cosine;
        errors[i] = quickArctangent(east * cosine - north * sine, north * cosine + east * sine);
    }
}

ShownByGyro::ShownByGyro(const HeadingGyro& gyro, bool slaved, double step_s)
    : m_slaved(slaved)
    , m_step_s(step_s)
    , m_tau_s(gyro.slavingTau_s.value_or(0))
    , m_follow(m_tau_s > 0 ? -std::expm1(-step_s / m_tau_s) : 0)
    , m_fastAbove(toRadians(gyro.fastAbove_deg.value_or(360)))
    , m_cutout(toRadians(gyro.cutoutTurnRate_deg_s.value_or(1e9)))
    , m_error(wrapped(toRadians(gyro.initialError_deg)))
{
    const auto perStep = [step_s](double rate_deg_min) { return toRadians(rate_deg_min) / 60 * step_s; };
    m_most = gyro.slavingRate_deg_min ? perStep(*gyro.slavingRate_deg_min) : kPi;
    m_fast = perStep(gyro.fastRate_deg_min);
}

double ShownByGyro::next(double turnRate_rad_s, double drift_rad_s, double sensor_rad)
{
    const double shown = m_error, drift = drift_rad_s * m_step_s;
    if (!m_slaved || std::abs(turnRate_rad_s) > m_cutout) {
        m_error = wrapped(shown + drift);
        return shown;
    }
    const double behind = wrapped(sensor_rad - shown);
    if (m_tau_s > 0 && std::abs(behind) <= m_fastAbove) {
        // Exact over the step, where the rate is not limited.
        const double step = (behind + m_tau_s * drift_rad_s) * m_follow, slaving = step - drift;
        m_error = wrapped(shown + (std::abs(slaving) <= m_most ? step : std::copysign(m_most, behind) + drift));
        return shown;
    }
    const double reach = std::abs(behind) > m_fastAbove ? m_fast : m_most;
    m_error = wrapped(shown + std::clamp(behind - drift, -reach, reach) + drift);
    return shown;
}

} // namespace lubberline
