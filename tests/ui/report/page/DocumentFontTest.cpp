#include <gtest/gtest.h>

#include <QApplication>
#include <QFile>
#include <QProcess>

#include "tests/ui/report/page/PdfProbe.h"
#include "tests/ui/report/swing/SampleSwings.h"
#include "ui/report/page/DocumentFont.h"

namespace lubberline::test {

TEST(DocumentFont, isDejaVuWhereThereIsOneElseTheSystems)
{
    EXPECT_EQ(ui::chooseFamily({"Arial", "DejaVu Sans"}, "Arial").value(), "DejaVu Sans");
    EXPECT_EQ(ui::chooseFamily({"Arial", "Nimbus Sans"}, "Arial").value(), "Arial");
}

TEST(DocumentFont, refusesWithoutAnyAndNamesThePackage)
{
    const auto family = ui::chooseFamily({"Sans Serif", "Serif", "Monospace"}, ""); // what Qt lists without any file
    ASSERT_FALSE(family.ok());
    EXPECT_EQ(family.error().code, ErrorCode::Unsupported);
    EXPECT_NE(family.error().message.english().find("fonts-dejavu-core"), std::string::npos);
}

/// Run by the next test in a process without fonts; alone it finds fonts and has nothing to show.
TEST(DocumentFont, processWithoutFontsWritesNoPdf)
{
    if (!qEnvironmentVariableIsSet("LUBBERLINE_TEST_NO_FONTS")) {
        EXPECT_TRUE(ui::documentFamily().ok());
        return;
    }
    const QTemporaryDir folder;
    const auto written = ui::writeReport(reportOf(simulatedRecord(8)), folder.filePath("report.pdf"));
    ASSERT_FALSE(written.ok());
    EXPECT_EQ(written.error().code, ErrorCode::Unsupported);
    EXPECT_FALSE(QFile::exists(folder.filePath("report.pdf")));
    EXPECT_EQ(ui::writeCard(cardOf(simulatedRecord(12), {}), folder.filePath("card.pdf")).error().code, ErrorCode::Unsupported);
}

TEST(DocumentFont, aSystemWithoutFontsIsRefusedReally)
{
    const QTemporaryDir folder;
    QFile configuration(folder.filePath("fonts.conf"));
    ASSERT_TRUE(configuration.open(QIODevice::WriteOnly));
    configuration.write("<?xml version=\"1.0\"?><fontconfig><cachedir>" + folder.path().toUtf8() + "</cachedir></fontconfig>");
    configuration.close();
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("FONTCONFIG_FILE", configuration.fileName());
    environment.insert("LUBBERLINE_TEST_NO_FONTS", "1");
    process.setProcessEnvironment(environment);
    process.start(QApplication::applicationFilePath(), {"--gtest_filter=DocumentFont.processWithoutFontsWritesNoPdf"});
    ASSERT_TRUE(process.waitForFinished(60000));
    EXPECT_EQ(process.exitCode(), 0) << process.readAllStandardOutput().toStdString();
}

} // namespace lubberline::test
