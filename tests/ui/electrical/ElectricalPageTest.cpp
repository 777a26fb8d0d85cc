// Electrical swings: the steps of the sheet, its verdict, and the swing that is made of it.

#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QUndoStack>

#include "tests/ui/window/Fixture.h"
#include "tests/ui/window/Typing.h"
#include "ui/electrical/ElectricalPage.h"
#include "ui/electrical/ElectricalSteps.h"
#include "ui/kit/EditContext.h"

namespace lubberline::ui {

class ElectricalPageTest : public QObject {
    Q_OBJECT

private slots:
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
        QUndoStack stack;
        EditContext context{fleet.stores, [](const Error&) {}};
        ElectricalPage page(context, stack, [] { return kToday; });
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

    void everyCellIsUndoneAndTheSheetToo()
    {
        SmallFleet fleet;
        QUndoStack stack;
        EditContext context{fleet.stores, [](const Error&) {}};
        ElectricalPage page(context, stack, [] { return kToday; });
        page.show();
        QVERIFY(page.showCompass(fleet.compass));
        in<QPushButton>(page, "newElectrical").click();
        auto& sheet = in<QTableWidget>(page, "tableF1");
        typeCell(sheet, 0, 2, "0.3");
        typeCell(sheet, 0, 2, "0.4");
        const auto indicated = [&] { return fleet.stores.electrical.of(fleet.compass)->front().after.indicated_deg[0]; };
        stack.undo();
        QCOMPARE(*indicated(), 0.3);
        QCOMPARE(sheet.item(0, 2)->text().toDouble(), 0.3); // the page shows what is stored
        stack.undo();
        QVERIFY(!indicated());
        stack.undo();
        QVERIFY(fleet.stores.electrical.of(fleet.compass)->empty());
        while (stack.canRedo())
            stack.redo();
        QCOMPARE(*indicated(), 0.4);
    }
};

} // namespace lubberline::ui

QTEST_MAIN(lubberline::ui::ElectricalPageTest)
#include "ElectricalPageTest.moc"
