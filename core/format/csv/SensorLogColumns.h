#pragma once
/// Private to the sensor log CSV: who is what in its header, and what its field is counted in.

#include "core/format/csv/SensorLogCsv.h"

namespace lubberline::csv {

enum class LogRole { Time, X, Y, Z, Heading, Pitch, Roll, Current, Other };

struct LogHeader {
    std::vector<std::string> names; ///< all columns
    std::vector<LogRole> roles;     ///< of each
    std::vector<std::string> keys;  ///< of a current: the name of its circuit; else the column's own
    std::optional<FieldUnit> unit;  ///< none: the names say none
    double perSecond = 1;           ///< what the time column is counted in: 1000 for ms
    bool timeUnitNamed = false;     ///< its name says so
    bool ourNames = false;          ///< bx, by, bz: without a unit they are counts by contract
    std::optional<std::size_t> place(LogRole role) const;
};

/// Errors (without file and line): Format, InvalidInput.
Result<LogHeader> logHeaderOf(const std::vector<std::string>& names, const SensorLogOptions& options);
[[nodiscard]] std::string_view keyOf(LogRole role); ///< "time", "bx", …

/// Seconds of a time whose column names no unit, where its figures can be none: phones write nanoseconds; says how that is known.
void takeTime(SensorLog& log, const LogHeader& header);
/// Turns the figures of a log that was read into nT, or leaves counts; says how the unit is known.
void takeUnit(SensorLog& log, const LogHeader& header, const SensorLogOptions& options);

} // namespace lubberline::csv
