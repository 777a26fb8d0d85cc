#pragma once
/// A swing by the sun: columns time_utc (ISO 8601 with Z or an offset), compass_heading_deg, and shadow_bearing_deg or sun_bearing_deg
/// (from the nose, clockwise). Lines that begin with # are comments.

#include <string>
#include <string_view>
#include <vector>

#include "core/angle/Heading.h"
#include "core/base/Result.h"
#include "core/base/UtcTime.h"

namespace lubberline {

struct SunReading {
    UtcTime time;
    std::string timeText; ///< as it stands in the file
    CompassHeading compass;
    double bearing_deg = 0;
    bool ofShadow = false;
};

/// Errors: Format, InvalidInput, with the line.
Result<std::vector<SunReading>> readSunCsv(std::string_view text, const std::string& name);
/// Errors: also Io.
Result<std::vector<SunReading>> readSunCsvFile(const std::string& path);

} // namespace lubberline
