// Every edit is undone and redone, across swings and through removed rows; exclusion keeps its reason.

#include <QAbstractItemModelTester>
#include <QLineEdit>
#include <QPushButton>

#include "tests/ui/window/Fixture.h"

using namespace lubberline;
using namespace lubberline::ui;

class UndoTest : public QObject {
    Q_OBJECT

private slots:
    void typingIsUndoneAndRedone();
    void removedRowsComeBackWithTheirHistory();
    void undoShowsTheSwingThatItChanges();
    void layoutIsOneStep();
    void draftIsRemovedAndRestored();
    void exclusionNeedsAReason();
    void suspectIsSaid();
    void refusedEditLeavesTheStack();
    void variationMovesTrueReadings();

private:
    static Swing swingAt(SmallFleet& fleet, SwingId id) { return *fleet.stores.swings.swing(id); }
};

void UndoTest::typingIsUndoneAndRedone()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.swing);
    open.type("45");
    open.press(Qt::Key_Return);
    open.type("42");
    open.press(Qt::Key_Return);
    QVERIFY2(open.find<QAction>("undo").text().contains("compass reading on 045"), qPrintable(open.find<QAction>("undo").text()));
    open.trigger("undo");
    QVERIFY(!swingAt(fleet, fleet.swing).readings[0].compass);
    open.trigger("undo");
    QVERIFY(swingAt(fleet, fleet.swing).readings.empty());
    open.trigger("redo");
    open.trigger("redo");
    QCOMPARE(swingAt(fleet, fleet.swing).readings[0].compass->degrees(), 42.0); // though the row has a new id by now
    open.trigger("undo");
    open.trigger("undo");
    QVERIFY(!open.find<QAction>("undo").isEnabled());
}

void UndoTest::removedRowsComeBackWithTheirHistory()
{
    SmallFleet fleet;
    const SwingId id = fleet.addSwing("2026-11-21", eightPoints());
    OpenWindow open(fleet.stores);
    open.window.go(id);
    QAbstractItemModelTester tester(open.table().model(), QAbstractItemModelTester::FailureReportingMode::Fatal);
    const Swing before = swingAt(fleet, id);
    open.table().goTo(2, ReadingColumn::Compass);
    open.type("91");
    open.press(Qt::Key_Return);
    open.table().goTo(2, ReadingColumn::Compass);
    open.trigger("deleteRows");
    QCOMPARE(swingAt(fleet, id).readings.size(), 7u);
    open.trigger("undo");
    QCOMPARE(swingAt(fleet, id).readings.size(), 8u);
    QCOMPARE(swingAt(fleet, id).readings[2].compass->degrees(), 91.0);
    open.trigger("undo");
    QCOMPARE(swingAt(fleet, id).readings[2].compass->degrees(), before.readings[2].compass->degrees());
    QCOMPARE(open.table().model()->rowCount(), 9);
}

void UndoTest::undoShowsTheSwingThatItChanges()
{
    SmallFleet fleet;
    const SwingId other = fleet.addSwing("2026-11-21", eightPoints());
    OpenWindow open(fleet.stores);
    open.window.go(fleet.swing);
    open.type("45");
    open.press(Qt::Key_Return);
    open.window.go(other);
    QCOMPARE(open.table().model()->rowCount(), 9);
    open.trigger("undo");
    QVERIFY(swingAt(fleet, fleet.swing).readings.empty());
    QVERIFY(open.label("swingTitle").contains("2026-11-20"));
}

void UndoTest::layoutIsOneStep()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.swing);
    for (const int points : {4, 8, 12, 16, 24, 32}) {
        open.trigger(qPrintable(QStringLiteral("layout%1").arg(points)));
        const auto& readings = swingAt(fleet, fleet.swing).readings;
        QCOMPARE(readings.size(), std::size_t(points));
        for (int i = 0; i < points; ++i)
            QCOMPARE(*readings[std::size_t(i)].nominal_deg, 360.0 * i / points);
        open.trigger("undo");
        QVERIFY(swingAt(fleet, fleet.swing).readings.empty());
    }
}

void UndoTest::draftIsRemovedAndRestored()
{
    SmallFleet fleet;
    const SwingId id = fleet.addSwing("2026-11-21", eightPoints());
    OpenWindow open(fleet.stores);
    open.window.go(id);
    open.table().goTo(0, ReadingColumn::Note);
    open.type("gusty");
    open.press(Qt::Key_Return);
    open.trigger("removeSwing");
    QCOMPARE(fleet.stores.whole().swings.size(), 1u);
    open.trigger("undo");
    QCOMPARE(fleet.stores.whole().swings.size(), 2u);
    QCOMPARE(fleet.stores.whole().swings.back().readings.size(), 8u);
    QCOMPARE(fleet.stores.whole().swings.back().readings[0].note, std::string("gusty"));
    QVERIFY(open.label("swingTitle").contains("2026-11-21"));
    open.trigger("undo"); // the note, of a reading and a swing that have new ids by now
    QVERIFY(fleet.stores.whole().swings.back().readings[0].note.empty());
}

void UndoTest::exclusionNeedsAReason()
{
    SmallFleet fleet;
    const SwingId id = fleet.addSwing("2026-11-21", eightPoints());
    OpenWindow open(fleet.stores);
    open.window.go(id);
    open.table().goTo(1, ReadingColumn::Compass);
    open.trigger("exclude");
    auto& reason = open.find<QLineEdit>("exclusionReason");
    QVERIFY(reason.isVisible());
    QVERIFY(!open.find<QPushButton>("excludeButton").isEnabled());
    QTest::keyClick(&reason, Qt::Key_Return);
    QVERIFY(!swingAt(fleet, id).readings[1].exclusion);
    QTest::keyClicks(&reason, "truck beside the pad");
    QTest::keyClick(&reason, Qt::Key_Return);
    QCOMPARE(swingAt(fleet, id).readings[1].exclusion->reason, std::string("truck beside the pad"));
    QVERIFY(open.cell(1, ReadingColumn::State).contains("truck"));
    QVERIFY2(open.label("fitSummary").contains("N = 7"), qPrintable(open.label("fitSummary")));
    open.trigger("undo");
    QVERIFY(!swingAt(fleet, id).readings[1].exclusion);
    open.trigger("redo");
    open.trigger("exclude"); // counts again, without a question
    QVERIFY(!swingAt(fleet, id).readings[1].exclusion);
}

void UndoTest::suspectIsSaid()
{
    SmallFleet fleet;
    auto readings = eightPoints();
    readings[1].second -= 10.0; // a tens digit misread
    const SwingId id = fleet.addSwing("2026-11-21", readings);
    OpenWindow open(fleet.stores);
    open.window.go(id);
    QVERIFY2(open.cell(1, ReadingColumn::State).contains("suspect"), qPrintable(open.cell(1, ReadingColumn::State)));
    // The sign stands where no narrow table scrolls it out of sight.
    const auto number = [&](int row) { return open.table().model()->headerData(row, Qt::Vertical).toString(); };
    QCOMPARE(number(0) + ", " + number(1), QString("1, ◉ 2"));
    const QString said = open.label("readingsMessage");
    QVERIFY2(said.contains("the compass reads 035°") && said.contains("045° meant"), qPrintable(said));
    QVERIFY2(said.contains("Look again: most likely a 10° slip"), qPrintable(said));
    QVERIFY(open.label("fitSummary").contains("N = 8")); // never dropped by itself
}

void UndoTest::refusedEditLeavesTheStack()
{
    SmallFleet fleet;
    const SwingId id = fleet.addSwing("2026-11-21", eightPoints());
    OpenWindow open(fleet.stores);
    open.window.go(id);
    fleet.stores.watch().refuseWrites = true;
    const double before_deg = swingAt(fleet, id).readings[1].compass->degrees();
    open.table().goTo(1, ReadingColumn::Compass);
    open.type("44");
    open.press(Qt::Key_Return);
    QCOMPARE(open.window.undoStack().count(), 0);
    QCOMPARE(open.cell(1, ReadingColumn::Compass), QStringLiteral("44")); // what was typed is not lost
    QVERIFY(open.label("readingsMessage").contains("disk is full"));
    QVERIFY(open.window.messages().messages().join('\n').contains("disk is full"));
    QVERIFY(open.label("savedLabel").contains("NOT SAVED"));
    QCOMPARE(swingAt(fleet, id).readings[1].compass->degrees(), before_deg);
    fleet.stores.watch().refuseWrites = false;
    open.press(Qt::Key_F2);
    open.type("43");
    open.press(Qt::Key_Return);
    QCOMPARE(swingAt(fleet, id).readings[1].compass->degrees(), 43.0);
    QVERIFY(open.label("savedLabel").contains("all changes saved"));
}

void UndoTest::variationMovesTrueReadings()
{
    SmallFleet fleet;
    Swing swing;
    swing.compass = fleet.compass;
    swing.date = "2026-11-22";
    swing.variation_deg = 5.0;
    Reading reading;
    reading.trueHeading = TrueHeading::fromDegrees(50.0);
    reading.magnetic = MagneticHeading::fromDegrees(45.0);
    swing.readings = {reading};
    const SwingId id = *fleet.stores.swings.add(swing);
    OpenWindow open(fleet.stores);
    open.window.go(id);
    QTest::mouseClick(&open.find<QAbstractButton>("showParticulars"), Qt::LeftButton);
    auto& variation = open.find<QLineEdit>("swingVariation");
    variation.setFocus();
    variation.selectAll();
    QTest::keyClicks(&variation, "3 30 E");
    QTest::keyClick(&variation, Qt::Key_Return);
    QCOMPARE(*swingAt(fleet, id).variation_deg, 3.5);
    QCOMPARE(swingAt(fleet, id).readings[0].magnetic->degrees(), 46.5); // magnetic = true − variation
    open.trigger("undo");
    QCOMPARE(swingAt(fleet, id).readings[0].magnetic->degrees(), 45.0);
    QCOMPARE(*swingAt(fleet, id).variation_deg, 5.0);
    auto& shared = open.find<QLineEdit>("swingSharedError");
    shared.setFocus();
    QTest::keyClicks(&shared, "A 0.6 C 0.2");
    QTest::keyClick(&shared, Qt::Key_Return);
    QCOMPARE(swingAt(fleet, id).sharedErrors.of_deg[0], 0.6);
    QCOMPARE(swingAt(fleet, id).sharedErrors.of_deg[2], 0.2);
    open.trigger("undo");
    QVERIFY(!swingAt(fleet, id).sharedErrors.any());
}

QTEST_MAIN(UndoTest)
#include "UndoTest.moc"
