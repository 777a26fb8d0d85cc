/// Where reports may be written, and what is left behind when they may not.

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>

#include "tests/ui/report/page/PdfProbe.h"
#include "tests/ui/report/swing/SampleSwings.h"

namespace lubberline::test {

namespace {

QStringList listOf(const QTemporaryDir& folder)
{
    return QDir(folder.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden);
}

} // namespace

TEST(ReportFile, anotherEndingIsRefusedAndTheKnownOnesAreNamed)
{
    const QTemporaryDir folder;
    for (const char* name : {"report.doc", "report", "report.pdf.bak"}) {
        const auto written = ui::writeReport(reportOf(simulatedRecord(8)), folder.filePath(name));
        ASSERT_FALSE(written.ok()) << name;
        EXPECT_EQ(written.error().code, ErrorCode::InvalidInput) << name;
        EXPECT_NE(written.error().message.english().find(".pdf, .html, .csv or .json"), std::string::npos);
        EXPECT_EQ(written.error().file, folder.filePath(name).toStdString());
    }
    EXPECT_TRUE(listOf(folder).isEmpty());
}

TEST(ReportFile, theEndingMayBeInCapitals)
{
    const QTemporaryDir folder;
    EXPECT_TRUE(ui::writeReport(reportOf(simulatedRecord(8)), folder.filePath("REPORT.PDF")).ok());
    EXPECT_EQ(listOf(folder), QStringList{"REPORT.PDF"}); // and nothing beside it
}

TEST(ReportFile, aMissingFolderIsNamed)
{
    const QTemporaryDir folder;
    for (const char* ending : {"pdf", "html", "csv", "json"}) {
        const auto written = ui::writeReport(reportOf(simulatedRecord(8)), folder.filePath(QString("none/report.") + ending));
        ASSERT_FALSE(written.ok());
        EXPECT_EQ(written.error().code, ErrorCode::Io);
        EXPECT_NE(written.error().message.english().find(folder.filePath("none").toStdString()), std::string::npos)
            << written.error().message.english();
    }
    EXPECT_TRUE(listOf(folder).isEmpty());
}

TEST(ReportFile, aFolderThatIsAFileOrAFileThatIsAFolderIsRefused)
{
    const QTemporaryDir folder;
    QFile file(folder.filePath("file"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    QDir(folder.path()).mkdir("folder.pdf");
    EXPECT_EQ(ui::writeReport(reportOf(simulatedRecord(8)), folder.filePath("file/report.pdf")).error().code, ErrorCode::Io);
    EXPECT_EQ(ui::writeReport(reportOf(simulatedRecord(8)), folder.filePath("folder.pdf")).error().code, ErrorCode::Io);
    EXPECT_EQ(listOf(folder), (QStringList{"file", "folder.pdf"}));
}

TEST(ReportFile, aFolderThatTakesNoFilesIsNamed)
{
    // /proc takes no files from anybody, the superuser included.
    const auto written = ui::writeReport(reportOf(simulatedRecord(8)), "/proc/report.pdf");
    ASSERT_FALSE(written.ok());
    EXPECT_EQ(written.error().code, ErrorCode::Io);
    EXPECT_NE(written.error().message.english().find("/proc"), std::string::npos);
}

TEST(ReportFile, anOldReportIsReplacedWhole)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("report.json");
    QFile old(path);
    ASSERT_TRUE(old.open(QIODevice::WriteOnly));
    old.write(QByteArray(1000000, 'x'));
    old.close();
    ASSERT_TRUE(ui::writeReport(reportOf(simulatedRecord(8)), path).ok());
    ASSERT_TRUE(old.open(QIODevice::ReadOnly));
    const QByteArray now = old.readAll();
    EXPECT_TRUE(now.startsWith('{'));
    EXPECT_TRUE(now.endsWith("}\n"));
}

} // namespace lubberline::test
