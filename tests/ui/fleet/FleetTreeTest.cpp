// The tree asks for children only when they are wanted, and tells views what changed.

#include <QAbstractItemModelTester>
#include <QLineEdit>
#include <QListWidget>
#include <QSet>
#include <QSignalSpy>
#include <QTreeView>

#include <map>

#include "tests/ui/window/Fixture.h"
#include "ui/fleet/FleetModel.h"
#include "ui/window/PageStack.h"

using namespace lubberline;
using namespace lubberline::ui;

class FleetTreeTest : public QObject {
    Q_OBJECT

private slots:
    void asksOnlyWhatIsOpened();
    void refreshKeepsPlaces();
    void badgeFollowsTheReadings();
    void swingsOfOneDayAreToldApart();
    void bothColumnsAreInSight();
    void nothingIsAskedBeforeTheFirstPaint();
    void searchFindsAndGoes();
    void whatIsFoundKeepsUpWithWhatIsShown();
    void aPageBehindHearsOfTheFleetWhenItComesToTheFront();
};

void FleetTreeTest::asksOnlyWhatIsOpened()
{
    SmallFleet fleet;
    fleet.stores.watch().forget();
    FleetModel model(fleet.stores);
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    fleet.stores.watch().forget();
    FleetModel lazy(fleet.stores);
    QVERIFY(fleet.stores.watch().nothingAsked());
    lazy.fetchMore({});
    QCOMPARE(lazy.rowCount(), 1);
    QCOMPARE(fleet.stores.watch().aircraftAsked, 0);
    const QModelIndex type = lazy.index(0, 0);
    QVERIFY(lazy.hasChildren(type)); // known without asking
    QVERIFY(lazy.canFetchMore(type));
    lazy.fetchMore(type);
    const QModelIndex aircraft = lazy.index(0, 0, type);
    QCOMPARE(aircraft.data().toString(), QStringLiteral("3713"));
    QCOMPARE(fleet.stores.watch().swingsAsked, 0);
    lazy.fetchMore(aircraft);
    lazy.fetchMore(lazy.index(0, 0, aircraft));
    QCOMPARE(fleet.stores.watch().swingsAsked, 1);
    QVERIFY(lazy.index(0, 0, lazy.index(0, 0, aircraft)).data().toString().startsWith("2026-11-20"));
}

void FleetTreeTest::refreshKeepsPlaces()
{
    SmallFleet fleet;
    FleetModel model(fleet.stores);
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    const QPersistentModelIndex swing = model.find({fleet.type, fleet.aircraft, fleet.compass, fleet.swing});
    QVERIFY(std::holds_alternative<SwingId>(model.item(swing)));
    const SwingId newer = fleet.addSwing("2027-01-05", {});
    QSignalSpy resets(&model, &QAbstractItemModel::modelReset);
    model.refresh();
    QVERIFY(swing.isValid());
    QCOMPARE(swing.row(), 1); // the newer one is before it
    QCOMPARE(resets.count(), 0);
    QVERIFY(model.item(model.index(0, 0, swing.parent())) == FleetItem(newer));
    QVERIFY(fleet.stores.swings.remove(fleet.swing).ok());
    model.refresh();
    QVERIFY(!swing.isValid());
}

void FleetTreeTest::badgeFollowsTheReadings()
{
    SmallFleet fleet;
    FleetModel model(fleet.stores);
    const QModelIndex type = model.find({fleet.type});
    QCOMPARE(type.siblingAtColumn(FleetModel::Badge).data().toString(), QStringLiteral("not known"));
    fleet.addSwing("2027-01-05", eightPoints());
    model.refresh();
    QCOMPARE(type.siblingAtColumn(FleetModel::Badge).data().toString(), QStringLiteral("in limits"));
    auto beyond = eightPoints();
    for (auto& [magnetic_deg, compass_deg] : beyond)
        compass_deg -= 9.0;
    fleet.addSwing("2027-01-06", beyond);
    model.refresh();
    QCOMPARE(type.siblingAtColumn(FleetModel::Badge).data().toString(), QStringLiteral("out of limits"));
    QVERIFY(!type.siblingAtColumn(FleetModel::Badge).data(Qt::DecorationRole).value<QIcon>().isNull());
}

/// A correction leaves two swings as found of one compass on one day.
void FleetTreeTest::swingsOfOneDayAreToldApart()
{
    SmallFleet fleet;
    const auto add = [&fleet](SwingKind kind, std::size_t readings) {
        auto points = eightPoints();
        points.resize(readings);
        const SwingId id = fleet.addSwing("2027-01-05", points);
        const Swing before = *fleet.stores.swings.swing(id);
        Swing after = before;
        after.kind = kind;
        return fleet.stores.swings.change(before, after).ok();
    };
    QVERIFY(add(SwingKind::Check, 8) && add(SwingKind::Correction, 4) && add(SwingKind::Correction, 3));
    FleetModel model(fleet.stores);
    const QModelIndex compass = model.find({fleet.type, fleet.aircraft, fleet.compass});
    model.fetchMore(compass);
    QSet<QString> names;
    for (int row = 0; row < model.rowCount(compass); ++row)
        names += model.index(row, 0, compass).data().toString();
    QCOMPARE(names.size(), 4);
    QVERIFY2(std::any_of(names.begin(), names.end(),
                 [](const QString& name) { return name.contains("correction") && name.contains("readings: 3"); }),
        qPrintable(names.values().join('|')));
}

/// However long a name is, the sign beside it says whether the aircraft is out of limits.
void FleetTreeTest::bothColumnsAreInSight()
{
    SmallFleet fleet;
    Aircraft another;
    another.type = fleet.type;
    another.registration = "a registration that is longer than any tree is wide on a small screen";
    QVERIFY(fleet.stores.save(another));
    OpenWindow open(fleet.stores);
    auto& tree = *open.window.findChild<QTreeView*>("fleetTree");
    QTRY_VERIFY(tree.model());
    tree.expandAll();
    QTRY_COMPARE(tree.columnWidth(FleetModel::Name) + tree.columnWidth(FleetModel::Badge), tree.viewport()->width());
    QVERIFY(tree.columnWidth(FleetModel::Badge) >= 40);
}

void FleetTreeTest::nothingIsAskedBeforeTheFirstPaint()
{
    SmallFleet fleet;
    fleet.stores.watch().forget();
    AnsweringDialogs dialogs;
    QTemporaryDir folder;
    QSettings settings(folder.filePath("settings.ini"), QSettings::IniFormat);
    MainWindow window(fleet.stores, {dialogs, settings, [] {}, {}});
    bool askedBefore = false;
    QSignalSpy painted(&window, &MainWindow::firstPainted);
    connect(&window, &MainWindow::firstPainted, this, [&] { askedBefore = !fleet.stores.watch().nothingAsked(); });
    window.show();
    QTRY_COMPARE(painted.count(), 1);
    QVERIFY(!askedBefore);
    QTRY_VERIFY(fleet.stores.watch().typesAsked > 0);
    QCOMPARE(fleet.stores.watch().swingsAsked, 0);
}

void FleetTreeTest::searchFindsAndGoes()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.trigger("search");
    auto& words = open.find<QLineEdit>("searchLine");
    QTest::keyClicks(&words, "371");
    QTest::keyClick(&words, Qt::Key_Return);
    QCOMPARE(open.find<QListWidget>("searchHits").count(), 3); // the aircraft first, its compass, its swing
    QCOMPARE(open.label("aircraftTitle"), QStringLiteral("Su-22 · 3713"));
    QTest::keyClick(&words, Qt::Key_Escape);
    QVERIFY(open.find<QTreeView>("fleetTree").isVisible());
}

void FleetTreeTest::whatIsFoundKeepsUpWithWhatIsShown()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    auto& words = open.find<QLineEdit>("searchLine");
    auto& hits = open.find<QListWidget>("searchHits");
    QTest::keyClicks(&words, "371");
    QTRY_COMPARE(hits.count(), 3);
    QCOMPARE(hits.currentRow(), -1); // nothing of it is shown
    open.window.go(fleet.swing);
    QCOMPARE(hits.currentRow(), 2);
    const SwingId another = fleet.addSwing("2026-11-25", {});
    fleet.stores.changes().announceFleet();
    QCOMPARE(hits.count(), 4);
    QVERIFY(hits.currentItem()->text().contains("2026-11-20")); // the one that is shown, wherever it stands now
    open.window.go(another);
    QVERIFY(hits.currentItem()->text().contains("2026-11-25"));
}

namespace {

struct HearingPage final : Page {
    int heard = 0;
    bool isOf(const FleetItem&) const override { return true; } // a list
    void fleetChanged() override { ++heard; }
};

} // namespace

void FleetTreeTest::aPageBehindHearsOfTheFleetWhenItComesToTheFront()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    EditContext edits{fleet.stores, [](const Error&) {}};
    QUndoStack undo;
    PageContext context{fleet.stores, edits, undo, open.settings, open.dialogs, open.window, {}};
    std::map<QString, HearingPage*> made;
    const auto page = [&made](const QString& id) { return PageDescription{id, [&made, id] { return made[id] = new HearingPage; }}; };
    PageStack stack(context, {page("front"), page("behind")});
    QVERIFY(stack.show(Destination{"behind"}));
    QVERIFY(stack.show(Destination{"front"}));
    stack.fleetChanged();
    stack.fleetChanged();
    QCOMPARE(made["front"]->heard, 2);
    QCOMPARE(made["behind"]->heard, 0); // it would work for nobody
    QVERIFY(stack.show(Destination{"behind"}));
    QCOMPARE(made["behind"]->heard, 1);
    QVERIFY(stack.show(Destination{"front"}));
    QVERIFY(stack.show(Destination{"behind"}));
    QCOMPARE(made["behind"]->heard, 1);
}

QTEST_MAIN(FleetTreeTest)
#include "FleetTreeTest.moc"
