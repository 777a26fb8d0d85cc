// A click or Enter on a coefficient opens where it comes from, with the figures of this swing.

#include <QTableWidget>
#include <QTextBrowser>

#include "tests/ui/window/Fixture.h"
#include "ui/swing/DerivationPanel.h"

using namespace lubberline;
using namespace lubberline::ui;

class DerivationPanelTest : public QObject {
    Q_OBJECT

private slots:
    void aClickOpensTheFormulaWithTheSwingsFigures()
    {
        SmallFleet fleet;
        // The check swing of the worksheet examples (QNSC PEWB), question 1: A = 3°.
        const SwingId id
            = fleet.addSwing("2026-11-20", {{317, 316}, {0, 358}, {47, 42}, {93, 89}, {135, 134}, {179, 177}, {225, 220}, {273, 269}});
        OpenWindow open(fleet.stores);
        open.window.go(id);
        auto& table = open.find<QTableWidget>("coefficients");
        emit table.cellClicked(0, 4);
        auto& text = open.find<QTextBrowser>("derivationText");
        QVERIFY(text.isVisible());
        QVERIFY2(text.toPlainText().contains("A (point rule) = +3.00°"), qPrintable(text.toPlainText()));
        QVERIFY(text.toPlainText().contains("/ 8"));
        table.setFocus();
        table.setCurrentCell(1, 0);
        QTest::keyClick(&table, Qt::Key_Return);
        const QString said = text.toPlainText();
        QVERIFY2(said.contains("B (approximate) = " + table.item(1, 0)->text() + "°"), qPrintable(said));
        QVERIFY(said.contains("B sin") && said.contains("95 %") && said.contains("317.0°"));
        table.setCurrentCell(4, 2);
        QTest::keyClick(&table, Qt::Key_Return);
        QVERIFY(text.toPlainText().contains("E (exact) = " + table.item(4, 2)->text()));
        QTest::keyClick(&text, Qt::Key_Escape);
        QVERIFY(!text.isVisible());
        QVERIFY(table.hasFocus());
    }

    void itFollowsTheReadings()
    {
        SmallFleet fleet;
        const SwingId id = fleet.addSwing("2026-11-20", eightPoints());
        OpenWindow open(fleet.stores);
        open.window.go(id);
        emit open.find<QTableWidget>("coefficients").cellClicked(2, 0);
        const QString before = open.find<QTextBrowser>("derivationText").toPlainText();
        open.table().goTo(0, ReadingColumn::Compass);
        open.type("3");
        open.press(Qt::Key_Return);
        const QString after = open.find<QTextBrowser>("derivationText").toPlainText();
        QVERIFY(after != before);
        QVERIFY(after.contains(open.find<QTableWidget>("coefficients").item(2, 0)->text()));
    }

    void whatCannotBeToldSaysSo()
    {
        SmallFleet fleet;
        const SwingId id = fleet.addSwing("2026-11-20", {{0, 358}, {90, 88}, {180, 181}, {270, 272}});
        OpenWindow open(fleet.stores);
        open.window.go(id);
        emit open.find<QTableWidget>("coefficients").cellClicked(3, 4);
        QVERIFY(open.find<QTextBrowser>("derivationText").toPlainText().contains("cannot tell"));
    }
};

QTEST_MAIN(DerivationPanelTest)
#include "DerivationPanelTest.moc"
