#include "app/SwingSource.h"

#include "app/Console.h"
#include "app/Paths.h"
#include "core/base/WholeFile.h"
#include "core/format/csv/SwingCsv.h"
#include "core/record/ClockDates.h"
#include "core/swing/SwingResult.h"

namespace lubberline::app {

Result<SourcedSwing> swingFromCsv(const std::string& path)
{
    auto file = readSwingCsvFile(path, consoleProgress("reading " + nameOfInput(path)));
    if (!file)
        return file.error();
    SourcedSwing sourced;
    sourced.source = nameOfInput(path);
    sourced.warnings = file->warnings;
    sourced.record = recordOf(std::move(file.value())); // a million readings are not kept twice
    if (const auto doubt = doubtOfDate(sourced.record.swing.date, today()); !doubt.empty())
        sourced.warnings.push_back(doubt);
    if (sourced.record.site)
        sourced.record.site->variation_deg = sourced.record.swing.variation_deg;
    return sourced;
}

Result<Analysis> analyseSwing(const SourcedSwing& swing, const AnalysisOptions& options, const std::optional<SensorBench>& bench)
{
    auto analysis = resultOf(swing.record, nullptr, options, bench);
    if (analysis)
        return analysis;
    Error error = analysis.error();
    error.file = swing.source;
    return error;
}

} // namespace lubberline::app
