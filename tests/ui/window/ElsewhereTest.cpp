// Another window or program changes, removes or goes on with what is shown here, while something is half typed, about to be signed, or asked
// for in a dialog: nothing reaches another record than the one that was seen, and what is seen is what is stored.

#include <QDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPointer>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTableWidget>

#include "db/transfer/Removal.h"
#include "tests/ui/window/TwoAircraft.h"
#include "ui/guided/GuidedPage.h"
#include "ui/window/PageStack.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

QString front(OpenWindow& open) { return open.window.findChild<PageStack*>()->description()->id; }

/// As the window does when it sees that another connection has stored something.
void look(TwoAircraft& two)
{
    two.fleet.stores.changes().announceAll();
    QApplication::processEvents();
}

} // namespace

class ElsewhereTest : public QObject {
    Q_OBJECT

private slots:
    void aGuidedSwingGoesOnAsItStandsThere();
    void figuresThatAreTypedElsewhereAreNoNews();
    void aCellThatIsBeingTypedStaysAsTyped();
    void aSwingIsSignedAsItWasSeen();
    void anExclusionIsOfItsReading();
    void aCellOfTheEventsStaysWithItsEvent();
    void aFieldOfACompassIsNotOfTheNext();
    void aRefusedTextStaysWithItsRecord();
    void aPlotIsOfTheSwingThatItWasAskedOf();
    void anAircraftThatIsRemovedIsLeft();
    void aSurveyIsStoredWithItsBase();
};

void ElsewhereTest::aGuidedSwingGoesOnAsItStandsThere()
{
    TwoAircraft two;
    OpenWindow open(two.fleet.stores);
    open.window.go(two.fleet.compass);
    open.trigger("guidedSwing");
    auto& page = dynamic_cast<GuidedPage&>(open.window.findChild<PageStack*>()->current());
    page.findChild<QPlainTextEdit*>("guidedChecklist")->clear();
    page.findChild<QPushButton*>("beginGuided")->click();
    page.findChild<QPushButton*>("prepared")->click();
    QCOMPARE(page.job().state().phase, JobPhase::Stations);
    const SwingId swing = page.swing();
    const int at = page.job().state().current;
    const double nominal = page.job().station()->station.nominal_deg;
    page.findChild<QLineEdit*>("guidedDatum")->setText("44.5");

    const auto program = two.fleet.stores.another();
    const std::size_t steps = page.job().job().events.size();
    QVERIFY(program->jobs.append(
        swing, steps, {"2026-11-23T09:00:00Z", job::ReadingTaken{at, {{nominal}, {}, {nominal}}, nominal, nominal, {}}}));
    QTRY_COMPARE(page.job().job().events.size(), steps + 1);
    QVERIFY(page.findChild<QLineEdit*>("guidedDatum")->text().isEmpty());
    QVERIFY2(open.window.messages().shown().contains("44.5"), qPrintable(open.window.messages().shown()));
    // The next figure is of the step at which it stands, and is stored.
    const auto next = page.job().station()->station.nominal_deg;
    QVERIFY(page.job().tell(job::ReadingTaken{page.job().state().current, {{next}, {}, {next}}, next, next, {}}));
    QCOMPARE(program->jobs.jobOf(swing)->value().job.events.size(), steps + 2);

    QVERIFY(program->jobs.abandon(swing));
    QTRY_COMPARE(front(open), QStringLiteral("swing"));
    QCOMPARE(open.window.findChild<SwingPage*>()->editor().id(), swing);
}

void ElsewhereTest::figuresThatAreTypedElsewhereAreNoNews()
{
    TwoAircraft two;
    auto& stores = two.fleet.stores;
    Swing particulars;
    particulars.compass = two.fleet.compass;
    particulars.date = "2026-11-23";
    SwingJob job;
    job.datum.name = "B-16";
    const auto swing = stores.jobs.start(particulars, job);
    QVERIFY(swing);
    const auto program = stores.another();
    QVERIFY(!*stores.changedElsewhere());
    QVERIFY(program->jobs.keepTyped(*swing, 0, {{"guidedDatum", "4"}}));
    QVERIFY(!*stores.changedElsewhere());
    QVERIFY(program->jobs.append(*swing, 0, {"2026-11-23T09:00:00Z", job::Prepared{}}));
    QVERIFY(*stores.changedElsewhere());
    QVERIFY(!*stores.changedElsewhere());
    QVERIFY(program->jobs.abandon(*swing));
    QVERIFY(*stores.changedElsewhere());
}

/// 358.5 typed while another program stores another row: "35" was replaced by what is stored there, and 08.5 was kept.
void ElsewhereTest::aCellThatIsBeingTypedStaysAsTyped()
{
    SmallFleet fleet;
    const SwingId swing = fleet.addSwing("2026-11-21", eightPoints());
    OpenWindow open(fleet.stores);
    open.window.go(swing);
    open.table().goTo(0, ReadingColumn::Compass);
    open.type("35");
    const auto program = fleet.stores.another();
    const auto storeRow = [&](std::size_t row, double compass_deg) {
        const Reading before = program->swings.swing(swing)->readings[row];
        Reading after = before;
        after.compass = CompassHeading::fromDegrees(compass_deg);
        return program->swings.changeReading(swing, before, after);
    };
    QVERIFY(storeRow(3, 140.5));
    QTRY_COMPARE(open.window.findChild<SwingPage*>()->editor().readings()[3].compass->degrees(), 140.5);
    QApplication::processEvents();
    open.type("8.5");
    open.press(Qt::Key_Return);
    QCOMPARE(fleet.stores.swings.swing(swing)->readings[0].compass->degrees(), 358.5);
    // A swing that is completed elsewhere closes the cell: what was typed is told.
    open.table().goTo(1, ReadingColumn::Compass);
    open.type("47.25");
    QVERIFY(program->signing.complete(swing));
    QTRY_VERIFY(!open.window.findChild<SwingPage*>()->editor().editable());
    QVERIFY2(open.window.messages().shown().contains("47.25"), qPrintable(open.window.messages().shown()));
}

void ElsewhereTest::aSwingIsSignedAsItWasSeen()
{
    TwoAircraft two;
    OpenWindow open(two.fleet.stores);
    open.window.go(two.complete);
    open.trigger("signSwing");
    open.find<QLineEdit>("signName").setText("Ada");
    open.find<QLineEdit>("signLicence").setText("PL 12");
    const auto program = two.fleet.stores.another();
    QVERIFY(program->signing.reopen(two.complete, "misread"));
    const Reading before = program->swings.swing(two.complete)->readings[3];
    Reading after = before;
    after.compass = CompassHeading::fromDegrees(before.compass->degrees() + 4);
    QVERIFY(program->swings.changeReading(two.complete, before, after));
    QVERIFY(program->signing.complete(two.complete));
    open.find<QPushButton>("signButton").click();
    QVERIFY(two.fleet.stores.swings.swing(two.complete)->signatures.empty());
    QVERIFY2(open.window.messages().shown().contains("look at it again"), qPrintable(open.window.messages().shown()));
    // It is shown as it is now, what was typed stands, and who has looked signs that.
    QCOMPARE(open.window.findChild<SwingPage*>()->editor().readings()[3].compass->degrees(), after.compass->degrees());
    QCOMPARE(open.find<QLineEdit>("signName").text(), "Ada");
    open.find<QPushButton>("signButton").click();
    QCOMPARE(two.fleet.stores.swings.swing(two.complete)->signatures.size(), std::size_t{1});
}

void ElsewhereTest::anExclusionIsOfItsReading()
{
    TwoAircraft two;
    OpenWindow open(two.fleet.stores);
    open.window.go(two.draft);
    const ReadingId meant = two.fleet.stores.swings.swing(two.draft)->readings[3].id;
    open.table().goTo(3, ReadingColumn::Compass);
    open.trigger("exclude");
    const auto program = two.fleet.stores.another();
    Reading first;
    first.magnetic = MagneticHeading::fromDegrees(2);
    QVERIFY(program->swings.insertReading(two.draft, 0, first));
    look(two);
    QCOMPARE(open.table().model()->rowCount(), 10); // one more, and the empty one
    open.find<QLineEdit>("exclusionReason").setText("a truck passed");
    open.find<QPushButton>("excludeButton").click();
    QVERIFY2(open.window.messages().messages().isEmpty(), qPrintable(open.window.messages().messages().join('|')));
    const auto stored = two.fleet.stores.swings.swing(two.draft); // outlives the loop
    QVERIFY(stored);
    for (const Reading& reading : stored->readings)
        QCOMPARE(reading.exclusion.has_value(), reading.id == meant);
    // One that is gone takes the question with it.
    open.table().goTo(1, ReadingColumn::Compass);
    open.trigger("exclude");
    QVERIFY(open.find<QWidget>("exclusionPanel").isVisible());
    QVERIFY(program->swings.removeReading(two.draft, two.fleet.stores.swings.swing(two.draft)->readings[1].id));
    look(two);
    QVERIFY(!open.find<QWidget>("exclusionPanel").isVisible());
}

void ElsewhereTest::aCellOfTheEventsStaysWithItsEvent()
{
    TwoAircraft two;
    const auto add = [&](db::Stores& stores, Date date, const std::string& kind) {
        Event event;
        event.aircraft = two.fleet.aircraft;
        event.date = date;
        event.kind = kind;
        QVERIFY(stores.fleet.add(event));
    };
    add(two.fleet.stores, "2026-10-01", "engine change");
    OpenWindow open(two.fleet.stores);
    open.window.go(two.fleet.aircraft);
    open.window.findChild<PageStack*>()->current().findChild<QTabWidget*>()->setCurrentIndex(2);
    auto& events = open.find<QTableWidget>("events");
    const int note = events.columnCount() - 1;
    events.setCurrentCell(0, note);
    events.editItem(events.item(0, note));
    auto* editor = qobject_cast<QLineEdit*>(events.indexWidget(events.currentIndex()));
    QVERIFY(editor);
    QTest::keyClicks(editor, "left engine");
    add(*two.fleet.stores.another(), "2026-11-01", "hard landing"); // newest first: it takes the row
    look(two);
    QCOMPARE(editor->text(), "left engine"); // nothing typed is lost
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(events.rowCount(), 2);
    for (const Event& event : *two.fleet.stores.fleet.eventsOf(two.fleet.aircraft))
        QVERIFY2(event.note == (event.kind == "engine change" ? "left engine" : ""), event.kind.c_str());
}

void ElsewhereTest::aFieldOfACompassIsNotOfTheNext()
{
    TwoAircraft two;
    CompassSystem second;
    second.aircraft = two.fleet.aircraft;
    second.name = "main compass";
    const CompassId removed = *two.fleet.stores.save(second);
    OpenWindow open(two.fleet.stores);
    open.window.go(removed);
    open.window.findChild<PageStack*>()->current().findChild<QTabWidget*>()->setCurrentIndex(1);
    auto& name = open.find<QLineEdit>("compassName");
    QCOMPARE(name.text(), "main compass");
    name.setFocus();
    QTest::keyClicks(&name, " of the left");
    const auto program = two.fleet.stores.another();
    QVERIFY(db::Removal(program->database()).remove(removed));
    QTRY_VERIFY(open.window.messages().shown().contains("removed"));
    auto& shown = open.find<QLineEdit>("compassName");
    QCOMPARE(shown.text(), "standby compass");
    QTest::keyClick(&shown, Qt::Key_Return);
    QVERIFY(two.fleet.stores.fleet.compass(two.fleet.compass)->name == "standby compass");
}

void ElsewhereTest::aRefusedTextStaysWithItsRecord()
{
    TwoAircraft two;
    OpenWindow open(two.fleet.stores);
    open.window.go(two.fleet.aircraft);
    auto& built = open.find<QLineEdit>("aircraftBuilt");
    built.setFocus();
    QTest::keyClicks(&built, "19x4");
    QTest::keyClick(&built, Qt::Key_Return);
    QVERIFY(!built.toolTip().isEmpty());
    open.find<QLineEdit>("aircraftNote").setFocus();
    look(two); // another program has stored something
    QCOMPARE(built.text(), "19x4");
    QVERIFY(!built.toolTip().isEmpty());
    QVERIFY(!two.fleet.stores.fleet.aircraft(two.fleet.aircraft)->builtYear);
}

void ElsewhereTest::aPlotIsOfTheSwingThatItWasAskedOf()
{
    TwoAircraft two;
    OpenWindow open(two.fleet.stores);
    open.window.go(two.draft);
    QFile file(open.folder.filePath("swing.csv"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("# aircraft: 3802\n# type: Su-22\n# compass: standby compass\n# date: 2026-11-24\n"
               "magnetic_heading_deg,compass_heading_deg\n0,358.5\n90,88\n180,181\n270,271\n");
    file.close();
    QPointer<Page> asked = &open.window.findChild<PageStack*>()->current();
    open.dialogs.answer = open.folder.filePath("plot.svg");
    open.dialogs.meanwhile = [&] { // a dialog stands, and an import that was running ends beneath it
        auto* dialog = new QDialog(&open.window);
        dialog->setModal(true);
        dialog->show();
        QSignalSpy finished(&open.window, &MainWindow::importFinished);
        open.window.importFile(file.fileName());
        QVERIFY(finished.wait());
        QApplication::processEvents();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QVERIFY2(open.window.windowTitle().contains("3802"), qPrintable(open.window.windowTitle()));
        QVERIFY(asked); // what was asked is still there
        delete dialog;
    };
    open.trigger("exportPlot");
    QVERIFY(open.dialogs.suggested.contains("3713"));
    QVERIFY(QFileInfo(open.dialogs.answer).size() > 0);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QTRY_VERIFY(!asked);
}

void ElsewhereTest::anAircraftThatIsRemovedIsLeft()
{
    TwoAircraft two;
    Aircraft empty;
    empty.type = two.fleet.type;
    empty.registration = "3999";
    const AircraftId removed = *two.fleet.stores.save(empty);
    OpenWindow open(two.fleet.stores);
    open.window.go(removed);
    QCOMPARE(front(open), QStringLiteral("aircraft"));
    const auto program = two.fleet.stores.another();
    QVERIFY(db::Removal(program->database()).remove(removed));
    QTRY_VERIFY2(open.window.messages().shown().contains("3999"), qPrintable(open.window.messages().shown()));
    QCOMPARE(front(open), QStringLiteral("overview"));
    // Nor does one that takes its place show under its page.
    Aircraft next = empty;
    next.registration = "4000";
    const AircraftId other = *two.fleet.stores.save(next);
    QVERIFY(other != removed);
    open.trigger("back");
    QVERIFY2(
        !open.window.windowTitle().contains("3999") && !open.window.windowTitle().contains("4000"), qPrintable(open.window.windowTitle()));
}

void ElsewhereTest::aSurveyIsStoredWithItsBase()
{
    TwoAircraft two;
    for (const char* name : {"Mielec", "Zamosc"}) {
        Site site;
        site.name = name;
        site.survey = {{0, 0, 1, 6.5, 49000}};
        QVERIFY(two.fleet.stores.save(site));
    }
    OpenWindow open(two.fleet.stores);
    open.trigger("showSites");
    auto& list = open.find<QListWidget>("siteList");
    auto& survey = open.find<QTableWidget>("surveyTable");
    QCOMPARE(list.currentItem()->text(), "Mielec");
    survey.setCurrentCell(0, 3);
    survey.editItem(survey.item(0, 3));
    auto* editor = qobject_cast<QLineEdit*>(survey.indexWidget(survey.currentIndex()));
    QVERIFY(editor);
    editor->selectAll();
    QTest::keyClicks(editor, "6.75");
    list.setFocus(); // as a click on the other base does
    list.setCurrentRow(1);
    QApplication::processEvents();
    QCOMPARE(list.currentItem()->text(), "Zamosc");
    for (const Site& site : *two.fleet.stores.sites.sites())
        QCOMPARE(*site.survey.front().declination_deg, site.name == "Mielec" ? 6.75 : 6.5);
}

QTEST_MAIN(ElsewhereTest)
#include "ElsewhereTest.moc"
