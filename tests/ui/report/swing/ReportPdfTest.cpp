#include <gmock/gmock.h>

#include <QPageSize>
#include <QPrinter>
#include <QRegularExpression>

#include "tests/ui/report/page/PdfProbe.h"
#include "tests/ui/report/swing/SampleSwings.h"
#include "ui/report/page/DataHash.h"

namespace lubberline::test {

namespace {

ui::ReportInput markedReport()
{
    SwingRecord record = simulatedRecord(12);
    record.aircraft.demonstration = true;
    record.swing.state = SwingState::Draft;
    return reportOf(record);
}

int timesIn(const QString& text, const QString& part) { return static_cast<int>(text.count(part)); }

} // namespace

class ReportOfPoints : public testing::TestWithParam<int> {};

TEST_P(ReportOfPoints, takesTwoPagesWithAndWithoutBanner)
{
    SwingRecord record = simulatedRecord(GetParam());
    EXPECT_EQ(ui::reportPageCount(reportOf(record)).value(), 2);
    EXPECT_EQ(PdfProbe(reportOf(record)).pages().size(), 2);
    record.aircraft.demonstration = true;
    record.swing.state = SwingState::Draft;
    EXPECT_EQ(ui::reportPageCount(reportOf(record)).value(), 2);
}

INSTANTIATE_TEST_SUITE_P(Usual, ReportOfPoints, testing::Values(3, 4, 8, 12, 24));

TEST(ReportPdf, listsEveryReadingOfALongSwingAndRepeatsTheHead)
{
    for (const int points : {24, 36, 72, 200}) {
        const PdfProbe pdf(reportOf(simulatedRecord(points)));
        const QStringList pages = pdf.pages();
        const int heads = timesIn(pdf.text(), "Remark");
        const QRegularExpression row("^\\s*(\\d+)\\s+\\d{3}\\.\\d\\s+\\d{3}\\.\\d\\s+\\d{3}\\.\\d\\s", QRegularExpression::MultilineOption);
        int next = 1;
        for (auto match = row.globalMatch(pdf.text()); match.hasNext(); ++next)
            EXPECT_EQ(match.next().captured(1).toInt(), next);
        EXPECT_EQ(next - 1, points);
        const int tablePages = static_cast<int>(
            std::count_if(pages.begin(), pages.end(), [&row](const QString& page) { return row.match(page).hasMatch(); }));
        EXPECT_EQ(heads, tablePages) << points;
        EXPECT_LT(pdf.bytes().size(), 300 * 1024);
    }
}

TEST(ReportPdf, everyPageIsNumberedAndTellsWhatItBelongsTo)
{
    const auto input = reportOf(simulatedRecord(36));
    const QStringList pages = PdfProbe(input).pages();
    ASSERT_EQ(pages.size(), ui::reportPageCount(input).value());
    for (qsizetype i = 0; i < pages.size(); ++i) {
        EXPECT_TRUE(pages[i].contains(QString("page %1 of %2").arg(i + 1).arg(pages.size())));
        EXPECT_TRUE(pages[i].contains("0f3c1d52-77b1-5a90-8c55-6d2c6f2a9d10"));
        EXPECT_TRUE(pages[i].contains(ui::dataHash(input.record)));
        EXPECT_TRUE(pages[i].contains("SP-XYZ"));
        EXPECT_TRUE(pages[i].contains(QString::fromUtf8("Deviation = magnetic heading − compass heading; easterly is positive")));
        EXPECT_EQ(pages[i].contains("based in part on the work of the Qwt project (http://qwt.sf.net)"), i + 1 == pages.size());
    }
}

TEST(ReportPdf, tellsTheParticulars)
{
    const QString text = PdfProbe(reportOf(simulatedRecord(8))).flowingText();
    for (const char* words :
        {"Su-22", "37130", "Repair plant No. 2", "NV2C-2420-3", "20117", "2026-11-20", "check swing", "MM 34-20-01", "WO 26/1187", "Dęblin",
            "51.5544° N", "variation +6.25°", "WMM2025", "engines running, 1500 rpm", "radio on", "windscreen heat off", "LC-0441",
            "2027-03-01", "B. Zielińska", "Datum reader", "Cockpit reader", "Adjuster", "Inspector", "D. Kamiński", "2026-11-23T06:00:00Z"})
        EXPECT_TRUE(text.contains(QString::fromUtf8(words))) << words;
}

TEST(ReportPdf, saysWhatIsNotStated)
{
    SwingRecord record = simulatedRecord(8);
    record.site.reset();
    record.limits.reset();
    record.swing.configuration = {};
    record.swing.datum = {};
    record.swing.people = {};
    record.swing.date = {};
    const QString text = PdfProbe(reportOf(record)).flowingText();
    EXPECT_TRUE(text.contains("Site not stated"));
    EXPECT_TRUE(text.contains("Swing date not stated"));
    EXPECT_TRUE(text.contains("Configuration not stated"));
    EXPECT_TRUE(text.contains("Datum not stated"));
    EXPECT_TRUE(text.contains("NO LIMIT SET"));
    EXPECT_FALSE(text.contains("PASS"));
}

// NGA Handbook of Magnetic Compass Adjustment (2004), art. 501: the eight-point rules give A 1.0, B 12.0, C 8.0, D 5.0, E 1.5;
// least squares gives B 11.9397 and C 7.9598.
TEST(ReportPdf, printsTheHandbooksCoefficientsByBothMethods)
{
    const QString text = PdfProbe(reportOf(nga501Record())).text();
    const auto line = [&text](const QString& name) {
        return QRegularExpression("^\\s*" + name + ".*$", QRegularExpression::MultilineOption).match(text).captured(0).simplified();
    };
    EXPECT_TRUE(line("A\\s+constant").endsWith("+1.00")) << line("A\\s+constant").toStdString();
    EXPECT_TRUE(line("B\\s+sin").startsWith("B sin +11.94"));
    EXPECT_TRUE(line("B\\s+sin").endsWith("+12.00"));
    EXPECT_TRUE(line("C\\s+cos").startsWith("C cos +7.96"));
    EXPECT_TRUE(line("C\\s+cos").endsWith("+8.00"));
    EXPECT_TRUE(line("D\\s+sin").endsWith("+5.00"));
    EXPECT_TRUE(line("E\\s+cos").endsWith("+1.50"));
    EXPECT_TRUE(text.contains("8 points, compass"));
}

TEST(ReportPdf, judgesAgainstTheNamedDocument)
{
    const QString fails = PdfProbe(reportOf(nga501Record())).flowingText(); // deviation 20° on NE
    EXPECT_TRUE(fails.contains("FAIL"));
    EXPECT_TRUE(fails.contains("14 CFR 25.1327"));
    EXPECT_TRUE(fails.contains("issue 2026"));
    EXPECT_TRUE(fails.contains(QString::fromUtf8("Largest deviation +20.0° at 065.0° magnetic")));
    EXPECT_TRUE(PdfProbe(reportOf(simulatedRecord(8))).text().contains("PASS"));
}

TEST(ReportPdf, keepsExcludedReadingsWithTheirReason)
{
    SwingRecord record = simulatedRecord(12);
    record.swing.readings[4].exclusion = Exclusion{"aircraft was still turning"};
    const QString text = PdfProbe(reportOf(record)).flowingText();
    EXPECT_TRUE(text.contains("EXCLUDED: aircraft was"));
    EXPECT_TRUE(text.contains("Approximate compass heading 11 5"));
}

TEST(ReportPdf, marksASuspectReadingAndKeepsItInUse)
{
    SwingRecord record = simulatedRecord(12);
    const double read_deg = record.swing.readings[4].compass->degrees();
    record.swing.readings[4].compass = CompassHeading::fromDegrees(read_deg + 10);
    const auto input = reportOf(record);
    ASSERT_TRUE(input.analysis.readings[4].suspect);
    const QString text = PdfProbe(input).flowingText();
    EXPECT_EQ(timesIn(text, "SUSPECT, used"), 1);
    EXPECT_TRUE(text.contains("Approximate compass heading 12 5"));
}

TEST(ReportPdf, rowsThatAreStillBeingEnteredAreListedAndNotUsed)
{
    SwingRecord record = simulatedRecord(8);
    record.swing.readings.insert(record.swing.readings.begin() + 2, Reading{});
    record.swing.readings[2].nominal_deg = 77;
    const QString text = PdfProbe(reportOf(record)).flowingText();
    EXPECT_TRUE(text.contains(QString::fromUtf8("3 077.0 — — —")));
    EXPECT_TRUE(text.contains("not complete, not used"));
}

TEST(ReportPdf, leavesEmptyWhatTheReadingsCannotTell)
{
    for (const int points : {3, 4}) {
        const auto input = reportOf(simulatedRecord(points));
        ASSERT_FALSE(input.analysis.warnings.empty());
        const QString text = PdfProbe(input).flowingText();
        EXPECT_TRUE(text.contains(QString::fromUtf8("D sin 2× — — — — —")));
        EXPECT_TRUE(text.contains("What the readings cannot tell"));
        EXPECT_FALSE(text.contains(QRegularExpression("\\b(nan|inf)\\b", QRegularExpression::CaseInsensitiveOption)));
    }
}

TEST(ReportPdf, marksDemonstrationAndDraftOnEveryPage)
{
    for (const QString& page : PdfProbe(markedReport()).pages()) {
        EXPECT_TRUE(page.contains("DEMONSTRATION DATA"));
        EXPECT_TRUE(page.contains(QString::fromUtf8("DRAFT — NOT SIGNED")));
    }
    const QString plain = PdfProbe(reportOf(simulatedRecord(12))).text();
    EXPECT_FALSE(plain.contains("DEMONSTRATION"));
    EXPECT_FALSE(plain.contains("DRAFT"));
}

TEST(ReportPdf, followsTheAngleStyle)
{
    auto input = reportOf(simulatedRecord(8));
    input.angleStyle = AngleStyle::DegreesMinutes;
    const QString text = PdfProbe(input).text();
    EXPECT_TRUE(text.contains(QString::fromUtf8("045°00")));
    EXPECT_FALSE(text.contains("045.0 "));
}

TEST(ReportPdf, printsHeadingsWithTheDecimalsTheyWereReadWith)
{
    SwingRecord record = simulatedRecord(8);
    record.swing.readings[1].magnetic = MagneticHeading::fromDegrees(45.125);
    const QString text = PdfProbe(reportOf(record)).text();
    EXPECT_TRUE(text.contains("045.125"));
    EXPECT_TRUE(text.contains("090.000"));
}

TEST(ReportPdf, namesThePreviousSwingInTheCurve)
{
    auto input = reportOf(simulatedRecord(8));
    EXPECT_FALSE(PdfProbe(input).text().contains("2025-11-18"));
    input.previous = simulatedRecord(8, 1.3).swing;
    input.previous->date = "2025-11-18";
    EXPECT_TRUE(PdfProbe(input).text().contains("2025-11-18"));
    input.previous->readings.resize(1); // allows no result: the report is made without it
    EXPECT_TRUE(PdfProbe(input).text().contains("PASS"));
}

TEST(ReportPdf, takesTextOfAnyLengthWithoutLosingAny)
{
    SwingRecord record = simulatedRecord(8);
    for (int i = 0; i < 2000; ++i)
        record.swing.note += "word" + std::to_string(i) + " ";
    record.swing.note += std::string(3000, 'x'); // and one without a blank
    record.swing.readings[0].exclusion = Exclusion{std::string(5000, 'y')};
    const PdfProbe pdf(reportOf(record));
    const QString text = pdf.text();
    for (int i = 0; i < 2000; ++i)
        ASSERT_TRUE(text.contains(QString("word%1").arg(i))) << i;
    EXPECT_GE(text.count('x'), 3000);
    const QStringList pages = pdf.pages();
    for (qsizetype i = 0; i < pages.size(); ++i)
        EXPECT_TRUE(pages[i].contains(QString("page %1 of %2").arg(i + 1).arg(pages.size())));
}

TEST(ReportPdf, isOfTheVersionAskedForAndSmall)
{
    auto input = reportOf(simulatedRecord(8));
    const PdfProbe pdf(input);
    EXPECT_TRUE(pdf.bytes().startsWith("%PDF-1.6"));
    EXPECT_LT(pdf.bytes().size(), 300 * 1024);
    EXPECT_THAT(pdf.suspiciousObjects(), testing::IsEmpty()); // vectors only
}

TEST(ReportPdf, archiveHasNoAttachmentNoTransparencyAndAnOutputIntent)
{
    auto input = markedReport();
    input.archive = true;
    const PdfProbe pdf(input);
    EXPECT_TRUE(pdf.bytes().startsWith("%PDF-1.4"));
    EXPECT_TRUE(pdf.bytes().contains("pdfaid"));
    EXPECT_TRUE(pdf.hasCatalogKey("/OutputIntents"));
    EXPECT_TRUE(pdf.hasCatalogKey("/Metadata"));
    EXPECT_THAT(pdf.suspiciousObjects(), testing::IsEmpty());
    const auto exchange = ui::exchangeInReport(pdf.path());
    ASSERT_FALSE(exchange.ok());
    EXPECT_EQ(exchange.error().code, ErrorCode::Format);
}

TEST(ReportPdf, sameInputGivesTheSamePages)
{
    const auto input = reportOf(simulatedRecord(8));
    const QByteArray first = PdfProbe(input).rendered();
    EXPECT_GT(first.size(), 100000);
    EXPECT_EQ(first, PdfProbe(input).rendered());
}

TEST(ReportPdf, printersGetTheSamePages)
{
    const auto input = reportOf(simulatedRecord(24));
    QTemporaryDir folder;
    QPrinter printer(QPrinter::HighResolution);
    printer.setOutputFormat(QPrinter::PdfFormat);
    printer.setOutputFileName(folder.filePath("printed.pdf"));
    printer.setPageSize(QPageSize(QPageSize::A4));
    printer.setPageMargins(QMarginsF(7, 9, 7, 9), QPageLayout::Millimeter);
    ASSERT_TRUE(ui::printReport(input, printer).ok());
    EXPECT_EQ(PdfProbe(folder.filePath("printed.pdf")).flowingText(), PdfProbe(input).flowingText());
}

TEST(ReportPdf, takesThePrintersPageSize)
{
    const auto input = reportOf(simulatedRecord(8));
    QTemporaryDir folder;
    QPrinter printer;
    printer.setOutputFormat(QPrinter::PdfFormat);
    printer.setOutputFileName(folder.filePath("printed.pdf"));
    printer.setPageSize(QPageSize(QPageSize::Letter));
    ASSERT_TRUE(ui::printReport(input, printer).ok());
    const QStringList pages = PdfProbe(folder.filePath("printed.pdf")).pages();
    EXPECT_TRUE(pages.last().contains(QString("page %1 of %1").arg(pages.size())));
    EXPECT_TRUE(pages.last().contains("Inspector"));
}

} // namespace lubberline::test
