// Finding one's way: what the overview opens with, which compass an aircraft opens on, what the tree keeps.

#include <QCloseEvent>
#include <QDockWidget>
#include <QScreen>
#include <QTableWidget>
#include <QTreeView>

#include "tests/ui/window/Fixture.h"
#include "ui/fleet/AircraftPage.h"
#include "ui/fleet/FleetPanel.h"
#include "ui/window/PageStack.h"

using namespace lubberline;
using namespace lubberline::ui;

class FindingTest : public QObject {
    Q_OBJECT

private slots:
    void anAircraftOpensOnItsWorstCompassAndShowsAll();
    void theOverviewOpensWithWhatNeedsAHand();
    void theTreeSaysWhatDistinguishesAndKeepsItsBranches();
    void whatWasNotClosedIsFoundAgain();
    void eachDatabaseKeepsItsOwnBranches();
    void aPageThatWasAskedForTakesTheKeys();
    void aWindowIsNeverRestoredLargerThanItsScreen();
};

void FindingTest::anAircraftOpensOnItsWorstCompassAndShowsAll()
{
    SmallFleet fleet;
    fleet.addSwing("2026-11-21", eightPoints());
    CompassSystem gyro = *fleet.stores.fleet.compass(fleet.compass);
    gyro.id = {};
    gyro.record.clear();
    gyro.name = "gyrosyn compass";
    const CompassId worst = *fleet.stores.save(gyro);
    std::vector<std::pair<double, double>> far = eightPoints();
    for (auto& [magnetic, compass] : far)
        magnetic += 15;
    const CompassId first = std::exchange(fleet.compass, worst);
    fleet.addSwing("2026-11-22", far);
    OpenWindow open(fleet.stores);
    open.window.go(fleet.aircraft);
    auto& page = dynamic_cast<AircraftPage&>(open.window.findChild<PageStack*>()->current());
    QCOMPARE(page.compass(), worst);
    QCOMPARE(open.label("aircraftTitle"), QString::fromUtf8("Su-22 · 3713"));
    QCOMPARE(open.label("shownCompass"), QString("gyrosyn compass"));
    QVERIFY(open.window.windowTitle().contains("gyrosyn compass"));
    auto& table = open.find<QTableWidget>("compassTable");
    QCOMPARE(table.rowCount(), 2);
    QStringList states;
    for (int row = 0; row < 2; ++row)
        states += table.item(row, 0)->text() + ": " + table.item(row, 2)->text();
    QVERIFY2(
        states.contains("gyrosyn compass: out of limits") && states.contains("standby compass: in limits"), qPrintable(states.join("; ")));
    for (int row = 0; row < 2; ++row)
        if (table.item(row, 0)->text() == "standby compass")
            table.setCurrentCell(row, 0);
    QCOMPARE(page.compass(), first);
    QCOMPARE(open.label("shownCompass"), QString("standby compass"));
    QCOMPARE(open.find<QTreeView>("fleetTree").currentIndex().data().toString(), QString("standby compass"));
}

void FindingTest::theOverviewOpensWithWhatNeedsAHand()
{
    SmallFleet fleet;
    std::vector<std::pair<double, double>> far = eightPoints();
    for (auto& [magnetic, compass] : far)
        magnetic += 15;
    const SwingId out = fleet.addSwing("2026-11-22", far);
    QVERIFY(fleet.stores.signing.complete(out));
    OpenWindow open(fleet.stores);
    auto& today = open.find<QTableWidget>("overviewToday");
    QVERIFY(today.isVisible());
    const auto rows = [&] {
        QStringList all;
        for (int row = 0; row < today.rowCount(); ++row)
            all += today.item(row, 0)->text() + ": " + today.item(row, 1)->text() + ": " + today.item(row, 2)->text();
        return all;
    };
    QTRY_VERIFY2(!rows().filter("OUT OF LIMITS by the swing of 2026-11-22").isEmpty(), qPrintable(rows().join('\n'))); // found on a worker
    QVERIFY2(rows().front().startsWith(QString::fromUtf8("due: 3713 · standby compass: ")), qPrintable(rows().front()));
    QVERIFY2(rows().filter("swung: ").front().contains("2026-11-22, complete, out of limits"), qPrintable(rows().join('\n')));
    today.setFocus();
    today.setCurrentCell(0, 0);
    QTest::keyClick(&today, Qt::Key_Return);
    QCOMPARE(open.window.findChild<PageStack*>()->description()->id, QString("aircraft"));
    open.trigger("back");
    QCOMPARE(open.window.findChild<PageStack*>()->description()->id, QString("overview"));
}

void FindingTest::theTreeSaysWhatDistinguishesAndKeepsItsBranches()
{
    SmallFleet fleet;
    Swing left = *fleet.stores.swings.swing(fleet.addSwing("2026-11-22", eightPoints()));
    left.stage = SwingStage::AsLeft;
    QVERIFY(fleet.stores.put(left));
    AnsweringDialogs dialogs;
    QTemporaryDir folder;
    QSettings settings(folder.filePath("settings.ini"), QSettings::IniFormat);
    int width = 0;
    for (int run = 0; run < 2; ++run) {
        MainWindow window(fleet.stores, {dialogs, settings, {}, {}});
        window.show();
        QApplication::processEvents();
        QApplication::processEvents();
        auto& tree = *window.findChild<QTreeView*>("fleetTree");
        if (run == 0) {
            window.go(left.id);
            QCOMPARE(tree.currentIndex().data().toString(), QString("2026-11-22 as left"));
            window.resizeDocks({window.findChild<QDockWidget*>("fleetDock")}, {351}, Qt::Horizontal);
            QApplication::processEvents();
            width = window.findChild<QDockWidget*>("fleetDock")->width();
            window.close();
            continue;
        }
        const QModelIndex type = tree.model()->index(0, 0), aircraft = tree.model()->index(0, 0, type);
        QVERIFY(tree.isExpanded(type) && tree.isExpanded(aircraft) && tree.isExpanded(tree.model()->index(0, 0, aircraft)));
        QCOMPARE(window.findChild<QDockWidget*>("fleetDock")->width(), width);
        QCOMPARE(tree.textElideMode(), Qt::ElideNone);
        for (int row = 0; row < 2; ++row) {
            const QModelIndex swing = tree.model()->index(row, 0, tree.model()->index(0, 0, aircraft));
            QTRY_VERIFY(tree.visualRect(swing).width() >= tree.fontMetrics().horizontalAdvance(swing.data().toString()));
        }
    }
}

/// As after a kill: what is kept at the end only would be lost.
void FindingTest::whatWasNotClosedIsFoundAgain()
{
    SmallFleet fleet;
    OpenWindow killed(fleet.stores);
    auto& before = killed.find<QTreeView>("fleetTree");
    const QModelIndex type = before.model()->index(0, 0);
    before.expand(type);
    before.expand(before.model()->index(0, 0, type));
    killed.window.resize(1010, 655);
    const auto branches = [&killed] {
        const QStringList keys = killed.settings.allKeys().filter("tree/open/");
        return keys.size() == 1 ? killed.settings.value(keys.front()).toStringList().size() : -1;
    };
    QTRY_COMPARE(branches(), 2);
    QTRY_VERIFY(!killed.settings.value("window/geometry").toByteArray().isEmpty());

    OpenWindow again(fleet.stores, false, &killed.settings);
    const auto& tree = again.find<QTreeView>("fleetTree");
    QVERIFY(tree.isExpanded(tree.model()->index(0, 0)));
    QVERIFY(tree.isExpanded(tree.model()->index(0, 0, tree.model()->index(0, 0))));
    before.collapse(type);
    QTRY_COMPARE(branches(), 0);
}

/// Two databases give the same ids to different records.
void FindingTest::eachDatabaseKeepsItsOwnBranches()
{
    SmallFleet one, other;
    OpenWindow first(one.stores);
    auto& tree = first.find<QTreeView>("fleetTree");
    tree.expand(tree.model()->index(0, 0));
    first.window.close();
    {
        OpenWindow second(other.stores, false, &first.settings);
        const auto& another = second.find<QTreeView>("fleetTree");
        QVERIFY(!another.isExpanded(another.model()->index(0, 0)));
        second.window.close();
        OpenWindow back(one.stores, false, &second.settings);
        const auto& again = back.find<QTreeView>("fleetTree");
        QVERIFY(again.isExpanded(again.model()->index(0, 0)));
    }
    // By another name it is the same file.
    const QString path = one.stores.location(), link = QFileInfo(path).absolutePath() + "/link.lubberline";
    QVERIFY(QFile::link(path, link));
    auto database = db::openDatabase(link, db::OpenMode::ReadWriteCreate);
    QVERIFY(database);
    db::Stores linked(std::move(*database));
    OpenWindow third(linked, false, &first.settings);
    const auto& same = third.find<QTreeView>("fleetTree");
    QVERIFY(same.isExpanded(same.model()->index(0, 0)));
}

void FindingTest::aPageThatWasAskedForTakesTheKeys()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    for (const char* command : {"twoMinuteCheck", "compareCompasses", "electricalSwings", "sensorModel"}) {
        open.window.go(fleet.compass);
        open.trigger("search");
        QCOMPARE(open.window.focusWidget()->objectName(), QString("searchLine"));
        open.trigger(command);
        QVERIFY2(open.window.findChild<PageStack*>()->current().isAncestorOf(open.window.focusWidget()), command);
    }
}

void FindingTest::aWindowIsNeverRestoredLargerThanItsScreen()
{
    SmallFleet fleet;
    AnsweringDialogs dialogs;
    QTemporaryDir folder;
    QSettings settings(folder.filePath("settings.ini"), QSettings::IniFormat);
    {
        QMainWindow large;
        large.setGeometry(300, 300, 1782, 936);
        large.show();
        settings.setValue("window/geometry", large.saveGeometry());
    }
    MainWindow window(fleet.stores, {dialogs, settings, {}, {}});
    window.show();
    QApplication::processEvents();
    const QRect room = window.screen()->availableGeometry();
    QVERIFY2(window.width() <= room.width() && window.height() <= room.height() && room.contains(window.pos()),
        qPrintable(QStringLiteral("%1×%2 on %3×%4").arg(window.width()).arg(window.height()).arg(room.width()).arg(room.height())));
}

QTEST_MAIN(FindingTest)
#include "FindingTest.moc"
