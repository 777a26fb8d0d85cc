#include <gtest/gtest.h>

#include <QDir>
#include <QPageSize>
#include <QPrinter>
#include <QRegularExpression>

#include "tests/ui/report/page/PdfProbe.h"
#include "tests/ui/report/swing/SampleSwings.h"
#include "ui/report/card/CardPlacard.h"
#include "ui/report/card/CardWords.h"
#include "ui/report/page/DataHash.h"
#include "ui/report/page/DocumentFont.h"
#include "ui/report/page/Page.h"

namespace lubberline::test {

namespace {

/// FOR and STEER as they stand on the placard: rows of three-digit figures, left half beside right half.
std::vector<std::vector<int>> figuresOn(const QString& page)
{
    std::vector<std::vector<int>> rows;
    const QRegularExpression row("^[ ]*((?:\\d{3}[ ]+)+\\d{3})[ ]*$", QRegularExpression::MultilineOption);
    const QString bare = QString(page).remove(QRegularExpression("[*!]")); // the marks of rows
    for (auto match = row.globalMatch(bare); match.hasNext();) {
        std::vector<int> figures;
        for (const QString& figure : match.next().captured(1).split(QRegularExpression("\\s+")))
            figures.push_back(figure.toInt());
        rows.push_back(figures);
    }
    return rows;
}

SwingRecord signedRecord(SwingRecord record)
{
    record.swing.state = SwingState::Signed;
    record.swing.signatures = {{SignatureRole::Performer, "Ada", "PL 12", "2026-11-21T11:00:00Z", std::string(64, 'a'), 2},
        {SignatureRole::Inspector, "Ben", "PL 7", "2026-11-22T11:00:00Z", std::string(64, 'a'), 2}};
    return record;
}

CardOptions worksheetOptions()
{
    CardOptions options;
    options.step_deg = 45;
    options.source = CardSource::Readings;
    options.removed.set(indexOf(Coefficient::A));
    return options;
}

} // namespace

class WorksheetCard : public testing::TestWithParam<int> {};

TEST_P(WorksheetCard, hasTheSheetsSteerFigures)
{
    const WorksheetSwing& swing = kWorksheet[static_cast<std::size_t>(GetParam())];
    const QStringList pages = PdfProbe(cardOf(worksheetRecord(swing), worksheetOptions())).pages();
    ASSERT_EQ(pages.size(), 1);
    const auto rows = figuresOn(pages.first());
    ASSERT_EQ(rows.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        const int left = 45 * static_cast<int>(i), right = left + 180;
        EXPECT_EQ(rows[i], (std::vector<int>{left, swing.steer_deg[i], right, swing.steer_deg[i + 4]}));
    }
}

INSTANTIATE_TEST_SUITE_P(Questions, WorksheetCard, testing::Range(0, 3));

TEST(Card, tellsWhoseItIsAndHowToUseIt)
{
    const auto input = cardOf(signedRecord(simulatedRecord(12)), {});
    const QString text = PdfProbe(input).flowingText();
    for (const char* words : {"SP-XYZ", "STANDBY COMPASS · S/N 20117", "2026-11-20", "Swung at Compass base 2, Dęblin",
             "ENGINES RUNNING, 1500 RPM · RADIO ON", "Steer this by compass to make good FOR (magnetic)",
             "Deviation = magnetic − compass, E +", "Performed Ada · PL 12 · 2026-11-21", "Inspected Ben", "Record 0f3c1d52", "FOR",
             "STEER", "By the exact fit, 95 % band ±", "Next swing due ____"})
        EXPECT_TRUE(text.contains(QString::fromUtf8(words))) << words;
    EXPECT_TRUE(text.contains("data " + ui::dataHash(input.record()).left(8)));
    EXPECT_FALSE(text.contains("DRAFT"));
}

TEST(Card, namesTheLargestResidualWithItsHeading)
{
    const auto input = cardOf(simulatedRecord(12), {});
    const CardRow* largest = &input.columns[0].card.rows[0];
    for (const CardRow& row : input.columns[0].card.rows)
        if (std::abs(row.residual.degrees()) > std::abs(largest->residual.degrees()))
            largest = &row;
    EXPECT_NEAR(toDegrees(input.columns[0].card.residualMaxAbs_rad), std::abs(largest->residual.degrees()), 1e-9);
    const QString words = QString::fromUtf8("Largest residual %1%2° on %3 magnetic; largest reading")
                              .arg(largest->residual.degrees() < 0 ? QString::fromUtf8("−") : QString("+"))
                              .arg(std::abs(largest->residual.degrees()), 0, 'f', 1)
                              .arg(qRound(largest->magnetic.degrees()), 3, 10, QChar('0'));
    EXPECT_TRUE(PdfProbe(input).flowingText().contains(words)) << words.toStdString();
}

TEST(Card, twoColumnsStandSideBySideAndTheRadioIsLeftToThem)
{
    auto input = cardOf(signedRecord(simulatedRecord(12)), {}, "RADIO ON");
    input.columns.push_back(cardOf(signedRecord(simulatedRecord(12, -3)), {}, "RADIO OFF").columns.front());
    const QString page = PdfProbe(input).pages().first();
    const auto rows = figuresOn(page);
    ASSERT_EQ(rows.size(), 6u);
    for (std::size_t i = 0; i < 6; ++i) {
        const auto steer = [&](std::size_t column, std::size_t row) { return input.columns[column].card.rows[row].steerRounded_deg(); };
        EXPECT_EQ(rows[i],
            (std::vector<int>{
                30 * static_cast<int>(i), steer(0, i), steer(1, i), 30 * static_cast<int>(i) + 180, steer(0, i + 6), steer(1, i + 6)}));
    }
    EXPECT_FALSE(page.contains(QString::fromUtf8("1500 RPM · RADIO ON")));
    EXPECT_TRUE(page.contains("RADIO OFF"));
    EXPECT_FALSE(page.contains("DRAFT"));
    EXPECT_EQ(page.count("STEER"), 2 + 1); // over both columns of each half, and once in "STEER = FOR − deviation"
}

/// A signature never stands over figures that nobody signed: each column has its own record, hash and state.
TEST(Card, aColumnThatNobodySignedIsADraftBesideOneThatIs)
{
    auto input = cardOf(signedRecord(simulatedRecord(12)), {}, "RADIO ON");
    SwingRecord draft = simulatedRecord(12, -3);
    draft.swing.record = "7b20cafe-77b1-5a90-8c55-6d2c6f2a9d10";
    for (const SwingState state : {SwingState::Draft, SwingState::Complete}) {
        draft.swing.state = state;
        auto both = input;
        both.columns.push_back(cardOf(draft, {}, "RADIO OFF").columns.front());
        const QString text = PdfProbe(both).flowingText();
        const QString mark = state == SwingState::Draft ? "DRAFT" : "NOT SIGNED",
                      banner = state == SwingState::Draft ? QString::fromUtf8("DRAFT — NOT SIGNED") : mark;
        EXPECT_GE(text.count("RADIO OFF: " + banner), 2); // on the card, and on the page
        EXPECT_EQ(text.contains("DRAFT"), state == SwingState::Draft);
        EXPECT_TRUE(text.contains(
            "RADIO ON: Record 0f3c1d52 · data " + ui::dataHash(both.columns[0].record).left(8) + QString::fromUtf8(" · signed")));
        EXPECT_TRUE(text.contains(
            "RADIO OFF: Record 7b20cafe · data " + ui::dataHash(both.columns[1].record).left(8) + QString::fromUtf8(" · ") + mark));
        for (const auto& column : both.columns)
            EXPECT_TRUE(text.contains(ui::dataHash(column.record))); // whole, on the page
        EXPECT_GE(text.count(mark), 2 + 1 + 4);                      // the bars over and under its figures in both halves
    }
}

TEST(Card, aCompassOutOfItsLimitsIsSaidAcrossItSignedOrNot)
{
    SwingRecord record = signedRecord(simulatedRecord(12));
    record.limits->maxDeviation_deg = 1;
    const auto over = cardOf(record, {});
    ASSERT_TRUE(over.columns[0].outOfLimits());
    const QString text = PdfProbe(over).flowingText();
    EXPECT_GE(text.count("OUT OF LIMITS"), 2 + 2); // the banners of card and page, the bars over and under the figures
    EXPECT_FALSE(text.contains("NOT SIGNED"));
    record.limits->maxDeviation_deg = 45;
    const auto within = cardOf(record, {});
    EXPECT_FALSE(within.columns[0].outOfLimits());
    EXPECT_FALSE(PdfProbe(within).flowingText().contains("OUT OF LIMITS"));
    const QString family = ui::documentFamily().value();
    EXPECT_GT(ui::placardSize(over, family).height(), ui::placardSize(within, family).height() + 2); // room for the bars
}

TEST(Card, whatIsNotWhatWasSignedIsADraft)
{
    const SwingRecord record = signedRecord(simulatedRecord(12));
    auto changed = cardOf(record, {});
    changed.columns[0].holds = false;
    auto without = cardOf(record, {30, CardSource::Fit, CoefficientSet(1)});
    auto amended = cardOf(record, {});
    amended.columns[0].superseded = true;
    const QString changedText = PdfProbe(changed).flowingText(), withoutText = PdfProbe(without).flowingText();
    EXPECT_TRUE(changedText.contains("the record is not what was signed") && changedText.contains("DRAFT"));
    EXPECT_TRUE(withoutText.contains("figures without A, which was taken out after what was signed") && withoutText.contains("DRAFT"));
    for (const QString& text : {changedText, withoutText})
        EXPECT_FALSE(text.contains("Performed Ada"));
    EXPECT_TRUE(PdfProbe(amended).flowingText().contains("AMENDED SINCE: NOT VALID"));
}

TEST(Card, saysHowItsRowsAreToBeTaken)
{
    SwingRecord record = signedRecord(simulatedRecord(12));
    record.limits->maxDeviation_deg = 1;
    record.swing.readings.resize(8); // 000 to 210
    for (auto& reading : record.swing.readings)
        reading.pitch_deg = 9, reading.roll_deg = 0;
    const QString text = PdfProbe(cardOf(record, {})).flowingText();
    for (const char* words : {"! OVER THE LIMIT of 1°", "* nobody read between (compass) 2", "NOT LEVEL: pitch +9°",
             "nobody read near these rows: 240°, 270°, 300°, 330°"})
        EXPECT_TRUE(text.contains(QString::fromUtf8(words))) << words << text.toStdString();
    EXPECT_FALSE(text.contains("level flight in"));
    EXPECT_TRUE(QRegularExpression("\\d{3} ?\\*").match(text).hasMatch());
}

TEST(Card, byCompassAndInFineStepsItStaysOnItsPage)
{
    for (const int step : {10, 15}) {
        CardOptions options;
        options.step_deg = step;
        options.by = CardBy::Compass;
        const auto input = cardOf(signedRecord(simulatedRecord(24)), options);
        const QString page = PdfProbe(input).pages().first();
        const auto rows = figuresOn(page);
        ASSERT_EQ(rows.size(), static_cast<std::size_t>(180 / step));
        for (std::size_t i = 0; i < rows.size(); ++i)
            EXPECT_EQ(rows[i],
                (std::vector<int>{step * static_cast<int>(i), input.columns[0].card.rows[i].magneticRounded_deg(),
                    step * static_cast<int>(i) + 180, input.columns[0].card.rows[i + rows.size()].magneticRounded_deg()}));
        EXPECT_TRUE(page.contains("COMPASS") && page.contains("MAGNETIC"));
    }
}

TEST(Card, isThePlacardsSizeAndInsideThePage)
{
    const auto thirty = cardOf(simulatedRecord(12), {});
    const QString family = ui::documentFamily().value();
    const QSizeF size = ui::placardSize(thirty, family);
    EXPECT_DOUBLE_EQ(size.width(), ui::mm(60));
    EXPECT_NEAR(size.height(), ui::mm(92), ui::mm(8));
    auto two = thirty;
    two.columns.push_back(two.columns.front());
    EXPECT_GT(ui::placardSize(two, family).width(), size.width());
    CardOptions fine;
    fine.step_deg = 10;
    EXPECT_GT(ui::placardSize(cardOf(simulatedRecord(24), fine), family).height(), size.height());
}

TEST(Card, northIsThreeNoughts)
{
    EXPECT_EQ(ui::threeDigits(0), "000");
    EXPECT_EQ(ui::threeDigits(360), "000");
    EXPECT_EQ(ui::threeDigits(7), "007");
    EXPECT_EQ(ui::threeDigits(359), "359");
}

TEST(Card, marksDemonstrationAndDraft)
{
    SwingRecord record = simulatedRecord(12);
    record.aircraft.demonstration = true;
    record.swing.state = SwingState::Draft;
    const QString text = PdfProbe(cardOf(record, {})).text();
    EXPECT_EQ(text.count("DEMONSTRATION DATA"), 2); // on the card that is cut out, and on the page
    EXPECT_EQ(text.count(QString::fromUtf8("DRAFT — NOT SIGNED")), 2);
}

TEST(Card, longParticularsStayReadableOnOnePage)
{
    SwingRecord record = simulatedRecord(12);
    record.compass.name = "standby magnetic compass on the windscreen centre post, pilot's side";
    record.swing.configuration.electrics
        = "all normal loads on, pitot heat on, windscreen heat off, wipers off, landing lights off, strobe lights on, "
          "both generators on line, transponder on standby, weather radar off, intercom on";
    const QStringList pages = PdfProbe(cardOf(record, {})).pages();
    ASSERT_EQ(pages.size(), 1);
    EXPECT_EQ(figuresOn(pages.first()).size(), 6u);
}

TEST(Card, saysWhatWasTakenOut)
{
    const QString text = PdfProbe(cardOf(worksheetRecord(kWorksheet[0]), worksheetOptions())).flowingText();
    EXPECT_TRUE(text.contains("A taken out mechanically"));
    EXPECT_TRUE(text.contains("reading nearest to each heading"));
}

TEST(Card, refusesColumnsThatDoNotMatch)
{
    const QTemporaryDir folder;
    const auto codeFor = [&folder](const ui::CardInput& input) { return ui::writeCard(input, folder.filePath("card.pdf")).error().code; };
    auto input = cardOf(worksheetRecord(kWorksheet[0]), {});
    auto mixed = input;
    mixed.columns.push_back(cardOf(worksheetRecord(kWorksheet[0]), worksheetOptions()).columns.front()); // 30° beside 45°
    EXPECT_EQ(codeFor(mixed), ErrorCode::InvalidInput);
    auto other = input;
    other.columns.push_back(cardOf(worksheetRecord(kWorksheet[0]), {}, "RADIO OFF").columns.front());
    EXPECT_TRUE(ui::writeCard(other, folder.filePath("both.pdf")));
    QFile::remove(folder.filePath("both.pdf"));
    other.columns[1].record.compass.name = "No. 2";
    EXPECT_EQ(codeFor(other), ErrorCode::InvalidInput);
    auto twice = input;
    twice.columns.push_back(input.columns.front());
    EXPECT_EQ(codeFor(twice), ErrorCode::InvalidInput); // two columns of one name
    auto none = input;
    none.columns.clear();
    EXPECT_EQ(codeFor(none), ErrorCode::InvalidInput);
    auto three = input;
    three.columns.resize(3, input.columns.front());
    EXPECT_EQ(codeFor(three), ErrorCode::InvalidInput);
    auto empty = input;
    empty.columns.front().card.rows.clear();
    EXPECT_EQ(codeFor(empty), ErrorCode::InvalidInput);
    EXPECT_TRUE(QDir(folder.path()).isEmpty());
}

TEST(Card, refusesOtherEndingsAndMissingFolders)
{
    const QTemporaryDir folder;
    const auto input = cardOf(simulatedRecord(12), {});
    EXPECT_EQ(ui::writeCard(input, folder.filePath("card.html")).error().code, ErrorCode::InvalidInput);
    const auto missing = ui::writeCard(input, folder.filePath("none/card.pdf"));
    ASSERT_FALSE(missing.ok());
    EXPECT_EQ(missing.error().code, ErrorCode::Io);
    EXPECT_NE(missing.error().message.english().find(folder.filePath("none").toStdString()), std::string::npos);
}

TEST(Card, printersGetItAtItsTrueSize)
{
    const auto input = cardOf(simulatedRecord(12), {});
    QTemporaryDir folder;
    QPrinter printer(QPrinter::HighResolution);
    printer.setOutputFormat(QPrinter::PdfFormat);
    printer.setOutputFileName(folder.filePath("printed.pdf"));
    printer.setPageSize(QPageSize(QPageSize::A4));
    ASSERT_TRUE(ui::printCard(input, printer).ok());
    const auto box = [](const QString& path) { // of the words of the page, in points
        const QString xml = QString::fromUtf8(outputOf("pdftotext", {"-bbox", path, "-"}));
        const auto match = QRegularExpression("xMin=\"([0-9.]+)\" yMin=\"([0-9.]+)\"[^>]*>STEER<").match(xml);
        return QPointF(match.captured(1).toDouble(), match.captured(2).toDouble());
    };
    const QPointF printed = box(folder.filePath("printed.pdf")), written = box(PdfProbe(input).path());
    EXPECT_GT(written.x(), 0);
    EXPECT_NEAR(printed.x(), written.x(), 0.5);
    EXPECT_NEAR(printed.y(), written.y(), 0.5);
}

} // namespace lubberline::test
