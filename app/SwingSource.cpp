#include "app/SwingSource.h"

#include <utility>

#include "app/Console.h"
#include "app/Paths.h"
#include "core/base/WholeFile.h"
#include "core/format/csv/SwingCsv.h"
#include "core/record/ClockDates.h"
#include "core/swing/SwingField.h"
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
    const Swing& swing = sourced.record.swing;
    if (variationDoubt_deg(swing, sourced.record.site) > 0.0)
        sourced.warnings.push_back(variationDisagreement(
            sourced.record.site, swing.field ? swing.field : stampFor(swing, sourced.record.site), swing.variation_deg));
    if (sourced.record.site)
        sourced.record.site->variation_deg = sourced.record.swing.variation_deg;
    return sourced;
}

namespace {

Result<Analysis> named(Result<Analysis> analysis, const std::string& source)
{
    if (analysis)
        return analysis;
    Error error = analysis.error();
    error.file = source;
    return error;
}

} // namespace

Result<Analysis> analyseSwing(const SourcedSwing& swing, const AnalysisOptions& options, const std::optional<SensorBench>& bench)
{
    return named(resultOf(swing.record, nullptr, options, bench), swing.source);
}

Result<Analysis> analyseOnly(SourcedSwing& swing, const AnalysisOptions& options, const std::optional<SensorBench>& bench)
{
    const SwingQuestion question = questionOf(swing.record, nullptr, options, bench);
    static_cast<void>(std::exchange(swing.record.swing.readings, {}));
    return named(answerTo(question), swing.source);
}

} // namespace lubberline::app
