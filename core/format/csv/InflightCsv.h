#pragma once
/// Logs of deviation in flight.
/// Legs CSV: `track_deg, ground_speed_kt` (or _m_s, _km_h), optional `leg, compass_heading_deg, variation_deg`; rows that share a leg are averaged.
/// Continuous CSV: `time_s, compass_heading_deg` and `reference_heading_deg` (magnetic) or `deviation_deg`; optional `reference_error_deg, leg,
/// current_A:NAME` for each electrical load; for the whole sensor model `pitch_deg, roll_deg, horizontal_nT, dip_deg`. Times do not go back.

#include <istream>
#include <string>
#include <vector>

#include "core/base/Progress.h"
#include "core/inflight/ContinuousSwing.h"
#include "core/inflight/Legs.h"

namespace lubberline {

struct LegsFile {
    std::vector<Leg> legs;
    std::vector<Message> warnings;
};
/// Errors: Io, Format, InvalidInput (a column that is missing, a cell), Cancelled.
Result<LegsFile> readLegsCsv(std::istream& input, const std::string& name, const Progress& progress = {});
Result<LegsFile> readLegsCsvFile(const std::string& path, const Progress& progress = {});

struct ContinuousFile {
    ContinuousResult result;
    std::vector<Message> warnings;
};
/// Streams a log into a continuous swing. @param options its loads are those of the log; its start has to have the same. Errors: as above.
Result<ContinuousFile> readContinuousCsv(
    std::istream& input, const std::string& name, ContinuousOptions options, const Progress& progress = {});
Result<ContinuousFile> readContinuousCsvFile(const std::string& path, ContinuousOptions options, const Progress& progress = {});

} // namespace lubberline
