#include "core/reference/HeadingChain.h"

#include <algorithm>
#include <cmath>

#include "core/angle/Angle.h"
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

std::vector<TurnedBy> bodyAttitudes(const Motion& motion)
{
    std::vector<TurnedBy> attitudes(motion.points.size());
    for (std::size_t i = 0; i < attitudes.size(); ++i) {
        const MotionPoint& point = motion.points[i];
        TurnedBy& by = attitudes[i];
        const double gravity = point.gravity_m_s2(), bank = 1 / std::hypot(point.starboard_m_s2, gravity);
        by.sinRoll = point.starboard_m_s2 * bank;
        by.cosRoll = gravity * bank;
        if (point.climb_m_s != 0) {
            by.sinPitch = std::clamp(point.climb_m_s / std::max(point.speed_m_s, 1e-9), -1.0, 1.0);
            by.cosPitch = std::sqrt(1 - by.sinPitch * by.sinPitch);
        }
    }
    return attitudes;
}

std::vector<TurnedBy> hangingAttitudes(const Motion& motion)
{
    std::vector<TurnedBy> attitudes(motion.points.size());
    for (std::size_t i = 0; i < attitudes.size(); ++i) {
        const MotionPoint& point = motion.points[i];
        // Its z axis lies along (−forward, −starboard, gravity), and is (sin θ cos φ, −sin φ, cos θ cos φ).
        const double forward = point.sensedForward_m_s2(), starboard = point.sensedStarboard_m_s2(), gravity = point.gravity_m_s2();
        const double fore = std::sqrt(forward * forward + gravity * gravity), whole = std::sqrt(fore * fore + starboard * starboard);
        attitudes[i] = {-forward / fore, gravity / fore, starboard / whole, fore / whole};
    }
    return attitudes;
}

std::vector<TurnedBy> platformAttitudes(const std::vector<AxisTilt>& tilt)
{
    std::vector<TurnedBy> attitudes(tilt.size());
    std::transform(tilt.begin(), tilt.end(), attitudes.begin(), [](const AxisTilt& axis) {
        return TurnedBy{
            -std::sin(axis.forward_rad), std::cos(axis.forward_rad), std::sin(axis.starboard_rad), std::cos(axis.starboard_rad)};
    });
    return attitudes;
}

std::vector<double> sensorErrors(const Scenario& scenario, const Motion& motion, const std::vector<TurnedBy>& body,
    const std::vector<TurnedBy>& sensor, bool deviation, bool& vanished)
{
    std::vector<double> errors(motion.points.size(), 0.0);
    const bool iron = deviation && scenario.compass.model;
    if (!iron && sensor.empty())
        return errors;
    const SensorResponse response = iron ? responseOf(*scenario.compass.model) : SensorResponse{};
    const MeridianField field = meridianOf(scenario);
    const double smallest = 1e-9 * (response.gain.norm() * field.total_nT() + response.offset_nT.norm());
    double last = 0;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const MotionPoint& point = motion.points[i];
        Eigen::Vector3d seen(field.horizontal_nT * point.cosHeading, -field.horizontal_nT * point.sinHeading, field.down_nT);
        if (iron)
            seen = outOf(body[i], response.gain * into(body[i], seen) + response.offset_nT);
        if (!sensor.empty())
            seen = into(sensor[i], seen);
        // Read heading less true heading, by one arctangent.
        const double north = seen.x() * point.cosHeading - seen.y() * point.sinHeading;
        const double east = -seen.y() * point.cosHeading - seen.x() * point.sinHeading;
        if (std::abs(north) + std::abs(east) <= smallest)
            vanished = true;
        else
            last = std::atan2(east, north);
        errors[i] = last;
    }
    return errors;
}

std::vector<double> throughCard(const CardInLiquid& card, double step_s, const Motion& motion, const std::vector<TurnedBy>& body,
    const std::vector<TurnedBy>& sensor, const std::vector<double>& sensor_rad)
{
    std::vector<double> errors(sensor_rad.size());
    const double natural = 2 * kPi / card.period_s, twice = 2 * card.damping * natural;
    const int count = std::clamp(static_cast<int>(std::ceil(step_s * std::max(natural, twice) * 20)), 1, 1000);
    const double dt = step_s / count, keep = card.liquidLag_s > 0 ? std::exp(-dt / card.liquidLag_s) : 0.0;
    const double decay = std::exp(-twice * dt), stop = card.stop_deg ? std::cos(toRadians(*card.stop_deg)) : -2;
    double error = sensor_rad.front(), rate = 0, liquid = motion.points.front().turnRate_rad_s;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        errors[i] = error = wrapped(error);
        const double turn = motion.points[i].turnRate_rad_s;
        bool binds = false;
        if (card.stop_deg && !sensor.empty()) { // between the card's plane and the bowl's
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
                const double settled = -liquid - natural * natural / twice * std::sin(error - sensor_rad[i]);
                rate = twice > 0 ? settled + (rate - settled) * decay : rate - natural * natural * std::sin(error - sensor_rad[i]) * dt;
            }
            error += rate * dt;
        }
    }
    return errors;
}

std::vector<double> driftOf(const Scenario& scenario, const HeadingGyro& gyro, const Motion& motion)
{
    const auto perHour = [](double rate_deg_h) { return toRadians(rate_deg_h) / 3600; };
    std::vector<double> drift(motion.points.size(), perHour(gyro.drift_deg_h));
    const double unbalance = perHour(gyro.accelerationDrift.unbalance_deg_h_g);
    const double anisoelastic = perHour(gyro.accelerationDrift.anisoelastic_deg_h_g2);
    const bool meridians = std::abs(scenario.latitude_deg) <= kPoleward_deg;
    for (std::size_t i = 0; i < drift.size(); ++i) {
        const MotionPoint& point = motion.points[i];
        const double along = point.sensedForward_m_s2() / kGravity_m_s2;
        drift[i] += unbalance * along + anisoelastic * along * point.gravity_m_s2() / kGravity_m_s2;
        if (gyro.apparentDrift)
            drift[i] += meridians ? apparentDrift_rad_s(toRadians(scenario.latitude_deg), point.speed_m_s * point.sinHeading)
                                  : -kEarthRate_rad_s * std::sin(toRadians(scenario.latitude_deg));
    }
    return drift;
}

std::vector<double> gimbalErrors(const HeadingGyro& gyro, const Motion& motion, const std::vector<TurnedBy>& body)
{
    std::vector<double> errors(motion.points.size(), 0.0);
    const double tilt = toRadians(gyro.outerAxisTilt_deg), sinTilt = std::sin(tilt), cosTilt = std::cos(tilt);
    const double sinSpin = std::sin(toRadians(gyro.spinAxis_deg)), cosSpin = std::cos(toRadians(gyro.spinAxis_deg));
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const MotionPoint& point = motion.points[i];
        TurnedBy axis = gyro.levelOuterAxis ? TurnedBy{} : body[i];
        axis = {
            axis.sinPitch, axis.cosPitch, axis.sinRoll * cosTilt + axis.cosRoll * sinTilt, axis.cosRoll * cosTilt - axis.sinRoll * sinTilt};
        if (axis.sinRoll == 0 && axis.sinPitch == 0)
            continue;
        const double sine = point.sinHeading * cosSpin - point.cosHeading * sinSpin,
                     cosine = point.cosHeading * cosSpin + point.sinHeading * sinSpin;
        const double east = axis.cosRoll * sine - axis.sinRoll * axis.sinPitch * cosine, north = axis.cosPitch * cosine;
        errors[i] = std::atan2(east * cosine - north * sine, north * cosine + east * sine);
    }
    return errors;
}

std::vector<double> throughGyro(const HeadingGyro& gyro, bool slaved, double step_s, const Motion& motion,
    const std::vector<double>& drift_rad_s, const std::vector<double>& sensor_rad)
{
    std::vector<double> errors(sensor_rad.size());
    const double tau = gyro.slavingTau_s.value_or(0), follow = tau > 0 ? -std::expm1(-step_s / tau) : 0;
    const auto perStep = [step_s](double rate_deg_min) { return toRadians(rate_deg_min) / 60 * step_s; };
    const double most = gyro.slavingRate_deg_min ? perStep(*gyro.slavingRate_deg_min) : kPi;
    const double fast = perStep(gyro.fastRate_deg_min), fastAbove = toRadians(gyro.fastAbove_deg.value_or(360));
    const double cutout = toRadians(gyro.cutoutTurnRate_deg_s.value_or(1e9));
    double error = wrapped(toRadians(gyro.initialError_deg));
    for (std::size_t i = 0; i < errors.size(); ++i) {
        errors[i] = error;
        const double drift = drift_rad_s.empty() ? 0 : drift_rad_s[i];
        if (!slaved || std::abs(motion.points[i].turnRate_rad_s) > cutout) {
            error = wrapped(error + drift * step_s);
            continue;
        }
        const double behind = wrapped(sensor_rad[i] - error);
        if (tau > 0 && std::abs(behind) <= fastAbove) {
            // Exact over the step, where the rate is not limited.
            const double step = (behind + tau * drift) * follow, slaving = step - drift * step_s;
            error = wrapped(error + (std::abs(slaving) <= most ? step : std::copysign(most, behind) + drift * step_s));
            continue;
        }
        const double reach = std::abs(behind) > fastAbove ? fast : most;
        const double wanted = behind - drift * step_s;
        error = wrapped(error + std::clamp(wanted, -reach, reach) + drift * step_s);
    }
    return errors;
}

} // namespace lubberline
