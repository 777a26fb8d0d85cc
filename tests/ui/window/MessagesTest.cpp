// Messages: one at a time, closed by Escape, gone with their cause, never carried to another page; what was written can be opened.

#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>

#include "tests/ui/window/Fixture.h"

using namespace lubberline;
using namespace lubberline::ui;

class MessagesTest : public QObject {
    Q_OBJECT

private slots:
    void oneIsSeenAtATime();
    void escapeClosesTheOneThatIsSeen();
    void noneIsCarriedToAnotherPage();
    void whatIsMendedGoes();
    void whatWasWrittenCanBeOpened();
    void filesAreNamedForTheirRecord();
};

void MessagesTest::oneIsSeenAtATime()
{
    MessagePanel panel;
    panel.add(MessagePanel::Kind::Failure, "first");
    panel.add(MessagePanel::Kind::Failure, "second");
    panel.add(MessagePanel::Kind::Information, "news");
    QCOMPARE(panel.shown(), QString("second"));
    QCOMPARE(panel.findChildren<QLabel*>("messageText").size(), 1);
    QVERIFY(panel.findChild<QLabel*>("moreMessages")->text().contains("2"));
    QVERIFY(panel.closeShown());
    QCOMPARE(panel.shown(), QString("first"));
    QVERIFY(panel.closeShown());
    QCOMPARE(panel.shown(), QString("news"));
    panel.add(MessagePanel::Kind::Information, "later news");
    QCOMPARE(panel.messages(), QStringList{"later news"});
    QVERIFY(panel.closeShown());
    QVERIFY(!panel.closeShown());
}

void MessagesTest::escapeClosesTheOneThatIsSeen()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.addSwing("2026-11-20", eightPoints()));
    open.window.fail("first");
    open.window.fail("second");
    open.table().setFocus();
    QTest::keyClick(&open.table(), Qt::Key_Escape);
    QCOMPARE(open.window.messages().shown(), QString("first"));
    open.table().goTo(1, ReadingColumn::Compass);
    open.press(Qt::Key_F2); // an editor has Escape for itself
    open.press(Qt::Key_Escape);
    QCOMPARE(open.window.messages().shown(), QString("first"));
    QTest::keyClick(&open.table(), Qt::Key_Escape);
    QVERIFY(open.window.messages().messages().isEmpty());
}

void MessagesTest::noneIsCarriedToAnotherPage()
{
    SmallFleet fleet;
    const SwingId first = fleet.addSwing("2026-11-20", eightPoints()), second = fleet.addSwing("2026-11-21", eightPoints());
    OpenWindow open(fleet.stores);
    open.window.go(first);
    open.window.fail("of the first");
    open.window.go(second);
    QVERIFY(open.window.messages().messages().isEmpty());
    open.window.fail("of the second");
    open.trigger("showSites");
    QVERIFY(open.window.messages().messages().isEmpty());
}

void MessagesTest::whatIsMendedGoes()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.addSwing("2026-11-20", eightPoints()));
    fleet.stores.watch().refuseWrites = true;
    open.table().goTo(1, ReadingColumn::Compass);
    open.type("44");
    open.press(Qt::Key_Return);
    QCOMPARE(open.window.messages().messages().filter("disk is full").size(), 1);
    fleet.stores.watch().refuseWrites = false;
    open.table().goTo(1, ReadingColumn::Compass);
    open.press(Qt::Key_F2);
    open.type("43");
    open.press(Qt::Key_Return);
    QVERIFY2(open.window.messages().messages().filter("disk is full").isEmpty(), qPrintable(open.window.messages().messages().join('\n')));
}

void MessagesTest::whatWasWrittenCanBeOpened()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.addSwing("2026-11-20", eightPoints()));
    open.dialogs.answer = open.folder.filePath("report.pdf");
    open.trigger("report");
    QVERIFY2(open.window.messages().shown().contains("report.pdf"), qPrintable(open.window.messages().shown()));
    open.find<QPushButton>("answerMessage").click();
    QCOMPARE(open.dialogs.openedOutside, open.dialogs.answer);
    open.find<QPushButton>("answerMessage2").click();
    QCOMPARE(open.dialogs.openedOutside, open.folder.path());
    // What a page writes without a word is told, too.
    open.dialogs.answer = open.folder.filePath("plot.svg");
    open.trigger("exportPlot");
    QTRY_VERIFY(open.window.messages().shown().contains("plot.svg"));
    QCOMPARE(open.window.messages().messages().size(), 1);
}

void MessagesTest::filesAreNamedForTheirRecord()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.addSwing("2026-11-20", eightPoints()));
    open.dialogs.answer.clear();
    for (const char* action : {"report", "card30", "exportPlot"}) {
        open.trigger(action);
        QVERIFY2(
            open.dialogs.suggested.contains("3713") && open.dialogs.suggested.contains("2026-11-20"), qPrintable(open.dialogs.suggested));
    }
    open.window.go(fleet.compass);
    open.trigger("exportAircraft");
    QVERIFY2(open.dialogs.suggested.startsWith("3713"), qPrintable(open.dialogs.suggested));
}

QTEST_MAIN(MessagesTest)
#include "MessagesTest.moc"
