// The bench typed in tables: what core computes is shown and stored; what cannot be is said and changes nothing.

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>

#include "tests/ui/sensor/SensorPageFixture.h"
#include "ui/bench/BenchRows.h"
#include "ui/bench/IronBenchPage.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

IronBench someBench()
{
    IronBench bench;
    bench.sensor_m = {0.5, 0, -0.25};
    FerrousPart engine{"engine", Cylinder{0.5, 1.25}, 50, {0.02, 0, 0.01}, "", {{"", {3, 0.5, 0.125}, 0, 0, toRadians(30)}}};
    FerrousPart leg{"gear leg", Box{{0.125, 0.125, 1}}, 100, {0, 0, 0}, "gear",
        {{"retracted", {1.5, 1, 0}, 0, toRadians(90), 0}, {"extended", {1.5, 1, 0.75}, 0, 0, 0}}};
    FerrousPart tank{"tank", Ellipsoid{{0.5, 0.25, 0.25}}, 5, {0, 0, 0}, "", {{"", {-2, 0, 0}, 0, 0, 0}}};
    FerrousPart ball{"ball", Sphere{0.125}, 200, {0, 0.5, 0}, "", {{"", {0.5, -2, 0}, 0, 0, 0}}};
    bench.parts = {engine, leg, tank, ball};
    bench.circuits
        = {{"generator", {WirePath{{{1, 0, 0}, {1, 1, 0}, {2, 1, 0.5}}}, CurrentLoop{{1, 0, 0.5}, {0, 0, 1}, 0.25, 12}}, 30, true}};
    return bench;
}

struct OpenBench {
    OpenPage fleet;
    IronBenchPage page{fleet.context, fleet.stack,
        {[this](const QString&, const QString&) { return fleet.answer; },
            [this](const QString&, const QString&, const QString&) { return fleet.answer; }}};
    QStringList failures;
    OpenBench()
    {
        QObject::connect(&page, &IronBenchPage::failed, &page, [this](const QString& message) { failures += message; });
        page.resize(1000, 700);
        page.show();
    }
    QTableWidget& table(const char* name) { return *page.findChild<QTableWidget*>(QString::fromLatin1(name)); }
    QString message() { return page.findChild<QLabel*>("benchMessage")->text(); }
    void press(const char* name) { page.findChild<QPushButton*>(QString::fromLatin1(name))->click(); }
    std::vector<SensorRecord> stored() { return fleet.stores.whole().sensors; }
};

} // namespace

class IronBenchPageTest : public QObject {
    Q_OBJECT

private slots:
    void rowsAreReadBackAsTheyWere()
    {
        const auto back = benchOf(rowsOf(someBench()));
        QVERIFY2(back, back ? "" : back.error().message.english().c_str());
        QCOMPARE(rowsOf(*back).parts, rowsOf(someBench()).parts);
        QCOMPARE(rowsOf(*back).conductors, rowsOf(someBench()).conductors);
        QVERIFY(back->circuits == someBench().circuits);
        QCOMPARE(back->parts.size(), std::size_t(4));
        QCOMPARE(back->parts[1].placements.size(), std::size_t(2));
    }

    void aPartIsAddedComputedAndStored()
    {
        OpenBench open;
        QVERIFY(open.page.showCompass(open.fleet.compass));
        open.press("benchAddPart");
        QTRY_COMPARE(open.stored().size(), std::size_t(1));
        const SensorRecord record = open.stored().front();
        QCOMPARE(record.origin, ModelOrigin::IronBench);
        QVERIFY(record.bench);
        const auto expected = benchModel(*record.bench);
        QVERIFY(expected);
        QVERIFY((record.model.softIron - expected->model.softIron).norm() < 1e-15);
        QVERIFY(record.model.softIron.norm() > 0);
        QCOMPARE(open.table("benchEffects").rowCount(), 1);
        // remanence typed: hard iron follows, one more edit that can be undone
        open.table("benchParts").item(0, static_cast<int>(PartColumn::Remanence))->setText("0.1 0 0");
        QTRY_VERIFY(open.stored().front().model.hardIron_nT.norm() > 0);
        open.fleet.stack.undo();
        QTRY_COMPARE(open.stored().front().model.hardIron_nT.norm(), 0.0);
        QTRY_COMPARE(open.table("benchParts").item(0, static_cast<int>(PartColumn::Remanence))->text(), QString("0 0 0"));
    }

    void whatCannotBeIsSaidAndNotStored()
    {
        OpenBench open;
        QVERIFY(open.page.showCompass(open.fleet.compass));
        open.press("benchAddPart");
        QTRY_COMPARE(open.stored().size(), std::size_t(1));
        auto& cell = *open.table("benchParts").item(0, static_cast<int>(PartColumn::Size));
        cell.setText("0.2 0.1");
        QVERIFY2(open.message().contains("row 1") && open.message().contains("expected 3"), qPrintable(open.message()));
        cell.setText("0.2 0.1 -0.1");
        QTRY_VERIFY2(open.message().contains("Not stored"), qPrintable(open.message()));
        open.table("benchParts").item(0, static_cast<int>(PartColumn::Shape))->setText("teapot");
        QVERIFY(open.message().contains("teapot"));
        QCOMPARE(std::get<Box>(open.stored().front().bench->parts[0].shape).size_m.z(), 0.1);
    }

    void theStateOfTheGearChangesTheModel()
    {
        OpenBench open;
        SensorRecord sensor;
        sensor.compass = open.fleet.compass;
        sensor.name = "bench";
        sensor.origin = ModelOrigin::IronBench;
        sensor.bench = someBench();
        sensor.model = benchModel(someBench())->model;
        QVERIFY(open.fleet.stores.save(sensor));
        QVERIFY(open.page.showCompass(open.fleet.compass));
        auto* gear = open.page.findChild<QComboBox*>("benchState_gear");
        QVERIFY(gear);
        QTRY_VERIFY(open.page.result());
        gear->setCurrentText("extended");
        emit gear->activated(gear->currentIndex());
        const auto extended = benchModel(someBench(), {{"gear", "extended"}});
        QTRY_VERIFY((open.stored().front().model.softIron - extended->model.softIron).norm() < 1e-15);
        QCOMPARE(open.stored().front().benchStates.at("gear"), std::string("extended"));
        QCOMPARE(open.table("benchEffects").rowCount(), 4);
        QVERIFY(!open.page.grab().toImage().isNull());
    }

    void benchesAreSavedAndLoaded()
    {
        QTemporaryDir folder;
        OpenBench open;
        QVERIFY(open.page.showCompass(open.fleet.compass));
        open.press("benchAddPart");
        QTRY_COMPARE(open.stored().size(), std::size_t(1));
        open.fleet.answer = folder.filePath("bench.json");
        open.press("benchSave");
        open.press("benchAddConductor");
        QTRY_COMPARE(open.stored().front().bench->circuits.size(), std::size_t(1));
        open.press("benchLoad");
        QTRY_COMPARE(open.stored().front().bench->circuits.size(), std::size_t(0));
        open.fleet.answer = folder.filePath("none.json");
        open.press("benchLoad");
        QCOMPARE(open.failures.size(), 1);
        QVERIFY(open.failures[0].contains("none.json"));
    }

    void tenThousandPartsCanBeCancelled()
    {
        IronBench bench;
        for (int i = 0; i < 10'000; ++i)
            bench.parts.push_back({"part " + std::to_string(i), Box{{0.1, 0.05, 0.02}}, 100, {0, 0, 0}, "",
                {{"", {0.3 + 0.001 * i, 0.2, 0.1}, 0, 0, 0.0005 * i}}});
        OpenBench open;
        SensorRecord sensor;
        sensor.compass = open.fleet.compass;
        sensor.name = "many";
        sensor.origin = ModelOrigin::IronBench;
        sensor.bench = bench;
        QVERIFY(open.fleet.stores.save(sensor));
        const auto shown = open.page.showCompass(open.fleet.compass);
        QVERIFY2(shown, shown ? "" : describe(shown.error()).c_str());
        auto* cancel = open.page.findChild<QPushButton*>("benchCancel");
        QTRY_VERIFY_WITH_TIMEOUT(cancel->isVisible() || open.page.result(), 30'000);
        cancel->click();
        QTRY_VERIFY_WITH_TIMEOUT(open.message().contains("cancelled") || open.page.result(), 30'000);
    }
};

QTEST_MAIN(IronBenchPageTest)
#include "IronBenchPageTest.moc"
