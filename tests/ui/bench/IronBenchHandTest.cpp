// The bench by hand: parts dragged, rows duplicated and removed, coefficients in a field, work that takes long.

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTimer>

#include "tests/ui/sensor/SensorPageFixture.h"
#include "ui/bench/BenchDrawing.h"
#include "ui/bench/BenchRows.h"
#include "ui/bench/IronBenchPage.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

/// A gear leg with two states and a ball, stored with the compass.
struct StoredBench {
    OpenPage fleet;
    IronBenchPage page{fleet.context, fleet.stack,
        {[](const QString&, const QString&) { return QString(); },
            [](const QString&, const QString&, const QString&) { return QString(); }}};

    explicit StoredBench(bool readOnly = false)
    {
        IronBench bench;
        bench.parts = {{"leg", Cylinder{0.1, 1}, 80, {0, 0, 0}, "gear", {{"up", {1.5, 1, 0}, 0, 0, 0}, {"down", {1.5, 1, 1}, 0, 0, 0}}},
            {"ball", Sphere{0.125}, 200, {0.1, 0, 0}, "", {{"", {-1, -1, 0.5}, 0, 0, 0}}}};
        bench.circuits = {
            {"light", {CurrentLoop{{1, 0, 0.5}, {0, 0, 1}, 0.25, 1}}, 10, true}, {"pump", {WirePath{{{1, 0, 0}, {2, 0, 0.5}}}}, 3, false}};
        SensorRecord sensor;
        sensor.compass = fleet.compass;
        sensor.name = "bench";
        sensor.origin = ModelOrigin::IronBench;
        sensor.bench = bench;
        sensor.benchStates = {{"gear", "down"}};
        sensor.model = benchModel(bench, sensor.benchStates)->model;
        static_cast<void>(*fleet.stores.save(sensor));
        if (readOnly)
            fleet.stores.makeReadOnly();
        page.resize(1100, 800);
        page.show();
        static_cast<void>(page.showCompass(fleet.compass).ok());
        QApplication::processEvents();
    }
    SensorRecord stored() { return fleet.stores.whole().sensors.front(); }
    QTableWidget& table(const char* name) { return *page.findChild<QTableWidget*>(QString::fromLatin1(name)); }
    void press(const char* name) { page.findChild<QPushButton*>(QString::fromLatin1(name))->click(); }
    BenchDrawing& drawing() { return *page.findChild<BenchDrawing*>(); }
    /// From the middle of a part to somewhere else, in one view.
    void drag(const Eigen::Vector3d& from_m, const Eigen::Vector3d& to_m, bool fromAbove)
    {
        const QPoint from = drawing().onScreen(from_m, fromAbove).toPoint(), to = drawing().onScreen(to_m, fromAbove).toPoint();
        QTest::mousePress(&drawing(), Qt::LeftButton, {}, from);
        QTest::mouseMove(&drawing(), (from + to) / 2);
        QTest::mouseMove(&drawing(), to);
        QTest::mouseRelease(&drawing(), Qt::LeftButton, {}, to);
    }
};

} // namespace

class IronBenchHandTest : public QObject {
    Q_OBJECT

private slots:
    void draggedPartIsStoredWhereItWasLet()
    {
        StoredBench open;
        QSignalSpy spoken(&open.page, &IronBenchPage::readOut);
        const double pixel_m = 1 / (open.drawing().onScreen({0, 0, 0}, true).x() - open.drawing().onScreen({1, 0, 0}, true).x());
        open.drag({-1, -1, 0.5}, {-0.5, -0.75, 0.5}, true);
        QTRY_VERIFY(open.fleet.stack.count() == 1);
        const Eigen::Vector3d above = open.stored().bench->parts[1].placements[0].centre_m;
        QVERIFY2((above - Eigen::Vector3d(-0.5, -0.75, 0.5)).norm() < 2 * pixel_m,
            qPrintable(QString("%1 %2 %3").arg(above.x()).arg(above.y()).arg(above.z())));
        QCOMPARE(above.z(), 0.5); // from above the height stays
        QVERIFY((open.stored().model.hardIron_nT - benchModel(*open.stored().bench, {{"gear", "down"}})->model.hardIron_nT).norm() < 1e-9);
        QVERIFY(spoken.count() > 0);
        open.drag(above, above + Eigen::Vector3d(0, 0, 0.4), false);
        QTRY_VERIFY(open.fleet.stack.count() == 2);
        const Eigen::Vector3d beside = open.stored().bench->parts[1].placements[0].centre_m;
        QCOMPARE(beside.y(), above.y());
        QVERIFY(std::abs(beside.z() - 0.9) < 2 * pixel_m);
        open.fleet.stack.undo();
        open.fleet.stack.undo();
        QCOMPARE(open.stored().bench->parts[1].placements[0].centre_m, Eigen::Vector3d(-1, -1, 0.5));
        QCOMPARE(open.table("benchParts").item(2, static_cast<int>(PartColumn::Centre))->text(), QString("-1 -1 0.5"));
    }

    void theStateThatIsShownIsMoved()
    {
        StoredBench open;
        open.drag({1.5, 1, 1}, {1, 1, 1}, true);
        QTRY_VERIFY(open.fleet.stack.count() == 1);
        QCOMPARE(open.stored().bench->parts[0].placements[0].centre_m, Eigen::Vector3d(1.5, 1, 0));
        QVERIFY(std::abs(open.stored().bench->parts[0].placements[1].centre_m.x() - 1) < 0.05);
    }

    void aPressAndEscapeMoveNothing()
    {
        StoredBench open;
        const QPoint at = open.drawing().onScreen({-1, -1, 0.5}, true).toPoint();
        QTest::mouseClick(&open.drawing(), Qt::LeftButton, {}, at);
        QCOMPARE(open.table("benchParts").currentRow(), 2);
        QTest::mousePress(&open.drawing(), Qt::LeftButton, {}, at);
        QTest::mouseMove(&open.drawing(), at + QPoint(40, 40));
        QTest::keyClick(&open.drawing(), Qt::Key_Escape);
        QTest::mouseRelease(&open.drawing(), Qt::LeftButton, {}, at + QPoint(40, 40));
        QTest::qWait(100);
        QCOMPARE(open.fleet.stack.count(), 0);
    }

    void aPartIsDuplicatedAndRemovedWithAllItsStates()
    {
        StoredBench open;
        open.table("benchParts").setCurrentCell(1, 0); // its second state
        open.press("benchDuplicate");
        QTRY_VERIFY(open.stored().bench->parts.size() == 3);
        QCOMPARE(open.stored().bench->parts[1].name, std::string("leg (copy)"));
        QCOMPARE(open.stored().bench->parts[1].placements, open.stored().bench->parts[0].placements);
        open.table("benchParts").setCurrentCell(0, 0);
        open.press("benchRemove");
        QTRY_VERIFY(open.stored().bench->parts.size() == 2);
        QCOMPARE(open.stored().bench->parts[0].name, std::string("leg (copy)"));
        QCOMPARE(open.stored().bench->parts[0].placements.size(), std::size_t(2));
    }

    void removeIsOfTheTableThatWasUsedLast()
    {
        StoredBench open;
        open.table("benchConductors").setCurrentCell(1, 0);
        open.press("benchRemove");
        QTRY_VERIFY(open.stored().bench->circuits.size() == 1);
        QCOMPARE(open.stored().bench->parts.size(), std::size_t(2));
        QCOMPARE(open.stored().bench->circuits[0].name, std::string("light"));
    }

    void coefficientsAreCoresInTheFieldThatIsSet()
    {
        StoredBench open;
        QTRY_VERIFY(open.page.result());
        auto& terms = open.table("smithTerms");
        const auto shown = [&](Coefficient coefficient) { return terms.item(static_cast<int>(indexOf(coefficient)), 1)->text(); };
        auto& H = *open.page.findChild<QDoubleSpinBox*>("field_H");
        auto& dip = *open.page.findChild<QDoubleSpinBox*>("field_dip");
        H.setValue(12'000);
        dip.setValue(60);
        const auto expected = smithOf(open.page.result()->model, MeridianField::fromDip(12'000, toRadians(60)));
        QTRY_COMPARE(shown(Coefficient::B), signedNumber(expected->exact.B, 5));
        QCOMPARE(shown(Coefficient::D), signedNumber(expected->exact.D, 5));
    }

    void readOnlyBenchesAreLookedAt()
    {
        StoredBench open(true);
        QTRY_VERIFY(open.page.result());
        QVERIFY(!open.page.findChild<QPushButton*>("benchAddPart")->isEnabled());
        open.drag({-1, -1, 0.5}, {0, 0, 0.5}, true);
        QTest::qWait(100);
        QCOMPARE(open.fleet.stack.count(), 0);
        QCOMPARE(open.table("benchParts").editTriggers(), QAbstractItemView::NoEditTriggers);
    }

    void wrongTurnsAreSaid()
    {
        StoredBench open;
        auto& cell = *open.table("benchConductors").item(0, static_cast<int>(ConductorColumn::Geometry));
        for (const char* turns : {"1e99", "0", "-3", "1.5"}) {
            cell.setText(QString("1 0 0; 0 0 1; 0.2; %1").arg(turns));
            QVERIFY2(open.page.findChild<QLabel*>("benchMessage")->text().contains("turns"), turns);
        }
        QCOMPARE(open.fleet.stack.count(), 0);
    }

    /// Ten thousand parts, some of them with tensors of their own: the window goes on while they are computed, and can stop
    /// them.
    void theWindowGoesOnWhileItIsComputed()
    {
        StoredBench open;
        SensorRecord many = open.stored();
        many.benchStates.clear();
        many.bench->parts.clear();
        for (int i = 0; i < 10'000; ++i)
            many.bench->parts.push_back({"part " + std::to_string(i), Box{{0.1, 0.05, 0.02 + (i % 25 ? 0 : 1e-6 * i)}}, 100, {0, 0, 0}, "",
                {{"", {i % 25 ? 2.0 + 0.001 * i : 0.15, 0.1 + 1e-6 * i, 0.1}, 0, 0, 0}}});
        QVERIFY(open.fleet.stores.save(many).ok()); // the page follows
        auto& cancel = *open.page.findChild<QPushButton*>("benchCancel");
        QTRY_VERIFY_WITH_TIMEOUT(cancel.isVisible(), 30'000);
        int ticks = 0;
        QTimer tick;
        connect(&tick, &QTimer::timeout, this, [&ticks] { ++ticks; });
        tick.start(20);
        QTRY_VERIFY_WITH_TIMEOUT(ticks >= 20, 30'000);
        QVERIFY(cancel.isVisible()); // still at work
        cancel.click();
        QTRY_VERIFY_WITH_TIMEOUT(open.page.findChild<QLabel*>("benchMessage")->text().contains("cancelled"), 30'000);
        QVERIFY(!cancel.isVisible());
    }
};

QTEST_MAIN(IronBenchHandTest)
#include "IronBenchHandTest.moc"
