#include "ui/report/swing/ReportData.h"

#include <QString>

#include <cmath>

#include <nlohmann/json.hpp>

#include "core/base/Contract.h"
#include "core/format/csv/SwingCsv.h"
#include "core/format/exchange/Exchange.h"
#include "core/format/results/AnalysisJson.h"
#include "ui/report/page/DataHash.h"
#include "ui/report/page/Figures.h"

namespace lubberline::ui {

namespace {

using Cell = std::pair<std::string, std::string>;

/// Enough digits to be recomputed from, a decimal point in every locale; nothing for what is not known.
std::string numberCell(std::optional<double> value)
{
    return value && std::isfinite(*value) ? QString::number(*value, 'g', 10).toStdString() : std::string();
}

std::vector<Cell> resultCells(const Reading& reading, const AnalysedReading* analysed)
{
    const auto deviation_deg
        = reading.complete() ? std::optional(deviationOf(*reading.magnetic, *reading.compass).degrees()) : std::nullopt;
    const AnalysedReading nothing;
    const AnalysedReading& results = analysed ? *analysed : nothing;
    return {{"deviation_deg", numberCell(deviation_deg)},
        {"residual_approximate_deg", numberCell(inDegrees(results.residualApproximate_rad))},
        {"residual_exact_deg", numberCell(inDegrees(results.residualExact_rad))}, {"studentised", numberCell(results.studentised)},
        {"suspect",
            !analysed               ? ""
                : analysed->suspect ? "yes"
                                    : "no"}};
}

/// A swing that came from a report gets new results, not two of each.
void putCells(std::vector<Cell>& extra, const std::vector<Cell>& results)
{
    for (const Cell& result : results) {
        std::erase_if(extra, [&result](const Cell& cell) { return cell.first == result.first; });
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
        putCells(reading.extra, resultCells(reading, analysed));
    }
    const QString remark = QStringLiteral("# deviation = magnetic - compass, east positive; data SHA-256 %1\n").arg(dataHash(input.record));
    return remark.toUtf8() + QByteArray::fromStdString(writeSwingCsv(record));
}

QByteArray reportJson(const ReportInput& input)
{
    nlohmann::ordered_json report;
    report["made_at_utc"] = input.madeAtUtc.toStdString();
    report["data_sha256"] = dataHash(input.record).toStdString();
    if (!input.audit.head.isEmpty())
        report["audit"] = {{"head", input.audit.head.toStdString()}, {"entries", input.audit.entries}};
    report["record"] = nlohmann::ordered_json::parse(writeExchange(toFleet(input.record)));
    report["analysis"] = nlohmann::ordered_json::parse(toJson(input.analysis));
    return QByteArray::fromStdString(report.dump(2) + "\n");
}

} // namespace lubberline::ui
