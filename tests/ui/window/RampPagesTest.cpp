#include <QUndoStack>
// The pages of the ramp in the window, with stores in memory: signing, bases, instruments, electrical swings, what cannot be
// stored.

#include <QComboBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>

#include "tests/ui/window/Fixture.h"
#include "ui/electrical/ElectricalPage.h"
#include "ui/kit/Words.h"
#include "ui/sites/InstrumentsPage.h"
#include "ui/sites/SitesPage.h"
#include "ui/swing/ReadingText.h"
#include "ui/swing/SigningPanel.h"
#include "ui/swing/SwingEditor.h"
#include "ui/window/Recovery.h"

namespace lubberline::ui {

namespace {

const std::string kToday = "2026-11-23";

template <class Widget>
Widget& in(QWidget& page, const char* name)
{
    auto* widget = page.findChild<Widget*>(QString::fromLatin1(name));
    if (!widget)
        qFatal("there is no widget named %s", name);
    return *widget;
}

void type(QLineEdit& line, const QString& text)
{
    line.setFocus();
    line.selectAll();
    QTest::keyClicks(&line, text);
    QTest::keyClick(&line, Qt::Key_Return);
}

void typeCell(QTableWidget& table, int row, int column, const QString& text)
{
    table.item(row, column)->setText(text);
    QCoreApplication::processEvents();
}

} // namespace

class RampPagesTest : public QObject {
    Q_OBJECT

private slots:
    void twoPeopleSignAndAnAmendmentShowsWhatItChanges()
    {
        SmallFleet fleet;
        const SwingId id = fleet.addSwing("2026-11-20", eightPoints());
        EditContext context{fleet.stores, [](const Error&) {}};
        QUndoStack stack;
        SwingEditor editor(context, stack);
        SigningPanel panel(context, editor);
        panel.QWidget::show();
        QSignalSpy failed(&panel, &SigningPanel::failed), opened(&panel, &SigningPanel::openSwing);
        const auto refresh = [&](SwingId swing) {
            QVERIFY(editor.open(swing));
            panel.show("In limits.");
        };
        refresh(id);
        QVERIFY(!in<QLineEdit>(panel, "signName").isVisible()); // a draft is not signed
        in<QPushButton>(panel, "changeState").click();
        refresh(id);
        QCOMPARE(fleet.stores.swings.record(id)->swing.state, SwingState::Complete);
        type(in<QLineEdit>(panel, "signName"), "Ada");
        type(in<QLineEdit>(panel, "signLicence"), "PL 12");
        refresh(id);
        QCOMPARE(in<QTableWidget>(panel, "signatures").rowCount(), 1);
        QVERIFY(in<QTableWidget>(panel, "signatures").item(0, 4)->text().startsWith("✓"));
        QCOMPARE(in<QComboBox>(panel, "signRole").currentIndex(), 1); // the inspector is next
        type(in<QLineEdit>(panel, "signLicence"), "");
        QCOMPARE(failed.count(), 1); // nobody's name
        in<QLineEdit>(panel, "signName").setText("Ben");
        in<QPushButton>(panel, "signButton").click();
        refresh(id);
        QCOMPARE(fleet.stores.swings.record(id)->swing.state, SwingState::Signed);
        QVERIFY(!in<QPushButton>(panel, "changeState").isVisible());
        in<QPushButton>(panel, "amendButton").click();
        QCOMPARE(failed.count(), 2); // not without a reason
        in<QLineEdit>(panel, "stateReason").setText("the date was wrong");
        in<QPushButton>(panel, "amendButton").click();
        QCOMPARE(opened.count(), 1);
        Swing amended = fleet.stores.swings.record(opened.front().front().value<SwingId>())->swing;
        amended.date = "2026-11-19";
        QVERIFY(fleet.stores.put(amended));
        refresh(amended.id);
        auto& differences = in<QTableWidget>(panel, "differences");
        QCOMPARE(differences.rowCount(), 1);
        QCOMPARE(differences.item(0, 1)->text() + " > " + differences.item(0, 2)->text(), QString("2026-11-20 > 2026-11-19"));
    }

    void aSignatureThatNoLongerHoldsIsSaid()
    {
        SmallFleet fleet;
        const SwingId id = fleet.addSwing("2026-11-20", eightPoints());
        QVERIFY(fleet.stores.signing.complete(id) && fleet.stores.signing.sign(id, {SignatureRole::Performer, "Ada", "", "", ""}));
        QVERIFY(fleet.stores.signing.reopen(id, "misread"));
        const auto before = fleet.stores.swings.record(id)->swing.readings[0];
        Reading after = before;
        after.compass = CompassHeading::fromDegrees(2);
        QVERIFY(fleet.stores.swings.changeReading(id, before, after));
        EditContext context{fleet.stores, [](const Error&) {}};
        QUndoStack stack;
        SwingEditor editor(context, stack);
        QVERIFY(editor.open(id));
        SigningPanel panel(context, editor);
        panel.show({});
        QVERIFY(in<QTableWidget>(panel, "signatures").item(0, 4)->text().startsWith("✗"));
    }

    /// A line painted for 4.0° E where it is 6.9° E today: ψ marked lies on ψ + 4 true, and so on ψ − 2.9 magnetic.
    void aBaseTellsItsStateAndItsLines()
    {
        SmallFleet fleet;
        QUndoStack stack;
        EditContext context{fleet.stores, [](const Error&) {}};
        SitesPage page(context, stack, [] { return kToday; });
        page.show();
        page.reload();
        in<QPushButton>(page, "newSite").click();
        type(in<QLineEdit>(page, "siteName"), "Rose 2");
        type(in<QLineEdit>(page, "siteLatitude"), "53.1 N");
        type(in<QLineEdit>(page, "siteLongitude"), "17.98 E");
        type(in<QLineEdit>(page, "sitePainted"), "4");
        type(in<QLineEdit>(page, "siteExpiry"), "2026-11-22");
        const Site site = fleet.stores.sites.sites()->front();
        QCOMPARE(site.name, std::string("Rose 2"));
        QCOMPARE(*site.paintedVariation_deg, 4.0);
        QVERIFY(in<QLabel>(page, "siteFitness").text().startsWith("▲"));
        in<QPushButton>(page, "siteModel").click();
        const double variation = *fleet.stores.sites.sites()->front().variation_deg;
        QVERIFY(variation > 5 && variation < 8);
        const QString lines = in<QLabel>(page, "siteLines").text();
        QVERIFY2(lines.contains(signedNumber(4.0 - variation, 2)), qPrintable(lines)); // to be added: less than nothing
        type(in<QLineEdit>(page, "siteExpiry"), "2026-11-23");                         // on the day itself it holds
        QVERIFY(in<QLabel>(page, "siteFitness").text().startsWith("●"));
        stack.undo();
        QCOMPARE(fleet.stores.sites.sites()->front().certificateExpiry, std::string("2026-11-22"));
    }

    void aSurveyIsTypedAndSummed()
    {
        SmallFleet fleet;
        QUndoStack stack;
        EditContext context{fleet.stores, [](const Error&) {}};
        SitesPage page(context, stack, [] { return kToday; });
        page.show();
        page.reload();
        in<QPushButton>(page, "newSite").click();
        auto& table = in<QTableWidget>(page, "surveyTable");
        const std::array<std::array<const char*, 3>, 3> rows{{{"0", "0", "6.20"}, {"10", "0", "6.28"}, {"0", "10", "6.12"}}};
        for (int row = 0; row < 3; ++row) {
            typeCell(table, row, 0, rows[static_cast<std::size_t>(row)][0]);
            typeCell(table, row, 1, rows[static_cast<std::size_t>(row)][1]);
            QVERIFY(in<QLabel>(page, "surveySummary").text().contains("not stored yet"));
            typeCell(table, row, 3, rows[static_cast<std::size_t>(row)][2]);
        }
        QCOMPARE(fleet.stores.sites.sites()->front().survey.size(), 3u);
        const QString summary = in<QLabel>(page, "surveySummary").text();
        QVERIFY2(summary.contains("mean 6.200°") && summary.contains("range 9.6′") && summary.contains("class 1"), qPrintable(summary));
        typeCell(table, 1, 3, "abc");
        QVERIFY(in<QLabel>(page, "surveySummary").text().contains("'abc'"));
        QCOMPARE(*fleet.stores.sites.sites()->front().survey[1].declination_deg, 6.28);
    }

    void anInstrumentShowsWhatItsSettingMeans()
    {
        DatumInstrument sight;
        QVERIFY(datumExample(sight).contains("heads 358.0"));
        sight.ahead = SightingDirection::Reciprocal;
        QVERIFY(datumExample(sight).contains("heads 178.0"));
        sight.zero_deg = 0.5;
        QVERIFY(datumExample(sight).contains("heads 178.5"));
        DatumInstrument gps;
        gps.kind = DatumKind::Inertial;
        gps.givesTrue = true;
        QVERIFY2(datumExample(gps).contains("heads 352.0"), qPrintable(datumExample(gps))); // true less 6° east

        SmallFleet fleet;
        InstrumentsPage page(fleet.stores, [] { return kToday; });
        page.show();
        page.reload();
        in<QPushButton>(page, "newInstrument").click();
        type(in<QLineEdit>(page, "instrumentName"), "B-16");
        type(in<QLineEdit>(page, "instrumentDue"), "2026-11-22");
        QCOMPARE(fleet.stores.sites.instruments()->front().name, std::string("B-16"));
        QVERIFY(in<QLabel>(page, "instrumentState").text().contains("2026-11-22"));
        in<QPushButton>(page, "removeInstrument").click();
        QVERIFY(fleet.stores.sites.instruments()->empty());
    }

    /// TM 11-4920-292-15, p. 190: at 180 half of the error out, 180.6 → 180.3; at 270 half, 269.3 → 269.65.
    void theElectricalSwingsSteps()
    {
        FourPointTable table;
        table.indicated_deg = {0.2, 90.4, 180.6, 269.3};
        const QStringList steps = electricalSteps(table);
        QVERIFY(steps[0].contains("180.60 → 180.30"));
        QVERIFY(steps[1].contains("90.40 → 90.00"));
        QVERIFY(steps[2].contains("269.30 → 269.65"));

        SmallFleet fleet;
        ElectricalPage page(fleet.stores, [] { return kToday; });
        page.show();
        QVERIFY(page.showCompass(fleet.compass));
        in<QPushButton>(page, "newElectrical").click();
        auto& sheet = in<QTableWidget>(page, "tableF1");
        const char* after[] = {"0.3", "90.1", "180.4", "270.4"};
        for (int row = 0; row < 4; ++row)
            typeCell(sheet, row, 2, after[row]);
        const auto stored = fleet.stores.electrical.of(fleet.compass)->front();
        QCOMPARE(*stored.after.indicated_deg[3], 270.4);
        const QString verdict = in<QLabel>(page, "electricalVerdict").text();
        QVERIFY2(verdict.contains("do NOT agree"), qPrintable(verdict)); // 90/270 differ by 0.3
        auto& headings = in<QTableWidget>(page, "electricalHeadings");
        typeCell(headings, 1, 0, "15.5");
        QCOMPARE(headings.item(1, 1)->text(), QString("+0.50"));
        typeCell(headings, 2, 0, "x");
        QVERIFY(!fleet.stores.electrical.of(fleet.compass)->front().headings[2].indicated_deg);
        typeCell(headings, 0, 0, "359.8"), typeCell(headings, 6, 0, "90.2"), typeCell(headings, 12, 0, "180.1");
        QSignalSpy made(&page, &ElectricalPage::makeSwing);
        in<QPushButton>(page, "electricalAsSwing").click();
        QCOMPARE(made.count(), 1);
        const Swing swing = made.front().front().value<Swing>();
        QCOMPARE(swing.readings.size(), 4u);
        QCOMPARE(deviationOf(*swing.readings[1].magnetic, *swing.readings[1].compass).degrees(), -0.5); // error +0.5
    }

    void whatAFullDriveRefusesIsKeptAndPutInLater()
    {
        QTemporaryDir folder;
        SmallFleet fleet;
        const SwingRecord record = *fleet.stores.swings.record(fleet.addSwing("2026-11-20", eightPoints()));
        // The first place cannot be written: a file stands where its folder should be.
        QFile blocked(folder.filePath("blocked"));
        QVERIFY(blocked.open(QIODevice::WriteOnly));
        const Recovery recovery({folder.filePath("blocked/a.jsonl"), folder.filePath("b.jsonl")});
        Reading wanted = record.swing.readings[2];
        wanted.compass = CompassHeading::fromDegrees(92.5);
        wanted.note = "typed while the drive was full";
        const LostEntry lost{fleet.stores.location().toStdString(), record.swing.id, record.swing.record, "3713", LostReading{2, wanted}};
        QVERIFY(recovery.keep(lost));
        QVERIFY(recovery.keep({"another.lubberline", record.swing.id, record.swing.record, "x", LostReading{0, wanted}}));
        QCOMPARE(recovery.entriesFor(fleet.stores.location()).size(), 1u);
        fleet.stores.watch().refuseWrites = true;
        auto restored = recovery.restore(fleet.stores);
        QCOMPARE(restored.done, 0);
        QCOMPARE(restored.failures.size(), 1);
        QCOMPARE(recovery.entriesFor(fleet.stores.location()).size(), 1u); // it stays
        fleet.stores.watch().refuseWrites = false;
        restored = recovery.restore(fleet.stores);
        QCOMPARE(restored.done, 1);
        QCOMPARE(fleet.stores.swings.record(record.swing.id)->swing.readings[2].compass->degrees(), 92.5);
        QVERIFY(recovery.entriesFor(fleet.stores.location()).empty());
        QCOMPARE(recovery.entriesFor("another.lubberline").size(), 1u);
    }

    void theWindowKeepsWhatItCannotStoreAndOffersIt()
    {
        SmallFleet fleet;
        QTemporaryDir folder;
        AnsweringDialogs dialogs;
        QSettings settings(folder.filePath("settings.ini"), QSettings::IniFormat);
        const QString file = folder.filePath("recovery.jsonl");
        {
            MainWindow window(fleet.stores, {dialogs, settings, {}, {}, {file}});
            window.show();
            QCoreApplication::processEvents();
            window.go(fleet.swing);
            fleet.stores.watch().refuseWrites = true;
            auto* page = window.findChild<SwingPage*>();
            Reading typed;
            typed.magnetic = MagneticHeading::fromDegrees(45);
            QVERIFY(!page->editor().insertReadings(0, {typed}, "reading"));
            QVERIFY(QFile::exists(file));
        }
        fleet.stores.watch().refuseWrites = false;
        MainWindow window(fleet.stores, {dialogs, settings, {}, {}, {file}});
        window.show();
        QCoreApplication::processEvents();
        QCoreApplication::processEvents();
        QPushButton* answer = nullptr;
        for (auto* button : window.findChildren<QPushButton*>())
            if (button->text() == "Put them in")
                answer = button;
        QVERIFY(answer);
        answer->click();
        QCOMPARE(fleet.stores.swings.record(fleet.swing)->swing.readings.size(), 1u);
        QVERIFY(!QFile::exists(file));
    }

    void aTrueHeadingIsTypedWithItsLetter()
    {
        Reading reading;
        QVERIFY(!applyTyped(reading, ReadingColumn::Magnetic, "274T")); // the swing states no variation
        QVERIFY(applyTyped(reading, ReadingColumn::Magnetic, "4.5T", 6.0));
        QCOMPARE(reading.trueHeading->degrees(), 4.5);
        QCOMPARE(reading.magnetic->degrees(), 358.5); // magnetic = true − variation, east positive
        QVERIFY(applyTyped(reading, ReadingColumn::Magnetic, "359", 6.0));
        QVERIFY(!reading.trueHeading);
        QVERIFY(!applyTyped(reading, ReadingColumn::Magnetic, "T", 6.0));
    }

    void aSecondWriterOfTheSameReadingIsTold()
    {
        SmallFleet fleet;
        const SwingId id = fleet.addSwing("2026-11-20", eightPoints());
        OpenWindow open(fleet.stores);
        open.window.go(id);
        auto& editor = open.window.findChild<SwingPage*>()->editor();
        Reading mine = editor.readings()[0];
        Reading theirs = mine;
        theirs.compass = CompassHeading::fromDegrees(300);
        QVERIFY(fleet.stores.another()->swings.changeReading(id, mine, theirs));
        mine.compass = CompassHeading::fromDegrees(310);
        QVERIFY(!editor.changeReading(0, mine, "compass"));
        QVERIFY(open.window.messages().messages().join(' ').contains("changed elsewhere"));
        QCOMPARE(editor.readings()[0].compass->degrees(), 300.0); // theirs is shown
    }
};

} // namespace lubberline::ui

QTEST_MAIN(lubberline::ui::RampPagesTest)
#include "RampPagesTest.moc"
