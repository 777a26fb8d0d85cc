// Compass bases and datum instruments: what is typed, and what it is told to mean.

#include <QClipboard>
#include <QPushButton>
#include <QTableWidget>
#include <QUndoStack>

#include "tests/ui/window/Fixture.h"
#include "tests/ui/window/Typing.h"
#include "ui/kit/Words.h"
#include "ui/sites/InstrumentsPage.h"
#include "ui/sites/SitesPage.h"

namespace lubberline::ui {

class SitesPagesTest : public QObject {
    Q_OBJECT

private slots:
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
        QVERIFY(!lines.contains("in doubt"));
        type(in<QLineEdit>(page, "siteVariation"), QString::number(variation + 1.2, 'f', 2)); // by an old chart
        QVERIFY2(
            in<QLabel>(page, "siteLines").text().contains("VARIATION in doubt, by 1.2°"), qPrintable(in<QLabel>(page, "siteLines").text()));
        type(in<QLineEdit>(page, "siteVariation"), QString::number(variation, 'f', 2));
        type(in<QLineEdit>(page, "siteExpiry"), "2026-11-23"); // on the day itself it holds
        QVERIFY(in<QLabel>(page, "siteFitness").text().startsWith("●"));
        stack.undo();
        QCOMPARE(fleet.stores.sites.sites()->front().certificateExpiry, Date("2026-11-22"));
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
        // Another survey beside the first is not added in silence.
        QApplication::clipboard()->setText("20\t0\t\t6.21\n0\t20\t\t6.19\n");
        table.setFocus();
        QTest::keySequence(&table, QKeySequence::Paste);
        QCOMPARE(fleet.stores.sites.sites()->front().survey.size(), 5u);
        QVERIFY2(page.message().contains("2 points were added to the 3"), qPrintable(page.message()));
        stack.undo();
        QCOMPARE(fleet.stores.sites.sites()->front().survey.size(), 3u);
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
        QUndoStack stack;
        EditContext context{fleet.stores, [](const Error&) {}};
        InstrumentsPage page(context, stack, [] { return kToday; });
        page.show();
        page.reload();
        in<QPushButton>(page, "newInstrument").click();
        type(in<QLineEdit>(page, "instrumentName"), "B-16");
        type(in<QLineEdit>(page, "instrumentDue"), "2026-11-22");
        QCOMPARE(fleet.stores.sites.instruments()->front().name, std::string("B-16"));
        QVERIFY(in<QLabel>(page, "instrumentState").text().contains("2026-11-22"));
        in<QPushButton>(page, "removeInstrument").click();
        QVERIFY(fleet.stores.sites.instruments()->empty());
        stack.undo(); // the removal
        QCOMPARE(fleet.stores.sites.instruments()->front().name, std::string("B-16"));
        QCOMPARE(in<QLineEdit>(page, "instrumentDue").text(), QString("2026-11-22")); // the page shows it again
        stack.undo();
        QCOMPARE(fleet.stores.sites.instruments()->front().calibrationDue, Date());
        stack.undo();
        stack.undo(); // its name, and that it was made
        QVERIFY(fleet.stores.sites.instruments()->empty());
        while (stack.canRedo())
            stack.redo();
        QVERIFY(fleet.stores.sites.instruments()->empty()); // made, named, dated, removed
    }

    void aNewBaseIsUndoneAndItsChangesFindItAgain()
    {
        SmallFleet fleet;
        QUndoStack stack;
        QStringList faults;
        EditContext context{fleet.stores, [&faults](const Error& error) { faults += messageOf(error); }};
        SitesPage page(context, stack, [] { return kToday; });
        page.show();
        page.reload();
        in<QPushButton>(page, "newSite").click();
        type(in<QLineEdit>(page, "siteName"), "Rose 3");
        while (stack.canUndo())
            stack.undo();
        QVERIFY(fleet.stores.sites.sites()->empty());
        Site other;
        other.name = "made meanwhile"; // takes the id that the base had
        QVERIFY(fleet.stores.sites.add(other));
        while (stack.canRedo())
            stack.redo();
        const auto sites = fleet.stores.sites.sites();
        QCOMPARE(sites->size(), 2u);
        QCOMPARE((*sites)[0].name, std::string("Rose 3"));
        QCOMPARE((*sites)[1].name, std::string("made meanwhile"));
        // A base where aircraft stand is not taken away: the edit says so and stays out of the way.
        Swing swing;
        swing.compass = fleet.compass;
        swing.site = (*sites)[0].id;
        swing.date = kToday;
        QVERIFY(fleet.stores.swings.add(swing));
        stack.undo();
        stack.undo();
        QCOMPARE(faults.size(), 1);
        QCOMPARE(fleet.stores.sites.sites()->size(), 2u);
    }
};

} // namespace lubberline::ui

QTEST_MAIN(lubberline::ui::SitesPagesTest)
#include "SitesPagesTest.moc"
