#pragma once
/// Where a command's swing comes from: a Swing CSV, or a record of the database.

#include <memory>
#include <string>
#include <vector>

#include "core/base/Result.h"
#include "core/record/Fleet.h"
#include "core/swing/SwingResult.h"

namespace lubberline::app {

/// A swing with its particulars and the warnings of reading it.
struct SourcedSwing {
    SwingRecord record;
    std::vector<Message> warnings;
    std::string source; ///< named in errors
};

/// Reads a Swing CSV; particulars that the file does not state stay empty. Errors: those of readSwingCsvFile().
Result<SourcedSwing> swingFromCsv(const std::string& path);

/// resultOf() the readings that count; an error names the source.
Result<Analysis> analyseSwing(const SourcedSwing& swing, const AnalysisOptions& options = {}, const std::optional<SensorBench>& bench = {});
/// The same where nothing more is asked of the readings: they are let go before it begins, as a million of them, with all that can be said
/// of each, take more memory than their analysis.
Result<Analysis> analyseOnly(SourcedSwing& swing, const AnalysisOptions& options, const std::optional<SensorBench>& bench);

} // namespace lubberline::app
