#include "ui/report/ReportData.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "core/base/Contract.h"
#include "core/format/AnalysisJson.h"
#include "core/format/Exchange.h"
#include "core/format/SwingCsv.h"

namespace lubberline::ui {

namespace {

using Column = std::pair<std::string, std::string>;

/// Enough digits to be recomputed from, a decimal point in every locale.
std::string numberCell(std::optional<double> value)
{
    return value && std::isfinite(*value) ? QString::number(*value, 'g', 10).toStdString() : std::string();
}

std::vector<Column> resultColumns(const Reading& reading, const AnalysedReading* analysed)
{
    std::optional<double> deviation_deg, approximate_deg, exact_deg, studentised;
    if (reading.complete())
        deviation_deg = deviationOf(*reading.magnetic, *reading.compass).degrees();
    if (analysed) {
        approximate_deg = analysed->residualApproximate_rad ? std::optional(toDegrees(*analysed->residualApproximate_rad)) : std::nullopt;
        exact_deg = analysed->residualExact_rad ? std::optional(toDegrees(*analysed->residualExact_rad)) : std::nullopt;
        studentised = analysed->studentised;
    }
    const std::string suspect = analysed ? (analysed->suspect ? "yes" : "no") : "";
    return {{"result_deviation_deg", numberCell(deviation_deg)}, {"result_residual_approximate_deg", numberCell(approximate_deg)},
        {"result_residual_exact_deg", numberCell(exact_deg)}, {"result_studentised", numberCell(studentised)}, {"result_suspect", suspect}};
}

/// A report that was read in and is written again gets new results, not two of each.
void putColumns(std::vector<Column>& extra, const std::vector<Column>& results)
{
    for (const Column& result : results) {
        std::erase_if(extra, [&result](const Column& column) { return column.first == result.first; });
        extra.push_back(result);
    }
}

} // namespace

QByteArray reportCsv(const ReportInput& input)
{
    SwingRecord record = input.record;
    std::size_t used = 0;
    for (Reading& reading : record.swing.readings) {
        const AnalysedReading* analysed = nullptr;
        if (reading.used()) {
            LUBBERLINE_EXPECT(used < input.analysis.readings.size(), "the analysis is of this swing's used readings");
            analysed = &input.analysis.readings[used++];
        }
        putColumns(reading.extra, resultColumns(reading, analysed));
    }
    return QByteArray::fromStdString(writeSwingCsv(record));
}

QByteArray reportJson(const ReportInput& input)
{
    nlohmann::ordered_json report;
    report["made_at_utc"] = input.madeAtUtc.toStdString();
    report["data_sha256"] = dataHash(input.record).toStdString();
    report["record"] = nlohmann::ordered_json::parse(writeExchange(toFleet(input.record)));
    report["analysis"] = nlohmann::ordered_json::parse(toJson(input.analysis));
    return QByteArray::fromStdString(report.dump(2) + "\n");
}

} // namespace lubberline::ui
