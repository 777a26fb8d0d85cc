// A swing typed in with nothing but the keyboard.

#include <QAbstractItemModelTester>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>

#include "tests/ui/window/Fixture.h"

using namespace lubberline;
using namespace lubberline::ui;

class KeyboardEntryTest : public QObject {
    Q_OBJECT

private slots:
    void eightPointsInEveryForm();
    void everyLeftCellIsStored();
    void badInputStaysAndIsNotStored();
    void deviationSetsTheCompass();
    void deviationNeedsTheMagneticHeading();
    void nominalIsAcceptedOnlyVisibly();
    void minutesDoNotLoseSeconds();
    void completeSwingCannotBeTyped();
    void emptyRowBecomesAReading();
    void whatIsTypedSurvivesAShortcut();
    void aRefusedTextStandsBesideTheStoredValue();
    void escapeInTheEditorPutsTheStoredValueBack();
    void aHeadingFarFromItsNominalIsRemarkedAtOnce();
    void aMisreadSentenceStaysWithItsRow();
    void whereHeadingsAreLaidOutTheCompassIsBlamed();
    void theClipboardHasItsKeysWithoutAWindow();

private:
    static std::vector<Reading> stored(SmallFleet& fleet) { return fleet.stores.whole().swings.front().readings; }
};

void KeyboardEntryTest::eightPointsInEveryForm()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.swing);
    QAbstractItemModelTester tester(open.table().model(), QAbstractItemModelTester::FailureReportingMode::Fatal);
    // N … NW: magnetic then compass, in the forms that crews use.
    const std::pair<const char*, const char*> typed[] = {{"0", "358.5"}, {"45", "42,25"}, {"090.0", "88 30"}, {"135", "134"},
        {"180", "181.5"}, {"225", "227:15"}, {"270", "271"}, {"315.0", "313.8"}};
    for (const auto& [magnetic, compass] : typed) {
        open.type(magnetic);
        open.press(Qt::Key_Return);
        open.type(compass);
        open.press(Qt::Key_Return);
    }
    QCOMPARE(stored(fleet).size(), 8u);
    const double expected_deg[] = {1.5, 2.75, 1.5, 1.0, -1.5, -2.25, -1.0, 1.2};
    for (std::size_t i = 0; i < 8; ++i)
        QVERIFY(std::abs(deviationOf(*stored(fleet)[i].magnetic, *stored(fleet)[i].compass).degrees() - expected_deg[i]) < 1e-9);
    QCOMPARE(open.table().currentIndex().row(), 8); // ready for the ninth
    QCOMPARE(open.table().currentIndex().column(), int(ReadingColumn::Magnetic));
    // The rule of eight points gives A as their mean: 0.4°.
    const auto& coefficients = open.find<QTableWidget>("coefficients");
    QCOMPARE(coefficients.horizontalHeaderItem(4)->text(), QStringLiteral("8-point (°)"));
    QCOMPARE(coefficients.item(0, 4)->text(), QStringLiteral("+0.40"));
    // B = (δE − δW)/2 = 1.25; C = (δN − δS)/2 = 1.5.
    QCOMPARE(coefficients.item(1, 4)->text(), QStringLiteral("+1.25"));
    QCOMPARE(coefficients.item(2, 4)->text(), QStringLiteral("+1.50"));
    QVERIFY2(open.label("meaning").contains("14 CFR 25.1327"), qPrintable(open.label("meaning")));
}

void KeyboardEntryTest::everyLeftCellIsStored()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.swing);
    open.type("45");
    QCOMPARE(stored(fleet).size(), 0u); // still being typed
    open.press(Qt::Key_Return);
    QCOMPARE(stored(fleet).size(), 1u);
    QVERIFY(!stored(fleet)[0].compass);
    open.type("42");
    open.press(Qt::Key_Tab);
    QCOMPARE(stored(fleet)[0].compass->degrees(), 42.0);
    open.window.close();
}

void KeyboardEntryTest::badInputStaysAndIsNotStored()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.swing);
    open.type("45");
    open.press(Qt::Key_Return);
    for (const char* wrong : {"361", "-1", "north", "12 75", "1e400", "nan", "45W"}) {
        open.type(wrong);
        open.press(Qt::Key_Return);
        QCOMPARE(open.cell(0, ReadingColumn::Compass), QString::fromLatin1(wrong));
        QVERIFY(open.table().currentIndex().data(ReadingsModel::RejectedRole).toBool());
        QCOMPARE(open.table().currentIndex().column(), int(ReadingColumn::Compass)); // not passed over
        QVERIFY2(open.label("readingsMessage").contains("Not stored"), qPrintable(open.label("readingsMessage")));
        QVERIFY(!stored(fleet)[0].compass);
    }
    open.press(Qt::Key_Delete);
    QVERIFY(open.cell(0, ReadingColumn::Compass).isEmpty());
    open.type("42");
    open.press(Qt::Key_Return);
    QCOMPARE(stored(fleet)[0].compass->degrees(), 42.0);
    QVERIFY(!open.label("readingsMessage").contains("Not stored"));
}

void KeyboardEntryTest::deviationSetsTheCompass()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.swing);
    open.type("2");
    open.press(Qt::Key_Return);
    const std::pair<const char*, double> typed[] = {{"3.25W", 5.25}, {"3 15 E", 358.75}, {"-3.25", 5.25}, {"+3,25", 358.75}, {"0", 2.0}};
    for (const auto& [text, compass_deg] : typed) {
        open.table().goTo(0, ReadingColumn::Deviation);
        open.type(text);
        open.press(Qt::Key_Return);
        QVERIFY2(std::abs(stored(fleet)[0].compass->degrees() - compass_deg) < 1e-9, text);
    }
}

void KeyboardEntryTest::deviationNeedsTheMagneticHeading()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.swing);
    open.table().goTo(0, ReadingColumn::Deviation);
    open.type("3E");
    open.press(Qt::Key_Return);
    QVERIFY(stored(fleet).empty());
    QVERIFY2(open.label("readingsMessage").contains("magnetic heading first"), qPrintable(open.label("readingsMessage")));
}

void KeyboardEntryTest::nominalIsAcceptedOnlyVisibly()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.swing);
    open.trigger("layout4");
    QCOMPARE(stored(fleet).size(), 4u);
    QCOMPARE(*stored(fleet)[3].nominal_deg, 270.0);
    QVERIFY(!stored(fleet)[0].magnetic);
    QVERIFY(open.table().model()->index(0, 1).data(ReadingsModel::PlaceholderRole).toBool());
    // Only the compass typed: nothing is guessed.
    open.table().goTo(0, ReadingColumn::Compass);
    open.type("1");
    open.press(Qt::Key_Return);
    QVERIFY(!stored(fleet)[0].magnetic);
    QCOMPARE(open.cell(0, ReadingColumn::State), QStringLiteral("incomplete: the magnetic heading is missing"));
    // Enter on the grey heading, "=", and Ctrl+D accept it.
    QCOMPARE(open.table().currentIndex().row(), 1);
    open.press(Qt::Key_Return);
    QCOMPARE(stored(fleet)[1].magnetic->degrees(), 90.0);
    QCOMPARE(open.table().currentIndex().column(), int(ReadingColumn::Compass));
    open.table().goTo(2, ReadingColumn::Magnetic);
    open.type("=");
    QCOMPARE(stored(fleet)[2].magnetic->degrees(), 180.0);
    open.table().goTo(3, ReadingColumn::Magnetic);
    open.trigger("acceptNominal");
    QCOMPARE(stored(fleet)[3].magnetic->degrees(), 270.0);
    // Eight points: only those that are missing are added, in their places.
    open.trigger("layout8");
    QCOMPARE(stored(fleet).size(), 8u);
    for (std::size_t i = 0; i < 8; ++i)
        QCOMPARE(*stored(fleet)[i].nominal_deg, 45.0 * double(i));
}

void KeyboardEntryTest::minutesDoNotLoseSeconds()
{
    SmallFleet fleet;
    const SwingId id = fleet.addSwing("2026-11-21", {{45.123456, 42.0}});
    OpenWindow open(fleet.stores);
    open.window.go(id);
    open.find<QAction>("minutes").setChecked(true);
    QVERIFY2(open.cell(0, ReadingColumn::Magnetic).contains(QChar(0xB0)), qPrintable(open.cell(0, ReadingColumn::Magnetic)));
    open.table().goTo(0, ReadingColumn::Magnetic);
    open.press(Qt::Key_F2); // opens with 045°07'
    open.press(Qt::Key_Return);
    QCOMPARE(fleet.stores.whole().swings.back().readings[0].magnetic->degrees(), 45.123456);
    QVERIFY(open.settings.value("view/minutes").toBool());
}

void KeyboardEntryTest::completeSwingCannotBeTyped()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    const SwingId id = fleet.addSwing("2026-11-21", eightPoints());
    open.window.go(id);
    QCOMPARE(open.table().model()->rowCount(), 9);
    open.trigger("complete");
    QCOMPARE(fleet.stores.whole().swings.back().state, SwingState::Complete);
    QCOMPARE(open.table().model()->rowCount(), 8);
    open.table().goTo(0, ReadingColumn::Compass);
    open.type("9");
    open.press(Qt::Key_Return);
    QCOMPARE(fleet.stores.whole().swings.back().readings[0].compass->degrees(), 0.0);
    QVERIFY(open.label("readOnlyReason").contains("complete"));
    // To open it again wants a reason, which is given in the panel that this opens.
    open.trigger("complete");
    QCOMPARE(fleet.stores.whole().swings.back().state, SwingState::Complete);
    open.find<QPushButton>("changeState").click();
    QCOMPARE(fleet.stores.whole().swings.back().state, SwingState::Complete);
    open.find<QLineEdit>("stateReason").setText("a figure was misread");
    open.find<QPushButton>("changeState").click();
    QCOMPARE(fleet.stores.whole().swings.back().state, SwingState::Draft);
    QCOMPARE(open.table().model()->rowCount(), 9);
}

void KeyboardEntryTest::emptyRowBecomesAReading()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.swing);
    QAbstractItemModelTester tester(open.table().model(), QAbstractItemModelTester::FailureReportingMode::Fatal);
    // A refused text in the empty row goes with the reading that the row becomes.
    open.table().goTo(0, ReadingColumn::Compass);
    open.type("x");
    open.press(Qt::Key_Return);
    open.table().goTo(0, ReadingColumn::Nominal);
    open.type("30");
    open.press(Qt::Key_Return);
    QCOMPARE(stored(fleet).size(), 1u);
    QCOMPARE(open.cell(0, ReadingColumn::Compass), QStringLiteral("x"));
    QVERIFY(open.cell(1, ReadingColumn::Compass).isEmpty());
    QCOMPARE(open.table().currentIndex().row(), 0);
    QCOMPARE(open.table().currentIndex().column(), int(ReadingColumn::Magnetic));
}

void KeyboardEntryTest::whatIsTypedSurvivesAShortcut()
{
    SmallFleet fleet;
    const SwingId other = fleet.addSwing("2026-11-21", eightPoints());
    OpenWindow open(fleet.stores);
    for (const bool leaves : {true, false}) {
        open.window.go(fleet.swing);
        open.table().setFocus();
        open.table().goTo(0, ReadingColumn::Magnetic);
        open.type(leaves ? "45" : "46");
        if (leaves)
            open.window.go(other);
        else
            open.trigger("complete");
        QCOMPARE(stored(fleet).size(), 1u);
        QCOMPARE(stored(fleet)[0].magnetic->degrees(), leaves ? 45.0 : 46.0);
    }
}

void KeyboardEntryTest::aRefusedTextStandsBesideTheStoredValue()
{
    SmallFleet fleet;
    const SwingId id = fleet.addSwing("2026-11-21", eightPoints());
    OpenWindow open(fleet.stores);
    open.window.go(id);
    const QString before = open.cell(1, ReadingColumn::Compass);
    open.table().goTo(1, ReadingColumn::Compass);
    open.type("45x");
    open.press(Qt::Key_Return);
    const QModelIndex cell = open.table().model()->index(1, int(ReadingColumn::Compass));
    QVERIFY(cell.data(ReadingsModel::RejectedRole).toBool());
    QCOMPARE(cell.data().toString(), QString("45x"));
    QCOMPARE(cell.data(ReadingsModel::StoredRole).toString(), before);
    for (const int role : {int(Qt::ToolTipRole), int(Qt::AccessibleTextRole)})
        QVERIFY2(cell.data(role).toString().contains(before), qPrintable(cell.data(role).toString()));
    open.table().setCurrentIndex(cell);
    QTest::keyClick(&open.table(), Qt::Key_Escape);
    QVERIFY(!cell.data(ReadingsModel::RejectedRole).toBool());
    QCOMPARE(cell.data().toString(), before);
    QVERIFY(!open.label("readingsMessage").contains("Not stored"));
    QCOMPARE(open.window.undoStack().count(), 0);
}

void KeyboardEntryTest::escapeInTheEditorPutsTheStoredValueBack()
{
    SmallFleet fleet;
    const SwingId id = fleet.addSwing("2026-11-21", eightPoints());
    OpenWindow open(fleet.stores);
    open.window.go(id);
    open.table().goTo(2, ReadingColumn::Magnetic);
    open.type("north");
    open.press(Qt::Key_Return);
    open.table().goTo(2, ReadingColumn::Magnetic);
    open.press(Qt::Key_F2);
    open.type("8");
    open.press(Qt::Key_Escape);
    const QModelIndex cell = open.table().model()->index(2, int(ReadingColumn::Magnetic));
    QVERIFY(!cell.data(ReadingsModel::RejectedRole).toBool());
    QCOMPARE(open.window.undoStack().count(), 0);
}

void KeyboardEntryTest::aHeadingFarFromItsNominalIsRemarkedAtOnce()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.swing);
    open.trigger("layout8");
    open.table().goTo(1, ReadingColumn::Magnetic);
    open.type("54"); // for 45
    open.press(Qt::Key_Return);
    QVERIFY(!open.label("readingsMessage").contains("off its nominal")); // 9° off is near
    open.table().goTo(2, ReadingColumn::Magnetic);
    open.type("190"); // for 090, before its compass is read
    open.press(Qt::Key_Return);
    const QString said = open.label("readingsMessage");
    QVERIFY2(said.contains("190") && said.contains("090") && said.contains("100"), qPrintable(said));
    open.type("89");
    open.press(Qt::Key_Return);
    QVERIFY2(open.cell(2, ReadingColumn::State).contains("nominal"), qPrintable(open.cell(2, ReadingColumn::State)));
}

void KeyboardEntryTest::aMisreadSentenceStaysWithItsRow()
{
    SmallFleet fleet;
    auto readings = eightPoints();
    readings[3].second = 145; // 135: the next figure of the card
    const SwingId id = fleet.addSwing("2026-11-21", readings);
    OpenWindow open(fleet.stores);
    open.window.go(id);
    for (int row = 0; row < 8; ++row) {
        open.table().goTo(row, ReadingColumn::Compass);
        QVERIFY2(open.cell(3, ReadingColumn::State).contains("135"), qPrintable(open.cell(3, ReadingColumn::State)));
    }
    QVERIFY(open.cell(0, ReadingColumn::State).isEmpty());
    open.table().goTo(3, ReadingColumn::Compass);
    open.type("135");
    open.press(Qt::Key_Return);
    QVERIFY2(open.cell(3, ReadingColumn::State).isEmpty(), qPrintable(open.cell(3, ReadingColumn::State)));
}

void KeyboardEntryTest::whereHeadingsAreLaidOutTheCompassIsBlamed()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.swing);
    // Headings on exact steps; the compass of 090 is read as its neighbour.
    for (const auto& [magnetic, compass] : {std::pair{"0", "359"}, {"45", "44"}, {"90", "99"}}) {
        open.type(magnetic);
        open.press(Qt::Key_Return);
        open.type(compass);
        open.press(Qt::Key_Return);
    }
    open.table().goTo(2, ReadingColumn::Compass);
    QVERIFY2(!open.label("readingsMessage").contains("in the magnetic heading"), qPrintable(open.label("readingsMessage")));
}

void KeyboardEntryTest::theClipboardHasItsKeysWithoutAWindow()
{
    SmallFleet fleet;
    const SwingId id = fleet.addSwing("2026-11-21", eightPoints());
    OpenWindow open(fleet.stores);
    open.window.go(id);
    open.table().goTo(4, ReadingColumn::Compass);
    QTest::keyClick(&open.table(), Qt::Key_X, Qt::ControlModifier);
    QVERIFY(!fleet.stores.swings.swing(id)->readings[4].compass);
    QTest::keyClick(&open.table(), Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(fleet.stores.swings.swing(id)->readings[4].compass->degrees(), 180.0);
    QCOMPARE(open.window.undoStack().count(), 2);
    QTest::keyClick(&open.window, Qt::Key_Y, Qt::ControlModifier); // nothing to redo
    QTest::keyClick(&open.window, Qt::Key_Z, Qt::ControlModifier);
    QTest::keyClick(&open.window, Qt::Key_Z, Qt::ControlModifier);
    QTest::keyClick(&open.window, Qt::Key_Y, Qt::ControlModifier);
    QVERIFY(!fleet.stores.swings.swing(id)->readings[4].compass);
}

QTEST_MAIN(KeyboardEntryTest)
#include "KeyboardEntryTest.moc"
