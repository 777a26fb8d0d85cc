#pragma once
/// Where the sun stands [Meeus, Astronomical Formulae for Calculators, chapters 7, 8, 18]: within 0.01° from 1950 to 2050.

#include <optional>
#include <vector>

#include "core/base/UtcTime.h"
#include "core/earth/EarthField.h"

namespace lubberline {

struct SunPosition {
    double azimuth_deg = 0;   ///< true, [0, 360)
    double elevation_deg = 0; ///< of its centre, without refraction
    double declination_deg = 0;
    double hourAngle_deg = 0;       ///< local, west of the meridian positive, [0, 360): what an astrocompass is set to
    double azimuthRate_deg_min = 0; ///< what a minute of the clock is worth
    double shadowRatio = 0;         ///< length of a shadow over the height of its pin; 0: there is none
};
[[nodiscard]] SunPosition sunAt(const Place& place, UtcTime time);

/// Below it the sun has set (half its disc and the refraction on the horizon).
inline constexpr double kSunset_deg = -0.833;
/// Above it a pin that is a little out of plumb, or a clock, turns the azimuth by degrees.
inline constexpr double kOverhead_deg = 75;

/// How a bearing of the sun is taken; standard deviations.
struct SunSighting {
    double clock_s = 2;
    double position_km = 1;
    double plumb_deg = 0.25;    ///< of the pin, or of the astrocompass's level
    double pointing_deg = 0.25; ///< of shadow or sight on the circle
};

/// A part of an error, one standard deviation.
struct ErrorPart {
    Message what;
    double size_deg = 0;
};
struct ErrorBudget {
    std::vector<ErrorPart> parts;
    [[nodiscard]] double total_deg() const; ///< root of the sum of squares
};

/// What each part of a sighting is worth in the sun's azimuth [deg].
struct SunShares {
    double clock_deg = 0; ///< × rate
    double position_deg = 0;
    double plumb_deg = 0; ///< × tan of elevation
};
[[nodiscard]] SunShares sunShares(const Place& place, UtcTime time, const SunSighting& sighting);

/// Of the sun's azimuth as it was taken: clock × rate, position, plumb × tan of elevation, pointing.
[[nodiscard]] ErrorBudget sunBudget(const Place& place, UtcTime time, const SunSighting& sighting);

/// Why the sun gives no direction then, or a poor one; empty: it gives a good one.
struct SunDoubts {
    bool none = false; ///< below the horizon
    std::vector<Message> warnings;
};
[[nodiscard]] SunDoubts doubtsOf(const SunPosition& sun, UtcTime time, const ErrorBudget& budget);

} // namespace lubberline
