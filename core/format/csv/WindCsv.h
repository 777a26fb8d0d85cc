#pragma once
/// Wind CSV, a report a row: `ground_speed_kt, track_deg, wind_speed_kt, wind_from_deg, ref_wind_speed_kt, ref_wind_from_deg`, optional
/// `tas_kt, aircraft, flight, group, time_utc, latitude_deg, longitude_deg, altitude_m, roll_deg, heading_deg, source`; without ground_speed
/// and track they follow from positions and times. Speeds may be `_m_s` or
/// `_km_h`, altitudes `_ft`, winds `_toward_deg`; a row without a wind of its own needs heading and tas. Other columns are named in a warning.

#include <istream>
#include <string>
#include <vector>

#include "core/base/Progress.h"
#include "core/inflight/WindStudy.h"

namespace lubberline {

/// What an option says of winds whose column says another thing.
struct WindReading {
    bool toward = false;                        ///< reported winds are where they blow to
    bool referenceToward = false;               ///< and those of the reference
    double windFactor = 1, referenceFactor = 1; ///< to knots from what the column says
};

struct WindFile {
    WindResult result;
    std::vector<Message> warnings;
};

/// Streams the reports into a study. Errors: Io, Format (no header, a row), InvalidInput (a column that is missing, a cell), Cancelled.
Result<WindFile> readWindCsv(std::istream& input, const std::string& name, const WindOptions& options, const WindReading& reading = {},
    const Progress& progress = {});
Result<WindFile> readWindCsvFile(
    const std::string& path, const WindOptions& options, const WindReading& reading = {}, const Progress& progress = {});

/// Seconds since 1970 of "2014-01-05T10:00:00Z" (a space for T, without Z, with parts of a second, without seconds); NaN: it is none.
[[nodiscard]] double secondsOfUtc(std::string_view text);

} // namespace lubberline
