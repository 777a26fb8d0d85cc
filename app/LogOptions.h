#pragma once
/// What commands that read a sensor log share.

#include <limits>
#include <optional>

#include "app/commands/Command.h"
#include "core/earth/EarthField.h"
#include "core/format/csv/SensorLogCsv.h"

namespace lubberline::app {

struct LogArguments {
    std::string file;
    SensorLogOptions reading;
    double from = std::numeric_limits<double>::lowest(), to = std::numeric_limits<double>::max();
};
void addLogOptions(CLI::App& command, Invocation& invocation, LogArguments& options);
Result<SensorLog> readLog(const LogArguments& options);

/// The Earth's field where the log was taken: stated, or of a place and date.
struct KnownFieldArguments {
    std::optional<double> field_nT, dip_deg, latitude_deg, longitude_deg;
    double altitude_m = 0;
    std::string date;
};
struct KnownField {
    std::optional<double> total_nT;
    std::optional<MeridianField> meridian; ///< where the dip is known, too
    std::optional<Variation> variation;    ///< of a place
};
void addKnownFieldOptions(CLI::App& command, KnownFieldArguments& options);
Result<KnownField> knownField(const KnownFieldArguments& options);

} // namespace lubberline::app
