#include <gtest/gtest.h>

#include <QStringList>

#include <fstream>

#include <nlohmann/json.hpp>

#include "core/format/csv/SwingCsv.h"
#include "core/format/exchange/Exchange.h"
#include "core/format/results/AnalysisJson.h"
#include "tests/ui/report/page/PdfProbe.h"
#include "tests/ui/report/swing/SampleSwings.h"
#include "ui/report/page/DataHash.h"
#include "ui/report/swing/ReportData.h"

namespace lubberline::test {

namespace {

Result<SwingFile> readBack(const QByteArray& csv)
{
    std::istringstream stream(csv.toStdString());
    return readSwingCsv(stream, "report.csv");
}

} // namespace

TEST(ReportCsv, ourReaderGetsTheReadingsBack)
{
    SwingRecord record = simulatedRecord(12);
    record.swing.readings[2].exclusion = Exclusion{"gust, \"again\""};
    record.swing.readings[5].note = "two\nlines; a, comma";
    const auto file = readBack(ui::reportCsv(reportOf(record)));
    ASSERT_TRUE(file.ok()) << describe(file.error());
    ASSERT_EQ(file->swing.readings.size(), 12u);
    for (std::size_t i = 0; i < 12; ++i) {
        EXPECT_EQ(file->swing.readings[i].magnetic, record.swing.readings[i].magnetic);
        EXPECT_EQ(file->swing.readings[i].compass, record.swing.readings[i].compass);
    }
    EXPECT_EQ(file->swing.readings[2].exclusion, record.swing.readings[2].exclusion);
    EXPECT_EQ(file->aircraft, "SP-XYZ");
    EXPECT_EQ(file->swing.date, Date("2026-11-20"));
}

TEST(ReportCsv, theResultsStandBesideTheReadings)
{
    const auto input = reportOf(simulatedRecord(8));
    const auto file = readBack(ui::reportCsv(input));
    ASSERT_TRUE(file.ok()) << describe(file.error());
    for (std::size_t i = 0; i < 8; ++i) {
        const auto& extra = file->swing.readings[i].extra;
        const auto found
            = std::find_if(extra.begin(), extra.end(), [](const auto& column) { return column.first == "residual_approximate_deg"; });
        ASSERT_NE(found, extra.end());
        EXPECT_NEAR(std::stod(found->second), toDegrees(*input.analysis.readings[i].residualApproximate_rad), 1e-9);
    }
}

TEST(ReportCsv, aReportOfAReportHasEachColumnOnce)
{
    auto input = reportOf(simulatedRecord(8));
    const QByteArray once = ui::reportCsv(input);
    input.record.swing.readings = readBack(once)->swing.readings;
    const QByteArray twice = ui::reportCsv(input);
    ASSERT_TRUE(readBack(twice).ok());
    EXPECT_EQ(twice.count("residual_exact_deg"), 1);
}

TEST(ReportCsv, excludedAndUnfinishedReadingsHaveNoResults)
{
    SwingRecord record = simulatedRecord(8);
    record.swing.readings[0].exclusion = Exclusion{"reason"};
    record.swing.readings.push_back(Reading{});
    const QStringList lines = QString::fromUtf8(ui::reportCsv(reportOf(record))).split('\n', Qt::SkipEmptyParts);
    const QStringList rows = lines.mid(lines.size() - 8);
    EXPECT_TRUE(rows.first().endsWith(",,,"));
    EXPECT_TRUE(rows.last().endsWith(",no"));
    for (const QString& row : rows)
        EXPECT_EQ(row.count(','), lines[lines.size() - 9].count(','));
}

TEST(ReportJson, holdsTheRecordAndTheAnalysis)
{
    const auto input = reportOf(simulatedRecord(8));
    const auto json = nlohmann::json::parse(ui::reportJson(input).toStdString());
    EXPECT_EQ(json["record"], nlohmann::json::parse(writeExchange(toFleet(input.record))));
    EXPECT_EQ(json["analysis"], nlohmann::json::parse(toJson(input.analysis)));
    EXPECT_EQ(json["data_sha256"], ui::dataHash(input.record).toStdString());
    EXPECT_EQ(json["made_at_utc"], "2026-11-23T06:00:00Z");
    EXPECT_EQ(json["analysis"]["readings"].size(), 8u);
}

} // namespace lubberline::test
