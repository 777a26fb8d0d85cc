#include "core/calibration/LineOfSight.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/angle/Angle.h"
#include "core/base/Number.h"
#include "core/calibration/ModelHeader.h"

namespace lubberline {

namespace {

constexpr double kSteep_deg = 80; ///< beyond, an azimuth means little

/// What one sensor hands on.
struct SightReading {
    Eigen::Vector3d field_nT;
    double pitch_deg = 0, roll_deg = 0;
    [[nodiscard]] Eigen::Matrix3d fromEarth() const
    {
        return rotation(toRadians(roll_deg), toRadians(pitch_deg), toRadians(headingOf_deg(field_nT, pitch_deg, roll_deg)));
    }
};

struct SightReadings {
    SightReading aircraft, helmet;
    Misalignment turret;
};

SightAngles anglesOf(const Eigen::Vector3d& line)
{
    return {toDegrees(std::atan2(line.y(), line.x())), -toDegrees(std::asin(std::clamp(line.z(), -1.0, 1.0)))};
}

SightError lineOf(const SightReadings& readings)
{
    const Eigen::Vector3d line = readings.aircraft.fromEarth() * readings.helmet.fromEarth().row(0).transpose();
    return {anglesOf(line), anglesOf(rotation(readings.turret.roll_rad, readings.turret.pitch_rad, readings.turret.yaw_rad) * line)};
}

SightAngles difference(const SightAngles& a, const SightAngles& b)
{
    return {wrap180(a.azimuth_deg - b.azimuth_deg), a.elevation_deg - b.elevation_deg};
}

SightError difference(const SightError& a, const SightError& b)
{
    return {difference(a.aircraft, b.aircraft), difference(a.turret, b.turret)};
}

/// Each figure of both by one function.
SightError each(const SightError& a, const SightError& b, double (*of)(double, double))
{
    return {{of(a.aircraft.azimuth_deg, b.aircraft.azimuth_deg), of(a.aircraft.elevation_deg, b.aircraft.elevation_deg)},
        {of(a.turret.azimuth_deg, b.turret.azimuth_deg), of(a.turret.elevation_deg, b.turret.elevation_deg)}};
}

double rootOfSquares(double a, double b) { return std::hypot(a, b); }

Attitude attitudeOf(const Eigen::Matrix3d& fromEarth)
{
    return {MagneticHeading::fromRadians(std::atan2(fromEarth(0, 1), fromEarth(0, 0))), std::asin(std::clamp(-fromEarth(0, 2), -1.0, 1.0)),
        std::atan2(fromEarth(1, 2), fromEarth(2, 2))};
}

SightReading readingOf(const MeridianField& field, const Attitude& attitude)
{
    return {fieldInBody(field, attitude), toDegrees(attitude.pitch_rad), toDegrees(attitude.roll_rad)};
}

/// The change of the line by one standard deviation of something, both ways halved.
SightError slopeOf(const SightReadings& truth, const std::function<void(SightReadings&, double)>& disturb)
{
    SightReadings up = truth, down = truth;
    disturb(up, 1.0);
    disturb(down, -1.0);
    return each(difference(lineOf(up), lineOf(down)), {}, [](double a, double) { return std::abs(a) / 2; });
}

void addChances(SightBudget& budget, const SightCase& given, const SightReadings& truth)
{
    const auto add = [&budget](Pattern name, const std::vector<SightError>& parts) {
        SightCause cause{{name}, true, {}};
        for (const SightError& part : parts)
            cause.error = each(cause.error, part, rootOfSquares);
        budget.byChance = each(budget.byChance, cause.error, rootOfSquares);
        budget.causes.push_back(std::move(cause));
    };
    const auto noise = [&truth](SightReading SightReadings::*sensor, double noise_nT) {
        std::vector<SightError> parts;
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            parts.push_back(
                slopeOf(truth, [&](SightReadings& readings, double way) { (readings.*sensor).field_nT[axis] += way * noise_nT; }));
        return parts;
    };
    const auto tilt = [&truth](SightReading SightReadings::*sensor, double SightReading::*angle, double error_deg) {
        return std::vector{slopeOf(truth, [&](SightReadings& readings, double way) { readings.*sensor.*angle += way * error_deg; })};
    };
    const auto mount = [&truth, &given](double Misalignment::*angle) {
        return std::vector{
            slopeOf(truth, [&](SightReadings& readings, double way) { readings.turret.*angle += way * toRadians(given.turretError_deg); })};
    };
    add(MARKED("core", "noise of the aircraft's sensor"), noise(&SightReadings::aircraft, given.aircraft.noise_nT));
    add(MARKED("core", "pitch of the aircraft"), tilt(&SightReadings::aircraft, &SightReading::pitch_deg, given.aircraft.tiltError_deg));
    add(MARKED("core", "roll of the aircraft"), tilt(&SightReadings::aircraft, &SightReading::roll_deg, given.aircraft.tiltError_deg));
    add(MARKED("core", "noise of the helmet's sensor"), noise(&SightReadings::helmet, given.helmet.noise_nT));
    add(MARKED("core", "pitch of the helmet"), tilt(&SightReadings::helmet, &SightReading::pitch_deg, given.helmet.tiltError_deg));
    add(MARKED("core", "roll of the helmet"), tilt(&SightReadings::helmet, &SightReading::roll_deg, given.helmet.tiltError_deg));
    add(MARKED("core", "roll of the turret's mount"), mount(&Misalignment::roll_rad));
    add(MARKED("core", "pitch of the turret's mount"), mount(&Misalignment::pitch_rad));
    add(MARKED("core", "yaw of the turret's mount"), mount(&Misalignment::yaw_rad));
}

Eigen::Vector3d seenBy(const SensorModel& iron, const Eigen::Vector3d& field_nT)
{
    const SensorResponse response = responseOf(iron);
    return response.gain * field_nT + response.offset_nT;
}

/// Alone each, and all together: they do not simply add up where they are large.
void addWhatStays(SightBudget& budget, const SightCase& given, const SightReadings& truth, const Eigen::Vector3d& cockpitAtHelmet_nT)
{
    SightReadings all = truth;
    const auto add = [&](Pattern name, SightReading SightReadings::*sensor, const Eigen::Vector3d& alone_nT) {
        SightReadings one = truth;
        (one.*sensor).field_nT = alone_nT;
        budget.causes.push_back({{name}, false, difference(lineOf(one), budget.truth)});
    };
    all.aircraft.field_nT = seenBy(given.aircraft.iron, truth.aircraft.field_nT);
    all.helmet.field_nT = seenBy(given.helmet.iron, truth.helmet.field_nT + cockpitAtHelmet_nT);
    add(MARKED("core", "iron at the aircraft's sensor"), &SightReadings::aircraft, all.aircraft.field_nT);
    add(MARKED("core", "iron at the helmet's sensor"), &SightReadings::helmet, seenBy(given.helmet.iron, truth.helmet.field_nT));
    add(MARKED("core", "field of the cockpit"), &SightReadings::helmet, truth.helmet.field_nT + cockpitAtHelmet_nT);
    budget.stays = difference(lineOf(all), budget.truth);
}

} // namespace

SightBudget sightBudget(const SightCase& given, const SightAngles& look, double helmetRoll_deg)
{
    SightBudget budget;
    budget.look = look;
    const auto& body = given.aircraftAttitude;
    const Eigen::Matrix3d aircraft = rotation(body.roll_rad, body.pitch_rad, body.heading.radians());
    const Eigen::Matrix3d inAircraft = rotation(toRadians(helmetRoll_deg), toRadians(look.elevation_deg), toRadians(look.azimuth_deg));
    budget.helmet = attitudeOf(inAircraft * aircraft);
    const SightReadings truth{readingOf(given.field, body), readingOf(given.field, budget.helmet), given.turret};
    budget.truth = lineOf(truth);
    addWhatStays(budget, given, truth, inAircraft * given.cockpit_nT);
    addChances(budget, given, truth);
    budget.whole = each(budget.stays, budget.byChance, rootOfSquares);
    if (std::abs(look.elevation_deg) > kSteep_deg || std::abs(budget.truth.turret.elevation_deg) > kSteep_deg)
        budget.warnings.push_back(
            {MARKED("core", "the line of sight is steeper than %1°: there an azimuth turns quickly, and its error is large by itself"),
                figureText(kSteep_deg, 0)});
    if (std::abs(toDegrees(budget.helmet.pitch_rad)) > kSteep_deg)
        budget.warnings.push_back(
            {MARKED("core", "the helmet looks almost straight up or down over the Earth: its heading and its roll are one thing there")});
    budget.warnings.push_back({MARKED("core",
        "a field that coils in the cockpit make to track the helmet is not modelled: headings are by the Earth's field, a constant field of "
        "the cockpit is an error of it")});
    return budget;
}

std::vector<SightBudget> sightSweep(const SightCase& given)
{
    std::vector<SightBudget> sweep;
    for (const double elevation : {-30.0, 0.0, 30.0})
        for (int azimuth = -120; azimuth <= 120; azimuth += 15)
            sweep.push_back(sightBudget(given, {static_cast<double>(azimuth), elevation}));
    return sweep;
}

} // namespace lubberline
