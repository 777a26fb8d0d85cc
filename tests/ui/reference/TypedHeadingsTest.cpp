// Figures typed into the tables of the check and of two compasses, key by key: a row is read at once, an empty cell is one to type into.

#include <QLineEdit>
#include <QTableWidget>
#include <QTest>

#include "tests/ui/window/Fixture.h"
#include "ui/reference/CheckPage.h"
#include "ui/reference/ComparePage.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

/// With Enter after each of them.
void typeInto(QTableWidget& table, std::initializer_list<const char*> texts)
{
    const auto press = [&table](int key) {
        QWidget* editor = table.findChild<QLineEdit*>();
        QTest::keyClick(editor ? editor : &table, static_cast<Qt::Key>(key));
    };
    for (const char* text : texts) {
        for (const char* key = text; *key; ++key) {
            QWidget* editor = table.findChild<QLineEdit*>();
            QTest::keyClick(editor ? editor : &table, *key);
        }
        press(Qt::Key_Return);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
}

} // namespace

class TypedHeadingsTest : public QObject {
    Q_OBJECT

private slots:
    void twoCompasses()
    {
        SmallFleet fleet;
        ComparePage page(fleet.stores, {});
        QVERIFY(page.open(FleetItem(fleet.compass)).ok());
        page.show();
        auto& table = *page.findChild<QTableWidget*>("compareTable");
        table.setFocus();
        table.setCurrentCell(0, 0);
        typeInto(table, {"0", "4", "", "90", "94", "95"});
        QCOMPARE(table.item(0, 0)->text(), QString("0"));
        QCOMPARE(table.item(0, 1)->text(), QString("4"));
        QCOMPARE(table.item(1, 2)->text(), QString("95"));
        QCOMPARE(page.verdict()->readings, std::size_t(2));
        QCOMPARE(table.currentRow(), 2);
    }

    void theCheck()
    {
        SmallFleet fleet;
        CheckPage page(fleet.stores, {});
        QVERIFY(page.open(FleetItem(fleet.compass)).ok());
        page.show();
        auto& table = *page.findChild<QTableWidget*>("checkTable");
        table.setFocus();
        typeInto(table, {"31.5", "30", "152"});
        QCOMPARE(table.item(0, 1)->text(), QString("31.5"));
        QCOMPARE(table.item(0, 2)->text(), QString("30"));
        QCOMPARE(table.item(1, 1)->text(), QString("152"));
    }
};

QTEST_MAIN(TypedHeadingsTest)
#include "TypedHeadingsTest.moc"
