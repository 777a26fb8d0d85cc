#include "ui/report/ReportData.h"

#include <QStringList>

#include <algorithm>
#include <array>
#include <cmath>

#include <nlohmann/json.hpp>

#include "core/base/Contract.h"
#include "core/format/AnalysisJson.h"
#include "core/format/Exchange.h"
#include "core/format/SwingCsv.h"
#include "ui/report/Figures.h"
#include "ui/report/Words.h"

namespace lubberline::ui {

namespace {

constexpr std::array kResultColumns{"residual_approximate_deg", "residual_exact_deg", "studentised", "suspect"};

/// Enough digits to be recomputed from, a decimal point in every locale.
QString numberCell(std::optional<double> value)
{
    return value && std::isfinite(*value) ? QString::number(*value, 'g', 10) : QString();
}

QString resultCells(const AnalysedReading* analysed)
{
    if (!analysed)
        return QString(static_cast<qsizetype>(kResultColumns.size() - 1), ',');
    return QStringList{numberCell(inDegrees(analysed->residualApproximate_rad)), numberCell(inDegrees(analysed->residualExact_rad)),
        numberCell(analysed->studentised), analysed->suspect ? QStringLiteral("yes") : QStringLiteral("no")}
        .join(',');
}

/// The record with one line for each reading when it is written: rows that are still being entered are no readings, and a file
/// that came from a report gets new results, not two of each.
SwingRecord writable(SwingRecord record)
{
    std::erase_if(record.swing.readings, [](const Reading& reading) { return !reading.complete(); });
    for (Reading& reading : record.swing.readings) {
        reading.note = printable(reading.note).toStdString();
        if (reading.exclusion)
            reading.exclusion->reason = printable(reading.exclusion->reason).toStdString();
        std::erase_if(reading.extra, [](const auto& column) {
            return std::find(kResultColumns.begin(), kResultColumns.end(), column.first) != kResultColumns.end();
        });
    }
    return record;
}

QString resultHeader()
{
    QStringList names;
    for (const char* name : kResultColumns)
        names += QString::fromLatin1(name);
    return names.join(',');
}

} // namespace

QByteArray reportCsv(const ReportInput& input)
{
    const SwingRecord record = writable(input.record);
    QStringList lines = QString::fromStdString(writeSwingCsv(record)).split('\n', Qt::SkipEmptyParts);
    const auto header = std::find_if(lines.begin(), lines.end(), [](const QString& line) { return !line.startsWith('#'); });
    LUBBERLINE_EXPECT(lines.end() - header == static_cast<qsizetype>(record.swing.readings.size()) + 1, "a Swing CSV has one line a reading");
    *header += ',' + resultHeader();
    std::size_t used = 0;
    for (std::size_t i = 0; i < record.swing.readings.size(); ++i) {
        const AnalysedReading* analysed = nullptr;
        if (record.swing.readings[i].used()) {
            LUBBERLINE_EXPECT(used < input.analysis.readings.size(), "the analysis is of this swing's used readings");
            analysed = &input.analysis.readings[used++];
        }
        header[static_cast<qsizetype>(i) + 1] += ',' + resultCells(analysed);
    }
    const QString particulars = QStringLiteral("# report_made_at_utc: %1\n# report_data_sha256: %2\n").arg(input.madeAtUtc, dataHash(input.record));
    return (particulars + lines.join('\n') + '\n').toUtf8();
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
