// The maps of the sensor page are those of core: of one model and of two, along each axis, as a surface, on a level swing and in a file.

#include <QCheckBox>
#include <QPushButton>
#include <QTemporaryDir>

#include "core/swing/IronSeparation.h"
#include "tests/ui/sensor/SensorPageFixture.h"
#include "ui/plots/map/SurfacePlot.h"
#include "ui/sensor/SensorMaps.h"

using namespace lubberline;
using namespace lubberline::ui;

class SensorMapsTest : public QObject {
    Q_OBJECT

private slots:
    void anEmptyModelHasNoExtremes();
    void circuitSwitch();
    void differenceMap();
    void axesAndHeldAngle();
    void surfaceAndLevelSwing();
    void exportOfTheMap();
};

void SensorMapsTest::anEmptyModelHasNoExtremes()
{
    OpenPage page;
    page.add("empty", SensorModel());
    page.open();
    QVERIFY(page.picture().map);
    QVERIFY(page.picture().extremes.empty());
}

void SensorMapsTest::circuitSwitch()
{
    OpenPage page;
    page.add("survey", someIron());
    page.open();
    SensorModel on = someIron();
    on.circuits[0].on = true;
    const MeridianField field = page.page->view()->field;
    page.choose("mapOther", 1); // the same, switched
    QVERIFY(page.picture().difference);
    DeviationMap off, lit;
    computeMapPlainly(responseOf(someIron()), field, page.picture().map->request, off);
    computeMapPlainly(responseOf(on), field, page.picture().map->request, lit);
    const DeviationMap expected = differenceOf(lit, off); // this (off) less the other (on)
    for (std::size_t i = 0; i < expected.deviation_rad.size(); i += 97)
        QVERIFY(std::abs(std::remainder(page.picture().map->deviation_rad[i] - expected.deviation_rad[i], 2 * kPi)) < 1e-12);

    page.choose("mapOther", 0);
    page.find<QCheckBox>("circuit0On").click();
    QVERIFY(page.stored() == on);
    QCOMPARE(page.stack.undoText(), QStringLiteral("landing light switched on of survey"));
    compareMap(*page.picture().map, on, field);
    QVERIFY(page.cell(Coefficient::B, 3).contains(QStringLiteral("landing light\u00A0+")));
    page.stack.undo();
    QVERIFY(!page.find<QCheckBox>("circuit0On").isChecked());
}

void SensorMapsTest::differenceMap()
{
    OpenPage page;
    SensorModel plain;
    plain.hardIron_nT = {500, 0, 0};
    page.add("plain", plain);
    page.add("survey", someIron());
    page.open(); // the newest: survey
    const MeridianField field = page.page->view()->field;
    QCOMPARE(page.find<QComboBox>("sensorChoice").currentText(), QStringLiteral("survey"));
    page.choose("mapOther", 1);
    QCOMPARE(page.find<QComboBox>("mapOther").currentText(), QStringLiteral("plain"));
    QVERIFY(page.picture().difference);
    QVERIFY(!page.picture().limit_deg);
    QCOMPARE(page.picture().title, QStringLiteral("survey − plain"));
    const double scale_deg = page.picture().scale_deg;
    QVERIFY(scale_deg > 0);
    DeviationMap survey, other;
    computeMapPlainly(responseOf(someIron()), field, page.picture().map->request, survey);
    computeMapPlainly(responseOf(plain), field, page.picture().map->request, other);
    const std::size_t at = page.picture().map->index(90, 100);
    QVERIFY(std::abs(page.picture().map->deviation_rad[at] - (survey.deviation_rad[at] - other.deviation_rad[at])) < 1e-12);
    page.choose("mapCompared", 2);
    compareMap(*page.picture().map, plain, field);
    QCOMPARE(page.picture().scale_deg, scale_deg);
    QCOMPARE(page.picture().title, QStringLiteral("plain"));
    page.choose("mapCompared", 1);
    compareMap(*page.picture().map, someIron(), field);
    QCOMPARE(page.picture().scale_deg, scale_deg);
    page.choose("sensorChoice", 1); // the other one: it is not compared with itself
    QVERIFY(!page.picture().difference);
    QCOMPARE(page.find<QComboBox>("mapOther").currentIndex(), 0);
}

void SensorMapsTest::axesAndHeldAngle()
{
    OpenPage page;
    page.add("survey", someIron());
    page.open();
    const MeridianField field = page.page->view()->field;
    page.type("mapHeld", "-25");
    QCOMPARE(page.picture().map->request.held_deg, -25.0);
    compareMap(*page.picture().map, someIron(), field);
    page.choose("mapAxes", 1);
    QVERIFY(page.picture().map->request.y.axis == AttitudeAxis::Roll);
    QCOMPARE(page.picture().map->request.held_deg, 0.0);
    QCOMPARE(page.find<QDoubleSpinBox>("mapHeld").maximum(), 90.0);
    page.choose("mapAxes", 2);
    page.type("mapHeld", "270");
    QVERIFY(page.picture().map->request.x.axis == AttitudeAxis::Pitch);
    QCOMPARE(page.picture().map->request.held_deg, 270.0);
    compareMap(*page.picture().map, someIron(), field);
    QCOMPARE(page.stack.count(), 0); // views are not stored
}

void SensorMapsTest::surfaceAndLevelSwing()
{
    OpenPage page;
    page.add("survey", someIron());
    page.open();
    page.page->maps().setCurrentIndex(1);
    QVERIFY(page.page->findChild<SurfacePlot*>()->isVisible());
    page.type("hardIron_P", "2000");
    SensorModel expected = someIron();
    expected.hardIron_nT.x() = 2000;
    page.page->maps().setCurrentIndex(0); // the map catches up
    compareMap(*page.picture().map, expected, page.page->view()->field);
    const SwingPicture level = levelSwingOf(*page.page->view());
    QCOMPARE(level.readings.size(), std::size_t(36));
    const auto smith = smithOf(expected, page.page->view()->field);
    QVERIFY(std::abs(level.analysis->exact.smith().B - smith->exact.B) < 1e-9);
    QVERIFY(level.title.startsWith(QStringLiteral("MODELLED")));
    QVERIFY(level.readingsTitle.startsWith(QStringLiteral("MODELLED"))); // in the legend, where a swing has its readings
    for (const PlottedReading& reading : level.readings)
        QVERIFY(std::abs(reading.deviation.radians() - deviationAt(smith->exact, reading.magnetic).radians()) < 1e-9);
    page.page->maps().setCurrentIndex(2);
    QApplication::processEvents();
    QVERIFY(!page.page->maps().grab().isNull());
}

void SensorMapsTest::exportOfTheMap()
{
    OpenPage page;
    page.add("survey", someIron());
    page.open();
    QTemporaryDir folder;
    page.answer = folder.filePath("map.png");
    page.find<QPushButton>("mapExport").click();
    QVERIFY(!QImage(page.answer).isNull());
    page.answer = folder.filePath("map.doc");
    page.find<QPushButton>("mapExport").click();
    QCOMPARE(page.errors.size(), 1);
    page.answer.clear(); // cancelled
    page.find<QPushButton>("mapExport").click();
    QCOMPARE(page.errors.size(), 1);
}

QTEST_MAIN(SensorMapsTest)
#include "SensorMapsTest.moc"
