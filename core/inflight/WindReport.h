#pragma once
/// Wind reports of aircraft beside a reference wind (a model's), as they come: knots, degrees, where a wind blows *from*. What is missing
/// is NaN.

#include <cmath>
#include <limits>
#include <string_view>

namespace lubberline {

inline constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

struct WindReport {
    double groundSpeed_kt = kMissing, track_deg = kMissing; ///< true track
    double tas_kt = kMissing;
    double wind_kt = kMissing, windFrom_deg = kMissing;           ///< as the aircraft reported it
    double reference_kt = kMissing, referenceFrom_deg = kMissing; ///< by another source
    double heading_deg = kMissing;                                ///< true, where the file has it
    double roll_deg = kMissing;
    double latitude_deg = kMissing, longitude_deg = kMissing, altitude_m = kMissing;
    double positionStep_deg = 0;                      ///< in which latitude and longitude are written
    double time_s = kMissing;                         ///< since 1970-01-01 UTC
    std::string_view aircraft, flight, source, group; ///< only valid while the report is taken
};

} // namespace lubberline
