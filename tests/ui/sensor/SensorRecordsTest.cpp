// The sensor models of a compass: made, loaded, estimated, removed and brought back; what may not be stored is not.

#include <QCheckBox>
#include <QFile>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QToolButton>

#include "core/format/exchange/ModelJson.h"
#include "tests/ui/sensor/SensorPageFixture.h"
#include "ui/sensor/SensorActions.h"

using namespace lubberline;
using namespace lubberline::ui;

class SensorRecordsTest : public QObject {
    Q_OBJECT

private slots:
    void misspeltFileChangesNothing();
    void modelFileThereAndBack();
    void readOnlyStorageLetsPlay();
    void firstFigureMakesAModel();
    void removedModelComesBack();
    void namesAreChecked();
    void refusedByStorage();
    void estimateFromTheNewestSwing();
    void estimateFromTwoPlaces();
    void benchIsAskedFor();
};

void SensorRecordsTest::misspeltFileChangesNothing()
{
    OpenPage page;
    page.add("survey", someIron());
    page.open();
    QTemporaryDir folder;
    page.answer = folder.filePath("misspelt.json");
    QFile file(page.answer);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(R"({"field": {"H_nT": 18500, "dip_deg": 67}, "hard_irn_nT": [1, 2, 3]})");
    file.close();
    const MeridianField before = page.page->view()->field;
    page.find<QPushButton>("sensorLoad").click();
    QCOMPARE(page.errors.size(), 1);
    QVERIFY2(page.errors.front().contains("hard_irn_nT") && page.errors.front().contains("hard_iron_nT"), qPrintable(page.errors.front()));
    QCOMPARE(page.stack.count(), 0);
    QCOMPARE(page.stores.whole().sensors.size(), std::size_t(1));
    QVERIFY(page.stored() == someIron());
    QVERIFY(page.page->view()->field == before);
}

void SensorRecordsTest::modelFileThereAndBack()
{
    OpenPage page;
    page.open();
    QTemporaryDir folder;
    page.answer = folder.filePath("probe.json");
    const SensorSetup setup{MeridianField::fromDip(17000, toRadians(70)), someIron(), "invented"};
    QFile file(page.answer);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(writeModelJson(setup)));
    file.close();
    page.find<QPushButton>("sensorLoad").click();
    QCOMPARE(page.errors, QStringList());
    QVERIFY(page.stored() == someIron());
    QCOMPARE(page.page->editor().record()->name, std::string("probe"));
    QVERIFY(page.page->editor().record()->origin == ModelOrigin::Loaded);
    QCOMPARE(page.page->view()->field.horizontal_nT, 17000.0);
    compareMap(*page.picture().map, someIron(), page.page->view()->field);
    page.find<QPushButton>("sensorLoad").click(); // again: under another name
    QCOMPARE(page.page->editor().record()->name, std::string("probe 2"));

    page.type("field_H", "17500");
    page.answer = folder.filePath("saved.json");
    page.find<QPushButton>("sensorSave").click();
    const auto back = readModelJsonFile(page.answer.toStdString());
    QVERIFY(back.ok());
    QVERIFY(back->model == someIron());
    QCOMPARE(std::get<MeridianField>(back->field).horizontal_nT, 17500.0);
    QVERIFY(std::abs(toDegrees(std::get<MeridianField>(back->field).inclination_rad()) - 70) < 1e-9);
    page.answer = folder.filePath("no such folder/saved.json");
    page.find<QPushButton>("sensorSave").click();
    QCOMPARE(page.errors.size(), 1);
}

void SensorRecordsTest::readOnlyStorageLetsPlay()
{
    OpenPage page;
    page.add("survey", someIron());
    page.stores.makeReadOnly();
    page.open();
    for (const char* name : {"sensorNew", "sensorDuplicate", "sensorRemove"})
        QVERIFY(!page.find<QToolButton>(name).isEnabled());
    for (const char* name : {"sensorLoad", "sensorEstimate", "circuitAdd"})
        QVERIFY(!page.find<QPushButton>(name).isEnabled());
    QVERIFY(page.find<QLineEdit>("sensorName").isReadOnly());
    page.type("hardIron_P", "3000");
    SensorModel played = someIron();
    played.hardIron_nT.x() = 3000;
    compareMap(*page.picture().map, played, page.page->view()->field);
    page.find<QCheckBox>("circuit0On").click();
    played.circuits[0].on = true;
    compareMap(*page.picture().map, played, page.page->view()->field);
    QVERIFY(page.stored() == someIron());
    QCOMPARE(page.stack.count(), 0);
    QCOMPARE(page.errors, QStringList());
}

void SensorRecordsTest::firstFigureMakesAModel()
{
    OpenPage page;
    page.open();
    QCOMPARE(page.find<QComboBox>("sensorChoice").count(), 0);
    compareMap(*page.picture().map, SensorModel(), page.page->view()->field);
    page.type("hardIron_R", "0"); // no change: nothing is made
    QCOMPARE(page.stack.count(), 0);
    page.type("hardIron_R", "100");
    QCOMPARE(page.stored().hardIron_nT.z(), 100.0);
    QCOMPARE(page.find<QComboBox>("sensorChoice").currentText(), QStringLiteral("model"));
    page.stack.undo();
    QVERIFY(page.stores.whole().sensors.empty());
    QCOMPARE(page.find<QDoubleSpinBox>("hardIron_R").value(), 0.0);
    page.find<QToolButton>("sensorNew").click();
    page.find<QToolButton>("sensorNew").click();
    QCOMPARE(page.find<QComboBox>("sensorChoice").currentText(), QStringLiteral("model 2"));
}

void SensorRecordsTest::removedModelComesBack()
{
    OpenPage page;
    page.add("survey", someIron());
    page.open();
    page.type("hardIron_P", "1");
    page.find<QToolButton>("sensorDuplicate").click();
    QCOMPARE(page.page->editor().record()->name, std::string("survey 2"));
    page.choose("sensorChoice", 1);
    QCOMPARE(page.page->editor().record()->name, std::string("survey"));
    page.find<QToolButton>("sensorRemove").click();
    QCOMPARE(page.stores.whole().sensors.size(), std::size_t(1));
    while (page.stack.canUndo())
        page.stack.undo(); // the first edit finds its record under another id
    QCOMPARE(page.errors, QStringList());
    QCOMPARE(page.stores.whole().sensors.size(), std::size_t(1));
    QVERIFY(page.stored() == someIron());
    while (page.stack.canRedo())
        page.stack.redo();
    QCOMPARE(page.errors, QStringList());
    QCOMPARE(page.stores.whole().sensors.size(), std::size_t(1));
    QCOMPARE(page.stores.whole().sensors.front().name, std::string("survey 2"));
    QCOMPARE(page.stored().hardIron_nT.x(), 1.0);
}

void SensorRecordsTest::namesAreChecked()
{
    OpenPage page;
    page.add("plain", SensorModel());
    page.add("survey", someIron());
    page.open();
    auto& name = page.find<QLineEdit>("sensorName");
    const auto rename = [&name](const QString& text) {
        name.setFocus();
        name.selectAll();
        QTest::keyClick(&name, Qt::Key_Delete);
        QTest::keyClicks(&name, text);
        QTest::keyClick(&name, Qt::Key_Return);
    };
    rename(QStringLiteral("plain"));
    QVERIFY(name.toolTip().contains(QStringLiteral("another model")));
    rename(QString());
    QVERIFY(name.toolTip().contains(QStringLiteral("must have a name")));
    QCOMPARE(page.stack.count(), 0);
    rename(QStringLiteral("survey 2026"));
    QCOMPARE(page.stores.whole().sensors.back().name, std::string("survey 2026"));
    QCOMPARE(page.find<QComboBox>("sensorChoice").currentText(), QStringLiteral("survey 2026"));
}

void SensorRecordsTest::refusedByStorage()
{
    OpenPage page;
    page.add("survey", someIron());
    page.open();
    page.stores.watch().refuseWrites = true;
    page.type("hardIron_P", "3000");
    QCOMPARE(page.errors.size(), 1);
    QCOMPARE(page.stack.count(), 0);
    QCOMPARE(page.find<QDoubleSpinBox>("hardIron_P").value(), 1200.0); // what is stored is shown
    page.find<QToolButton>("sensorNew").click();
    QCOMPARE(page.errors.size(), 2);
    QCOMPARE(page.page->editor().record()->name, std::string("survey"));
}

void SensorRecordsTest::estimateFromTheNewestSwing()
{
    OpenPage page;
    SensorModel iron;
    iron.hardIron_nT = {900, -600, 0};
    iron.softIron(0, 2) = 0.02;
    page.addSwing(page.addSite("Warsaw", 52.2, 21.0), "2026-11-20", iron);
    page.open();
    const MeridianField field = page.page->view()->field;
    const auto expected = smithOf(iron, field)->exact;
    for (const Origin origin : {Origin::HardIron, Origin::VerticalSoftIron}) {
        page.page->findChild<SensorActions*>()->estimateFromNewest(origin);
        QCOMPARE(page.errors, QStringList());
        const SensorRecord& made = *page.page->editor().record();
        QVERIFY(made.origin == ModelOrigin::EstimatedFromSwings);
        const auto smith = smithOf(made.model, field)->exact;
        QVERIFY(std::abs(smith.B - expected.B) < 1e-9 && std::abs(smith.C - expected.C) < 1e-9); // the swing is what it was
        QCOMPARE(made.model.hardIron_nT.norm() > 0, origin == Origin::HardIron);
    }
    QCOMPARE(page.stores.whole().sensors.size(), std::size_t(2));
    page.page->findChild<SensorActions*>()->estimateBySeparation();
    QCOMPARE(page.errors.size(), 1);
    QVERIFY2(page.errors.front().contains(QStringLiteral("two or more")), qPrintable(page.errors.front()));
}

void SensorRecordsTest::estimateFromTwoPlaces()
{
    OpenPage page;
    SensorModel iron;
    iron.hardIron_nT = {900, -600, 0};
    iron.softIron(0, 2) = 0.02;
    iron.softIron(1, 2) = -0.03;
    page.addSwing(page.addSite("Warsaw", 52.2, 21.0), "2026-03-01", SensorModel()); // older, not taken
    page.addSwing(page.stores.whole().sites.front().id, "2026-11-20", iron);
    page.addSwing(page.addSite("Nairobi", -1.3, 36.9), "2026-10-01", iron);
    page.open();
    page.page->findChild<SensorActions*>()->estimateBySeparation();
    QCOMPARE(page.errors, QStringList());
    const SensorModel& made = page.page->editor().model();
    QVERIFY((made.hardIron_nT - iron.hardIron_nT).norm() < 1e-3);
    QVERIFY((made.softIron - iron.softIron).norm() < 1e-6);
    QVERIFY(toText(page.page->editor().record()->note).contains(QStringLiteral("Nairobi")));
}

void SensorRecordsTest::benchIsAskedFor()
{
    OpenPage page;
    page.open();
    QSignalSpy asked(page.page.get(), &SensorPage::benchWanted);
    page.find<QPushButton>("sensorBench").click();
    QCOMPARE(asked.count(), 1);
    QVERIFY(asked.front().front().value<CompassId>() == page.compass);
}

QTEST_MAIN(SensorRecordsTest)
#include "SensorRecordsTest.moc"
