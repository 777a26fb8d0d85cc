#include "core/reference/Sun.h"

#include <cmath>

#include "core/angle/Angle.h"
#include "core/base/Number.h"
#include "core/reference/Scenario.h"

namespace lubberline {

namespace {

double sine(double angle_deg) { return std::sin(toRadians(std::fmod(angle_deg, 360.0))); }
double cosine(double angle_deg) { return std::cos(toRadians(std::fmod(angle_deg, 360.0))); }

/// TT − UT [s] by Espenak and Meeus; outside 1950 … 2050 their nearest polynomial goes on, which the sun does not notice.
double deltaT_s(double year)
{
    if (year < 1961) {
        const double t = year - 1950;
        return 29.07 + t * (0.407 + t * (-1 / 233.0 + t / 2547));
    }
    if (year < 1986) {
        const double t = year - 1975;
        return 45.45 + t * (1.067 + t * (-1 / 260.0 - t / 718));
    }
    const double t = year - 2000;
    if (year < 2005)
        return 63.86 + t * (0.3345 + t * (-0.060374 + t * (0.0017275 + t * (0.000651814 + t * 0.00002373599))));
    return 62.92 + t * (0.32217 + t * 0.005589);
}

struct Equatorial {
    double rightAscension_deg = 0, declination_deg = 0;
    double equationOfEquinoxes_deg = 0;
};

Equatorial apparentSun(double days)
{
    // Centuries of dynamical time since 1900 January 0.5.
    const double T = (days + 36525.0 + deltaT_s(2000 + days / 365.25) / 86400) / 36525;
    const double longitude = 279.69668 + T * (36000.76892 + T * 0.0003025);
    const double anomaly = 358.47583 + T * (35999.04975 + T * (-0.000150 - T * 0.0000033));
    const double centre = (1.919460 + T * (-0.004789 - T * 0.000014)) * sine(anomaly) + (0.020094 - 0.000100 * T) * sine(2 * anomaly)
        + 0.000293 * sine(3 * anomaly);
    // Venus (twice), Jupiter, the Moon, a long inequality.
    const double pulled = 0.00134 * cosine(153.23 + 22518.7541 * T) + 0.00154 * cosine(216.57 + 45037.5082 * T)
        + 0.00200 * cosine(312.69 + 32964.3577 * T) + 0.00179 * sine(350.74 + T * (445267.1142 - 0.00144 * T))
        + 0.00178 * sine(231.19 + 20.20 * T);
    const double node = 259.18 - 1934.142 * T;
    const double apparent = longitude + centre + pulled - 0.00569 - 0.00479 * sine(node);
    const double obliquity = 23.452294 + T * (-0.0130125 + T * (-0.00000164 + T * 0.000000503)) + 0.00256 * cosine(node);
    Equatorial sun;
    sun.rightAscension_deg = toDegrees(std::atan2(cosine(obliquity) * sine(apparent), cosine(apparent)));
    sun.declination_deg = toDegrees(std::asin(sine(obliquity) * sine(apparent)));
    sun.equationOfEquinoxes_deg = (-0.00479 * sine(node) - 0.00037 * sine(2 * longitude)) * cosine(obliquity);
    return sun;
}

struct Horizontal {
    double azimuth_deg = 0, elevation_deg = 0, declination_deg = 0, hourAngle_deg = 0;
};

Horizontal seenFrom(const Place& place, double days)
{
    const Equatorial sun = apparentSun(days);
    const double centuries = days / 36525;
    const double sidereal
        = 280.46061837 + std::fmod(360.98564736629 * days, 360.0) + 0.000387933 * centuries * centuries + sun.equationOfEquinoxes_deg;
    const double hour = sidereal + place.longitude_deg - sun.rightAscension_deg;
    const double east = -cosine(sun.declination_deg) * sine(hour);
    const double north
        = sine(sun.declination_deg) * cosine(place.latitude_deg) - cosine(sun.declination_deg) * sine(place.latitude_deg) * cosine(hour);
    const double up
        = sine(sun.declination_deg) * sine(place.latitude_deg) + cosine(sun.declination_deg) * cosine(place.latitude_deg) * cosine(hour);
    return {wrap360(toDegrees(std::atan2(east, north))), toDegrees(std::atan2(up, std::hypot(east, north))), sun.declination_deg,
        wrap360(hour)};
}

} // namespace

SunPosition sunAt(const Place& place, UtcTime time)
{
    const double days = daysSince2000(time), half_min = 0.5 / 1440;
    const Horizontal sun = seenFrom(place, days);
    SunPosition position{sun.azimuth_deg, sun.elevation_deg, sun.declination_deg, sun.hourAngle_deg, 0, 0};
    position.azimuthRate_deg_min = wrap180(seenFrom(place, days + half_min).azimuth_deg - seenFrom(place, days - half_min).azimuth_deg);
    if (sun.elevation_deg > 0)
        position.shadowRatio = 1 / std::tan(toRadians(sun.elevation_deg));
    return position;
}

double ErrorBudget::total_deg() const
{
    double squares = 0;
    for (const ErrorPart& part : parts)
        squares += part.size_deg * part.size_deg;
    return std::sqrt(squares);
}

SunShares sunShares(const Place& place, UtcTime time, const SunSighting& sighting)
{
    const SunPosition sun = sunAt(place, time);
    const double moved_deg = toDegrees(sighting.position_km * 1000 / kMeanEarthRadius_m);
    Place north = place, east = place;
    // Away from the pole, not beyond it.
    north.latitude_deg += place.latitude_deg > 0 ? -moved_deg : moved_deg;
    // Beside a pole a kilometre is any meridian: an even chance of each has this standard deviation.
    constexpr double kAnyMeridian_deg = 103.923; // 360°/√12
    east.longitude_deg += std::min(moved_deg / std::max(cosine(place.latitude_deg), 1e-12), kAnyMeridian_deg);
    const double position
        = std::hypot(wrap180(sunAt(north, time).azimuth_deg - sun.azimuth_deg), wrap180(sunAt(east, time).azimuth_deg - sun.azimuth_deg));
    const double upright = std::min(std::abs(sun.elevation_deg), 89.9);
    return {std::abs(sun.azimuthRate_deg_min) * sighting.clock_s / 60, position,
        std::min(sighting.plumb_deg * std::tan(toRadians(upright)), 180.0)};
}

ErrorBudget sunBudget(const Place& place, UtcTime time, const SunSighting& sighting)
{
    const SunShares shares = sunShares(place, time, sighting);
    return {{{MARKED("core", "clock"), shares.clock_deg}, {MARKED("core", "position"), shares.position_deg},
        {MARKED("core", "plumb"), shares.plumb_deg}, {MARKED("core", "pointing"), sighting.pointing_deg}}};
}

/// Near a pole: the azimuth follows the longitude, and a kilometre is degrees of it.
constexpr double kTellsLittle_deg = 3.0;

SunDoubts doubtsOf(const SunPosition& sun, UtcTime time, const ErrorBudget& budget)
{
    SunDoubts doubts;
    if (sun.elevation_deg < kSunset_deg) {
        doubts.none = true;
        doubts.warnings.push_back(
            {MARKED("core", "the sun is %1° below the horizon: it throws no shadow"), figureText(-sun.elevation_deg, 1)});
    } else if (sun.elevation_deg > kOverhead_deg) {
        doubts.warnings.push_back(
            {MARKED("core", "the sun stands %1° high: its azimuth tells little (±%2°, one standard deviation); wait until it is lower"),
                figureText(sun.elevation_deg, 1), figureText(budget.total_deg(), 1)});
    } else if (budget.total_deg() > kTellsLittle_deg) {
        doubts.warnings.push_back(
            {MARKED("core", "the sun's azimuth tells little here (±%1°, one standard deviation)"), figureText(budget.total_deg(), 1)});
    } else if (sun.elevation_deg < 3) {
        doubts.warnings.push_back({MARKED("core", "the sun stands %1° high: shadows are %2 times as long as the pin, and faint"),
            figureText(sun.elevation_deg, 1), sun.shadowRatio > 0 ? figureText(sun.shadowRatio, 0) : std::string("∞")});
    }
    constexpr std::chrono::sys_days kFirst = std::chrono::year(1950) / 1 / 1, kAfter = std::chrono::year(2051) / 1 / 1;
    if (time < kFirst || time >= kAfter)
        doubts.warnings.push_back(MARKED("core", "the sun's place is held against almanacs from 1950 to 2050 only"));
    return doubts;
}

} // namespace lubberline
