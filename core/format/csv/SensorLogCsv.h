#pragma once
/// Sensor log CSV: `time_s, bx_nT, by_nT, bz_nT` and any of `heading_deg, pitch_deg, roll_deg, current_A:NAME` and others; also `_uT`, `_mG`,
/// `_G`, or no unit (raw counts). Names of loggers are known, too ("Magnetic field x (µT)", mag_x, mx, x, "Time (s)"); a file of three or
/// four numbers a row and no header is x, y, z, or time and these. Comma, semicolon, tab or blanks between cells; `#` lines are comments.
/// Rows are read through one buffer; memory grows with the columns alone. Empty cells and NaN are counted and are NaN; other cells that are
/// no number are counted up to a hundred rows, then the file is refused.

#include <map>

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/calibration/SensorLog.h"

namespace lubberline {

struct SensorLogOptions {
    std::map<std::string, std::string> columns
        = {};                           ///< "bx" → "Feld X": x, y, z, time, heading, pitch, roll; over what would be recognised
    std::optional<FieldUnit> unit = {}; ///< over what the file says
};

/// The names of a file's columns, before it is read: for a choice of who is what.
struct SensorLogHeader {
    std::vector<std::string> columns;              ///< "1", "2", … of a file without a header
    std::map<std::string, std::string> recognised; ///< as SensorLogOptions::columns
};
Result<SensorLogHeader> readSensorLogHeader(std::istream& input, const std::string& name);

/// Errors: Io, Format, InvalidInput (a column that is missing or there twice, mixed units, time that goes back, cells), Cancelled.
Result<SensorLog> readSensorLog(
    std::istream& input, const std::string& name, const SensorLogOptions& options = {}, const Progress& progress = {});
/// "-": standard input. A header is read from a file only.
Result<SensorLog> readSensorLogFile(const std::string& path, const SensorLogOptions& options = {}, const Progress& progress = {});
Result<SensorLogHeader> readSensorLogHeaderFile(const std::string& path);

} // namespace lubberline
