// The pages of the sensor in the Earth's field, reached as a person reaches them: from a swing, by menu; undo comes back to
// them.

#include <QAction>
#include <QPushButton>

#include "tests/ui/window/Fixture.h"
#include "ui/bench/IronBenchPage.h"
#include "ui/earth/EarthFieldPage.h"
#include "ui/earth/PredictionPage.h"
#include "ui/sensor/SensorPage.h"

using namespace lubberline;
using namespace lubberline::ui;

class ModelPagesTest : public QObject {
    Q_OBJECT

private slots:
    void actionsNeedACompassOrASwing()
    {
        SmallFleet fleet;
        OpenWindow open(fleet.stores);
        QVERIFY(!open.find<QAction>("sensorModel").isEnabled());
        QVERIFY(!open.find<QAction>("predict").isEnabled());
        QVERIFY(open.find<QAction>("earthField").isEnabled());
        open.window.go(fleet.compass);
        QVERIFY(open.find<QAction>("sensorModel").isEnabled());
        QVERIFY(open.find<QAction>("ironBench").isEnabled());
        QVERIFY(!open.find<QAction>("predict").isEnabled());
        open.window.go(fleet.swing);
        QVERIFY(open.find<QAction>("predict").isEnabled());
    }

    void eachPageComesWithTheCompassOfTheSwing()
    {
        SmallFleet fleet;
        const SwingId id = fleet.addSwing("2026-11-21", eightPoints());
        OpenWindow open(fleet.stores);
        open.window.go(id);
        open.trigger("sensorModel");
        QVERIFY(open.window.findChild<SensorPage*>()->isVisible());
        QCOMPARE(open.window.findChild<SensorPage*>()->compass(), fleet.compass);
        open.trigger("ironBench"); // from the sensor's page: the same compass
        QVERIFY(open.window.findChild<IronBenchPage*>()->isVisible());
        QCOMPARE(open.window.findChild<IronBenchPage*>()->compass(), fleet.compass);
        open.trigger("earthField");
        QVERIFY(open.window.findChild<EarthFieldPage*>()->isVisible());
        open.window.go(id);
        open.trigger("predict");
        QVERIFY(open.window.findChild<PredictionPage*>()->isVisible());
        QVERIFY2(open.label("predictionVerdict").contains("field of the swing"),
            qPrintable(open.label("predictionVerdict"))); // no site is stated
        QVERIFY(open.window.messages().messages().isEmpty());
    }

    void undoComesBackToTheBench()
    {
        SmallFleet fleet;
        OpenWindow open(fleet.stores);
        open.window.go(fleet.compass);
        open.trigger("ironBench");
        open.find<QPushButton>("benchAddPart").click();
        QTRY_COMPARE(fleet.stores.whole().sensors.size(), std::size_t(1));
        open.window.go(fleet.swing);
        open.trigger("undo");
        QCOMPARE(fleet.stores.whole().sensors.size(), std::size_t(0));
        QVERIFY(open.window.findChild<SensorPage*>()->isVisible()); // where its models are seen
        open.trigger("redo");
        QCOMPARE(fleet.stores.whole().sensors.size(), std::size_t(1));
    }
};

QTEST_MAIN(ModelPagesTest)
#include "ModelPagesTest.moc"
