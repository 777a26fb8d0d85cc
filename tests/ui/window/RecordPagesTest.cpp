// A page owns one record: nothing typed or signed on it reaches another one, by whatever route the window goes there.

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTextBrowser>

#include "db/engine/Statement.h"
#include "tests/ui/window/Fixture.h"
#include "ui/fleet/AircraftPage.h"
#include "ui/fleet/RecordEdits.h"
#include "ui/guided/GuidedPage.h"
#include "ui/window/PageStack.h"

using namespace lubberline;
using namespace lubberline::ui;

class RecordPagesTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsSignedIsTheSwingInTheTitle_data();
    void whatIsSignedIsTheSwingInTheTitle();
    void whatWasTypedForOneSwingIsGoneOnTheNext();
    void anEventTypedForOneAircraftIsGoneOnTheNext();
    void figuresOfOneGuidedSwingAreGoneInTheNext();
    void anotherWindowsChangeIsShownBeforeItIsSigned();
    void aGuidedSwingThatDoesNotReadIsSaidOnItsPage();
    void everyPageHasTitleHelpAndWhatIsWritten();

private:
    using Route = void (*)(OpenWindow&, SmallFleet&, SwingId other);
    static AircraftId anotherAircraft(SmallFleet& fleet)
    {
        Aircraft aircraft;
        aircraft.type = fleet.type;
        aircraft.registration = "3802";
        const AircraftId id = *fleet.stores.save(aircraft);
        CompassSystem compass;
        compass.aircraft = id;
        compass.name = "standby compass";
        static_cast<void>(*fleet.stores.save(compass));
        return id;
    }
};

Q_DECLARE_METATYPE(void (*)(OpenWindow&, SmallFleet&, SwingId))

void RecordPagesTest::whatIsSignedIsTheSwingInTheTitle_data()
{
    QTest::addColumn<Route>("route");
    QTest::newRow("tree") << Route([](OpenWindow& open, SmallFleet&, SwingId other) { open.window.go(other); });
    QTest::newRow("new swing") << Route([](OpenWindow& open, SmallFleet&, SwingId) {
        open.trigger("newSwing");
        open.find<QLineEdit>("newDate").setText("2026-11-25");
        open.find<QPushButton>("createSwing").click();
    });
    QTest::newRow("import") << Route([](OpenWindow& open, SmallFleet&, SwingId) {
        QFile file(open.folder.filePath("swing.csv"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("# aircraft: 3802\n# type: Su-22\n# compass: standby compass\n# date: 2026-11-24\n"
                   "magnetic_heading_deg,compass_heading_deg\n0,358.5\n90,88\n180,181\n270,271\n");
        file.close();
        QSignalSpy finished(&open.window, &MainWindow::importFinished);
        open.window.importFile(file.fileName());
        QVERIFY(finished.wait());
    });
    QTest::newRow("undo") << Route([](OpenWindow& open, SmallFleet&, SwingId other) {
        auto& editor = open.window.findChild<SwingPage*>()->editor();
        const SwingId first = editor.id();
        open.window.go(other);
        auto& second = open.window.findChild<SwingPage*>()->editor();
        Reading read = second.readings()[0];
        read.compass = CompassHeading::fromDegrees(1);
        QVERIFY(second.changeReading(0, read, "compass"));
        open.window.go(first);
        open.trigger("signSwing");
        open.find<QLineEdit>("signName").setText("Ada");
        open.trigger("undo"); // shows the swing whose reading it was
    });
}

void RecordPagesTest::whatIsSignedIsTheSwingInTheTitle()
{
    QFETCH(Route, route);
    SmallFleet fleet;
    const SwingId first = fleet.addSwing("2026-11-20", eightPoints()), other = fleet.addSwing("2026-11-21", eightPoints());
    QVERIFY(fleet.stores.signing.complete(first));
    OpenWindow open(fleet.stores);
    open.window.go(first);
    open.trigger("signSwing");
    open.find<QLineEdit>("signName").setText("Ada");
    route(open, fleet, other);
    const SwingRecord shown = open.window.findChild<SwingPage*>()->editor().record();
    QVERIFY(shown.swing.id != first);
    QVERIFY(open.label("swingTitle").contains(QString::fromStdString(shown.swing.date.text())));
    open.trigger("signSwing");
    QVERIFY(open.find<QLineEdit>("signName").text().isEmpty());
    QVERIFY2(
        open.label("signStatement").contains(QString::fromStdString(shown.swing.date.text())), qPrintable(open.label("signStatement")));
    open.find<QPushButton>("changeState").click(); // completes the one that is shown, if anything
    open.find<QLineEdit>("signName").setText("Ben");
    open.find<QPushButton>("signButton").click();
    QVERIFY(fleet.stores.swings.swing(first)->signatures.empty());
    QCOMPARE(fleet.stores.swings.swing(first)->state, SwingState::Complete);
}

void RecordPagesTest::whatWasTypedForOneSwingIsGoneOnTheNext()
{
    SmallFleet fleet;
    const SwingId first = fleet.addSwing("2026-11-20", eightPoints()), second = fleet.addSwing("2026-11-21", eightPoints());
    QVERIFY(fleet.stores.signing.complete(first) && fleet.stores.signing.complete(second));
    OpenWindow open(fleet.stores);
    open.window.go(first);
    open.trigger("signSwing");
    for (const char* name : {"signName", "signLicence", "stateReason"})
        open.find<QLineEdit>(name).setText("typed for the first");
    open.window.go(second);
    open.trigger("signSwing");
    for (const char* name : {"signName", "signLicence", "stateReason"})
        QVERIFY(open.find<QLineEdit>(name).text().isEmpty());
    QCOMPARE(open.window.findChildren<SwingPage*>().size(), 1);
}

void RecordPagesTest::anEventTypedForOneAircraftIsGoneOnTheNext()
{
    SmallFleet fleet;
    const AircraftId other = anotherAircraft(fleet);
    OpenWindow open(fleet.stores);
    open.window.go(fleet.aircraft);
    open.find<QLineEdit>("eventDate").setText("2026-11-20");
    open.find<QLineEdit>("eventKind").setText("lightning strike");
    open.window.go(other);
    QVERIFY(open.find<QLineEdit>("eventKind").text().isEmpty());
    open.find<QPushButton>("addEvent").click();
    QVERIFY(fleet.stores.fleet.eventsOf(other)->empty());
}

void RecordPagesTest::figuresOfOneGuidedSwingAreGoneInTheNext()
{
    SmallFleet fleet;
    const AircraftId other = anotherAircraft(fleet);
    const CompassId second = fleet.stores.fleet.compassesOf(other)->front().id;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.compass);
    open.trigger("guidedSwing");
    auto* page = open.window.findChild<GuidedPage*>();
    QVERIFY(page);
    for (QLineEdit* line : page->findChildren<QLineEdit*>())
        line->setText("123");
    open.window.go(second);
    open.trigger("guidedSwing");
    QCOMPARE(open.window.findChildren<GuidedPage*>().size(), 1);
    for (QLineEdit* line : open.window.findChild<GuidedPage*>()->findChildren<QLineEdit*>())
        QVERIFY2(line->text() != "123", qPrintable(line->objectName()));
}

void RecordPagesTest::anotherWindowsChangeIsShownBeforeItIsSigned()
{
    SmallFleet fleet;
    const SwingId id = fleet.addSwing("2026-11-20", eightPoints());
    OpenWindow open(fleet.stores), second(fleet.stores);
    open.window.go(id);
    open.trigger("signSwing");
    second.window.go(id);
    second.trigger("complete");
    QCOMPARE(open.window.findChild<SwingPage*>()->editor().record().swing.state, SwingState::Complete);
    QVERIFY(open.find<QWidget>("signButton").isVisible());
}

void RecordPagesTest::aGuidedSwingThatDoesNotReadIsSaidOnItsPage()
{
    SmallFleet fleet;
    const SwingId swing = fleet.addSwing("2026-11-20", eightPoints());
    QVERIFY(fleet.stores.jobs.add(swing, SwingJob(), true));
    QVERIFY(db::execute(fleet.stores.database(), "UPDATE swing_job SET plan_json = '{'"));
    OpenWindow open(fleet.stores);
    open.window.go(swing);
    QVERIFY2(open.label("meaning").contains("does not read"), qPrintable(open.label("meaning")));
    QVERIFY(!open.window.findChild<SwingPage*>()->editor().analysis()); // no figures without the datum's division
}

void RecordPagesTest::everyPageHasTitleHelpAndWhatIsWritten()
{
    SmallFleet fleet;
    const SwingId swing = fleet.addSwing("2026-11-20", eightPoints());
    OpenWindow open(fleet.stores);
    auto* stack = open.window.findChild<PageStack*>();
    QVERIFY(stack->descriptions().size() >= 15);
    const auto* sheet = open.window.findChild<QAction*>("sheet1613");
    for (const PageDescription& page : stack->descriptions()) {
        const auto opened = [&](const FleetItem& record) { return static_cast<bool>(stack->show(Destination{page.id, record})); };
        QVERIFY2(opened(fleet.compass) || opened(swing), qPrintable(page.id));
        QCOMPARE(stack->description()->id, page.id);
        QVERIFY2(!stack->current().title().isEmpty(), qPrintable(page.id));
        QVERIFY2(page.help.size() > 60, qPrintable(page.id));
        for (const Command& output : page.outputs) // in the menu here, and only here
            QVERIFY2(open.window.findChild<QAction*>(output.name)->isVisible(), qPrintable(output.name));
        QCOMPARE(sheet->isVisible(), page.id == "swing");
        QCOMPARE(open.window.findChild<QAction*>("exportPlot")->isEnabled(), stack->current().plot() != nullptr);
        open.trigger("help"); // its topic
        QCOMPARE(stack->description()->id, QString("help"));
        const QString text = open.find<QTextBrowser>("helpText").toPlainText().simplified();
        QVERIFY2(text.contains(QString(page.help).simplified()), qPrintable(page.id + ": " + text));
    }
}

QTEST_MAIN(RecordPagesTest)
#include "RecordPagesTest.moc"
