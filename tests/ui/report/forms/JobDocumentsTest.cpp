// The documents of a guided swing: worksheet example Q1 (V1) as a whole, the sheet in DD 1613 style with the Army's example
// (TM 1-1500-204-23-4, pp. 4-27 to 4-29), the job card and its QR code.

#include <gmock/gmock.h>

#include <QImage>
#include <QPainter>
#include <QTemporaryDir>

#include "core/procedure/Checklist.h"
#include "core/procedure/JobState.h"
#include "core/swing/Card.h"
#include "core/swing/Observations.h"
#include "tests/ui/report/page/PdfProbe.h"
#include "ui/report/forms/JobCard.h"
#include "ui/report/forms/StyleSheet1613.h"
#include "ui/report/page/QrCode.h"
#include "ui/report/swing/JobTables.h"
#include "ui/report/swing/ReportContent.h"

namespace lubberline::test {

namespace {

struct Done {
    ui::ReportInput input;
    Swing asFound;
};

/// Worksheet example Q1, with a reading put aside and one load that moves the compass.
Done worksheetJob()
{
    SwingJob job;
    job.record = newRecordId();
    job.particulars.date = "2026-11-23";
    job.particulars.job = job.record;
    const auto tell = [&](job::What what) { job.events.push_back({"2026-11-23T09:00:00Z", std::move(what)}); };
    const auto now = [&] { return stateOf(job).value(); };
    const auto read = [&](double magnetic, double compass) {
        tell(job::ReadingTaken{now().current, {{magnetic}, {}, {compass, compass}}, magnetic, compass, {}});
    };
    const auto obey = [&](double after) {
        const auto state = now();
        tell(job::Adjusted{state.current, state.turn->control, state.turn->compassReads_deg, state.turn->makeCompassRead_deg, after, {}});
    };
    tell(job::InterferenceRead{90, "generators", 85, 87});
    tell(job::Prepared{});
    read(359, 13);
    tell(job::ReadingRejected{0, "ten degrees misread"});
    read(359, 3), read(91, 85), read(178, 170), obey(176), read(267, 265), obey(263);
    for (const auto& [magnetic, compass] :
        {std::pair{317, 316}, {0, 358}, {47, 42}, {93, 89}, {135, 134}, {179, 177}, {225, 220}, {273, 269}})
        read(magnetic, compass);
    tell(job::IndexRemoved{269, 272, 272});
    Done done;
    const auto state = now();
    done.input.record.swing = asLeftSwing(job, state);
    done.input.record.swing.record = newRecordId();
    done.input.record.swing.signatures = {{SignatureRole::Performer, "Ada", "PL 12", "2026-11-23T11:00:00Z", std::string(64, 'a')}};
    done.input.record.aircraft.registration = "3713";
    done.input.record.compass.name = "standby compass";
    done.input.analysis = analyse(observationsOf(done.input.record.swing)).value();
    job.particulars = done.input.record.swing; // as stores hands it out afterwards
    done.input.job = JobRecord{{}, job};
    done.asFound = asFoundSwing(job, state);
    return done;
}

ui::StyleSheet1613 sheetOf(const Done& done)
{
    ui::StyleSheet1613 sheet;
    sheet.record = done.input.record;
    sheet.asFound = done.asFound;
    sheet.madeAtUtc = "2026-11-23T10:00:00Z";
    return sheet;
}

QStringList titles(const std::vector<ui::Table>& tables)
{
    QStringList all;
    for (const auto& table : tables)
        all += table.title;
    return all;
}

} // namespace

TEST(JobDocuments, theCardOfAGuidedSwingHasTheWorksheetsFigures)
{
    const Done done = worksheetJob();
    for (const auto source : {CardSource::Fit, CardSource::Readings}) {
        const auto card = makeCard(done.input.analysis, {45, source, {}});
        ASSERT_TRUE(card);
        const std::array steer{1, 43, 89, 137, 181, 223, 269, 317};
        for (std::size_t i = 0; i < steer.size(); ++i)
            EXPECT_EQ(card->rows[i].steerRounded_deg(), steer[i]) << i;
    }
}

/// What stands on the placard must not depend on when it is printed, but for the mark of the reprint.
TEST(JobDocuments, aLostCardIsPrintedAgainWithTheSameFigures)
{
    Done done = worksheetJob();
    done.input.record.swing.state = SwingState::Signed;
    ui::CardInput input{{{"STEER", makeCard(done.input.analysis, {45, CardSource::Fit, {}}).value(), done.input.record, true, false}}, {}};
    input.loadsToName = QStringList{"pitot heat (+15° on 90)"};
    const QString first = PdfProbe(input).flowingText();
    input.reprintOf = "2026-11-23";
    const QString again = PdfProbe(input).flowingText();
    EXPECT_TRUE(again.contains("Reprint of 2026-11-23")) << again.toStdString();
    EXPECT_FALSE(first.contains("Reprint"));
    EXPECT_TRUE(first.contains("Performed Ada · PL 12 · 2026-11-23"));
    EXPECT_TRUE(first.contains(QString("OVER 10° WITH PITOT HEAT"))) << first.toStdString();
    const auto without = [](QString text) {
        return text.remove("Reprint of 2026-11-23").remove("Reprint of the card of 2026-11-23, from the record").simplified();
    };
    EXPECT_EQ(without(again), without(first));
}

TEST(JobDocuments, aCardOfTwelveHeadingsIsOnePage)
{
    Done done = worksheetJob();
    done.input.record.swing.state = SwingState::Draft; // with a banner
    done.input.record.swing.note = "on the second day, after rain";
    ui::CardInput input{{{"STEER", makeCard(done.input.analysis, {30, CardSource::Fit, {}}).value(), done.input.record, false, false}}, {}};
    input.nextDue = "2028-11-23";
    input.loadsToName = QStringList{"pitot heat (+15° on 90)"};
    EXPECT_EQ(PdfProbe(input).pages().size(), 1);
}

TEST(JobDocuments, whatIsFoundIsNotMovedByTheIndexThatWasTakenOutLater)
{
    const Done done = worksheetJob();
    EXPECT_FALSE(done.asFound.indexRemoved_deg);
    EXPECT_EQ(observationsOf(done.asFound).front().compass.degrees(), 3.0);
    EXPECT_EQ(observationsOf(done.input.record.swing).front().compass.degrees(), 319.0); // 316 + A of 3
}

TEST(JobDocuments, theRecordTellsWhatWasDone)
{
    const Done done = worksheetJob();
    const auto tables = ui::jobTables(done.input);
    ASSERT_EQ(tables.size(), 5u) << titles(tables).join('|').toStdString();
    EXPECT_EQ(tables[0].rows[2].cells, QStringList({"180", "178.0", "170.0", "+8.0", "−1.0", ""}));
    EXPECT_EQ(tables[1].rows[0].cells.mid(1, 5), QStringList({"180", "N–S (C)", "170.0", "176.0", "176.0"}));
    EXPECT_EQ(tables[1].rows[2].cells.mid(2, 4), QStringList({"index (A)", "269.0", "272.0", "272.0"}));
    EXPECT_EQ(tables[2].rows[0].cells, QStringList({"90", "generators", "85.0", "87.0", "+2.0"}));
    EXPECT_EQ(tables[3].rows[0].cells.mid(1), QStringList({"0", "put aside", "ten degrees misread"}));
    EXPECT_EQ(tables[4].rows[0].cells[4], "316  316");
    const auto content = ui::contentOf(done.input);
    ASSERT_EQ(content.signatures.size(), 2u);
    EXPECT_EQ(content.signatures[1].role, "Inspected"); // still to be signed
    EXPECT_TRUE(content.signatures[1].name.isEmpty());
    EXPECT_EQ(content.signatures[0].name, "Ada · PL 12");
    EXPECT_TRUE(content.signatures[0].sign.contains("no longer holds")); // its hash is not that of this swing
}

TEST(JobDocuments, aRevisionShowsWhatItChanges)
{
    Done done = worksheetJob();
    done.input.superseded = done.input.record.swing;
    done.input.record.swing.amendment = "the date was wrong";
    done.input.record.swing.date = "2026-11-22";
    const auto tables = ui::jobTables(done.input);
    EXPECT_TRUE(tables[0].title.contains("the date was wrong"));
    EXPECT_EQ(tables[0].rows[0].cells, QStringList({"date", "2026-11-23", "2026-11-22"}));
}

/// N 008, E 086, S 176, W 278: deviations of the form (compass − magnetic) +8, −4, −4, +8; after compensation N 002 and E 092.
TEST(StyleSheet1613, hasTheFormsOwnSign)
{
    const auto swing = [](std::initializer_list<std::pair<double, double>> pairs) {
        Swing made;
        for (const auto& [magnetic, compass] : pairs) {
            Reading reading;
            reading.magnetic = MagneticHeading::fromDegrees(magnetic);
            reading.compass = CompassHeading::fromDegrees(compass);
            made.readings.push_back(reading);
        }
        return made;
    };
    ui::StyleSheet1613 sheet;
    sheet.asFound = swing({{0, 8}, {90, 86}, {180, 176}, {270, 278}});
    sheet.record.swing = swing({{0, 2}, {90, 92}, {180, 182}, {270, 272}});
    const ui::Table table = ui::table1613(sheet);
    ASSERT_EQ(table.rows.size(), 8u);
    EXPECT_EQ(table.rows[0].cells, QStringList({"N 000", "0.0", "8.0", "+8.0", "0.0", "2.0", "−2.0", "+2.0"}));
    EXPECT_EQ(table.rows[2].cells, QStringList({"E 090", "90.0", "86.0", "−4.0", "90.0", "92.0", "−2.0", "+2.0"}));
    EXPECT_EQ(table.rows[4].cells[3], "−4.0");
    EXPECT_EQ(table.rows[6].cells[3], "+8.0");
    EXPECT_EQ(table.rows[1].cells[1], "—"); // nothing was read there
}

TEST(StyleSheet1613, saysWhatItIsWorthAndWhoSigned)
{
    const QTemporaryDir folder;
    const Done done = worksheetJob();
    auto sheet = sheetOf(done);
    ASSERT_TRUE(ui::write1613(sheet, folder.filePath("draft.pdf")));
    const QString draft = PdfProbe(folder.filePath("draft.pdf")).flowingText();
    EXPECT_TRUE(draft.contains(QString("DRAFT — NOT SIGNED")) && !draft.contains("signed Ada"));
    EXPECT_TRUE(draft.contains(QString("within the 5° that are allowed"))) << draft.toStdString();
    EXPECT_TRUE(draft.contains("by the nearest reading"));
    EXPECT_TRUE(draft.contains(QString("+4.0"))); // the compensating swing's N: 003 read on 359
    sheet.record.swing.state = SwingState::Signed;
    sheet.holds = true;
    ASSERT_TRUE(ui::write1613(sheet, folder.filePath("signed.pdf")));
    const QString text = PdfProbe(folder.filePath("signed.pdf")).flowingText();
    EXPECT_TRUE(text.contains(QString("signed Ada · PL 12")) && !text.contains("DRAFT"));
    sheet.record.swing.signatures.front().name = std::string(90, 'W'); // the strip that is cut off says all of it, and what it is worth
    sheet.remarks = {MARKED("core", "NOT LEVEL")};
    sheet.outOfLimits = true;
    ASSERT_TRUE(ui::write1613(sheet, folder.filePath("long.pdf")));
    const QString strip = PdfProbe(folder.filePath("long.pdf")).flowingText().section("TO FLY", 1);
    EXPECT_TRUE(strip.contains("(names not verified)") && strip.contains("NOT LEVEL") && strip.contains("OUT OF LIMITS"))
        << strip.toStdString();
    sheet.compensating = sheet.record; // another record, which nobody signed
    sheet.compensating->swing.state = SwingState::Draft;
    ASSERT_TRUE(ui::write1613(sheet, folder.filePath("other.pdf")));
    EXPECT_TRUE(PdfProbe(folder.filePath("other.pdf")).flowingText().contains(QString("DRAFT — NOT SIGNED")));
    for (auto& reading : sheet.record.swing.readings)
        if (reading.magnetic->degrees() == 93)
            reading.compass = CompassHeading::fromDegrees(30); // STEER falls from 043 to 027
    EXPECT_EQ(ui::write1613(sheet, folder.filePath("folded.pdf")).error().code, ErrorCode::Numeric);
}

TEST(JobCard, readsAsFoundBeforeItZeroesAndHasOnlyWhatTheCompassHas)
{
    const QTemporaryDir folder;
    const Done done = worksheetJob();
    ui::JobCardInput card{done.input.record, done.input.job->job, "2026-11-23T10:00:00Z"};
    card.job.checklist = usualChecklist(card.record.compass);
    card.job.checklist.push_back("compensator at zero: dots on the screws in line with those on the case"); // as an earlier job has it
    card.job.checklist.push_back("variation setter at 000.0");
    ASSERT_TRUE(ui::writeJobCard(card, folder.filePath("job.pdf")));
    const QString text = PdfProbe(folder.filePath("job.pdf")).flowingText();
    EXPECT_FALSE(text.contains("variation setter"));
    EXPECT_FALSE(text.contains("compensator at zero"));
    EXPECT_LT(text.indexOf("read as found"), text.indexOf("then zero the compensator"));
    EXPECT_LT(text.indexOf("Before the first reading"), text.indexOf("then zero the compensator"));
    EXPECT_TRUE(text.contains("inspected by"));
    card.record.compass.kind = CompassKind::RemoteStabilised;
    card.record.compass.compensator = Compensator::None;
    card.job.checklist = usualChecklist(card.record.compass);
    ASSERT_TRUE(ui::writeJobCard(card, folder.filePath("remote.pdf")));
    const QString remote = PdfProbe(folder.filePath("remote.pdf")).flowingText();
    EXPECT_TRUE(remote.contains("variation setter at 000.0"));
    EXPECT_FALSE(remote.contains("zero the compensator"));
}

TEST(JobCard, tellsWhatToDoWhere)
{
    SwingJob job;
    job.plan.kind = ProcedureKind::Coefficient;
    const QStringList formulas = ui::stationFormulas(job);
    ASSERT_EQ(formulas.size(), 12);
    EXPECT_TRUE(formulas[0].isEmpty());
    EXPECT_TRUE(formulas[2].contains("C = (dN − dS)/2") && formulas[2].contains("compass − C")) << formulas[2].toStdString(); // on S
    EXPECT_TRUE(formulas[3].contains("compass − B")) << formulas[3].toStdString();                                            // on W
    job.plan.kind = ProcedureKind::FluxValve;
    EXPECT_TRUE(ui::stationFormulas(job)[4].contains("compass + C")); // on N
    EXPECT_TRUE(ui::stationFormulas(job)[5].contains("compass + B")); // on E
}

TEST(JobDocuments, areWrittenAsPages)
{
    const QTemporaryDir folder;
    const Done done = worksheetJob();
    ui::JobCardInput card{done.input.record, done.input.job->job, "2026-11-23T10:00:00Z"};
    card.job.checklist = usualChecklist({});
    ASSERT_TRUE(ui::writeJobCard(card, folder.filePath("job.pdf")));
    ASSERT_TRUE(ui::write1613(sheetOf(done), folder.filePath("dd.pdf")));
    ASSERT_TRUE(ui::writeReport(done.input, folder.filePath("report.html")));
    for (const char* name : {"job.pdf", "dd.pdf"})
        EXPECT_TRUE(PdfProbe(folder.filePath(name)).bytes().startsWith("%PDF-1.4")) << name; // PDF/A-1b
    const QString blank = PdfProbe(folder.filePath("job.pdf")).flowingText();
    for (const char* words : {"Compass swing: job card", "page 1 of 2", "N–S screw:", "it read after:", "no magnetic items on persons",
             "To be filled in", "adjusted by"})
        EXPECT_TRUE(blank.contains(QString::fromUtf8(words))) << words;
    EXPECT_TRUE(blank.contains("Record " + QString::fromStdString(done.input.record.swing.record)));
    const QString sheet = PdfProbe(folder.filePath("dd.pdf")).flowingText();
    EXPECT_TRUE(sheet.contains(QString("On this sheet DEV = compass heading − magnetic heading")));
    EXPECT_FALSE(sheet.contains(QString("Deviation = magnetic heading − compass heading"))); // two signs on one page would be read wrongly
    EXPECT_TRUE(sheet.contains("TO FLY (M)") && sheet.contains("001 043 089 137 181 223 269 317"));
    EXPECT_EQ(ui::writeJobCard(card, folder.filePath("job.txt")).error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(ui::write1613(sheetOf(done), folder.filePath("missing/dd.pdf")).error().code, ErrorCode::Io);
    QFile html(folder.filePath("report.html"));
    ASSERT_TRUE(html.open(QIODevice::ReadOnly));
    const QString text = QString::fromUtf8(html.readAll());
    EXPECT_TRUE(text.contains("ten degrees misread") && text.contains("As found"));
}

TEST(QrCode, isDrawnAsItsModules)
{
    EXPECT_EQ(ui::qrOf({}).error().code, ErrorCode::InvalidInput);
    const auto matrix = ui::qrOf("32c1ea9b-ab1a-4356-b71b-85a1dc87fcdd");
    ASSERT_TRUE(matrix);
    EXPECT_EQ(matrix->width % 4, 1); // 17 + 4 × version
    const int module = 4, side = (matrix->width + 8) * module;
    QImage image(side, side, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    ui::paintQr(painter, QRectF(0, 0, side, side), *matrix);
    painter.end();
    for (int row = 0; row < matrix->width; ++row)
        for (int column = 0; column < matrix->width; ++column) {
            const QColor seen(image.pixel((column + 4) * module + 2, (row + 4) * module + 2));
            ASSERT_EQ(seen.lightness() < 128, bool(matrix->dark[static_cast<std::size_t>(row * matrix->width + column)]))
                << row << ' ' << column;
        }
    for (int i = 0; i < side; ++i) // the quiet zone
        ASSERT_EQ(QColor(image.pixel(i, 4 * module - 3)).lightness(), 255);
    // The three finders: 7 × 7 dark frames in the corners.
    for (const auto& [row, column] : {std::pair{0, 0}, {0, matrix->width - 7}, {matrix->width - 7, 0}})
        for (int i = 0; i < 7; ++i)
            EXPECT_TRUE(matrix->dark[static_cast<std::size_t>(row * matrix->width + column + i)]);
}

} // namespace lubberline::test
