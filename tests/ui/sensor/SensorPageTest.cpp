// The sensor page: figures that are typed, dragged and switched are stored, and coefficients are those of core.

#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QToolButton>

#include "core/earth/FieldModel.h"
#include "core/swing/IronSeparation.h"
#include "tests/ui/sensor/SensorPageFixture.h"
#include "ui/sensor/ParameterCell.h"

using namespace lubberline;
using namespace lubberline::ui;

class SensorPageTest : public QObject {
    Q_OBJECT

private slots:
    void typedFigureIsStoredAndShown();
    void figuresBeyondTheSlider();
    void dragIsOneUndoStep();
    void keysOfASliderAreStoredWhenLetGo();
    void slidersGoFineAndCoarseAndReset();
    void circuitsComeAndGo();
    void polarForm();
    void reasonsInWords();
    void fieldOfASite();
    void hiddenPageCatchesUp();
};

void SensorPageTest::typedFigureIsStoredAndShown()
{
    OpenPage page;
    page.add("survey", someIron());
    page.open();
    page.type("hardIron_P", "2500.5");
    SensorModel expected = someIron();
    expected.hardIron_nT.x() = 2500.5;
    QVERIFY(page.stored() == expected);
    QCOMPARE(page.stack.count(), 1);
    QCOMPARE(page.stack.undoText(), QStringLiteral("hard iron P, forward of survey"));
    const MeridianField field = page.page->view()->field;
    QVERIFY(!page.picture().measured);
    QVERIFY(!page.picture().coarse);
    QCOMPARE(page.picture().limit_deg.value(), 10.0);
    compareMap(*page.picture().map, expected, field);
    const auto smith = smithOf(expected, field);
    QCOMPARE(page.cell(Coefficient::B, 1), signedNumber(smith->exact.B, 5));
    QCOMPARE(page.cell(Coefficient::B, 2), signedNumber(toDegrees(smith->approximate->B_rad), 2) + QStringLiteral("°"));
    QVERIFY(page.cell(Coefficient::B, 3).startsWith(QStringLiteral("P\u00A0+")));
    QVERIFY(page.find<QLabel>("lambdaWords").text().contains(QString::number(smith->lambda, 'f', 4)));
    SwingAtPlace swing;
    swing.exact = smith->exact;
    swing.field = field;
    QCOMPARE(page.find<QListWidget>("swingKnowledge").count(), static_cast<int>(whatSwingsTell(swing, std::nullopt).size()));

    page.stack.undo();
    QVERIFY(page.stored() == someIron());
    QCOMPARE(page.find<QDoubleSpinBox>("hardIron_P").value(), 1200.0);
    compareMap(*page.picture().map, someIron(), field);
    page.stack.redo();
    QCOMPARE(page.find<QDoubleSpinBox>("hardIron_P").value(), 2500.5);
}

void SensorPageTest::figuresBeyondTheSlider()
{
    OpenPage page;
    page.add("survey", someIron());
    page.open();
    page.type("hardIron_Q", "-123456,5"); // a comma is a point
    QCOMPARE(page.stored().hardIron_nT.y(), -123456.5);
    QCOMPARE(page.find<QSlider>("hardIron_QSlider").value(), page.find<QSlider>("hardIron_QSlider").minimum());
    page.type("softIron_c", "0.12345");
    QCOMPARE(page.stored().softIron(0, 2), 0.12345);
    page.type("mount_yaw", "90");
    QCOMPARE(page.stored().misalignment.yaw_rad, kPi / 2);
    page.type("softConstant_3", "7");
    QCOMPARE(page.stored().softConstant_nT.z(), 7.0);
    QCOMPARE(page.stack.count(), 4);
    QCOMPARE(page.stored().softIron(0, 0), someIron().softIron(0, 0)); // what was not touched keeps its digits
}

void SensorPageTest::dragIsOneUndoStep()
{
    OpenPage page;
    page.add("survey", someIron());
    page.open();
    auto& slider = page.find<QSlider>("hardIron_QSlider");
    slider.setSliderDown(true);
    for (const int position : {100, 200, 300, 400}) {
        slider.setSliderPosition(position);
        QTRY_VERIFY(page.picture().coarse);
        QVERIFY(page.stored() == someIron());
    }
    const double played_nT = page.find<QDoubleSpinBox>("hardIron_Q").value();
    QVERIFY(played_nT > 0);
    SensorModel expected = someIron();
    expected.hardIron_nT.y() = played_nT;
    QTRY_VERIFY(page.page->view()->model.model == expected);
    compareMap(*page.picture().map, expected, page.page->view()->field);
    QCOMPARE(page.cell(Coefficient::C, 1), signedNumber(smithOf(expected, page.page->view()->field)->exact.C, 5));
    QCOMPARE(page.stack.count(), 0);
    QTest::mouseRelease(&slider, Qt::LeftButton);
    QCOMPARE(page.stack.count(), 1);
    QVERIFY(page.stored() == expected);
    QVERIFY(!page.picture().coarse);
    page.stack.undo();
    QVERIFY(page.stored() == someIron());
    QCOMPARE(page.find<QDoubleSpinBox>("hardIron_Q").value(), -800.0);
}

void SensorPageTest::keysOfASliderAreStoredWhenLetGo()
{
    OpenPage page;
    page.add("survey", someIron());
    page.open();
    auto& slider = page.find<QSlider>("softIron_aSlider");
    slider.setFocus();
    QTest::keyPress(&slider, Qt::Key_Right);
    QTest::keyPress(&slider, Qt::Key_Right);
    QCOMPARE(page.stack.count(), 0);
    QTest::keyRelease(&slider, Qt::Key_Right);
    QCOMPARE(page.stack.count(), 1);
    QVERIFY(page.stored().softIron(0, 0) > someIron().softIron(0, 0));
    QTest::keyClick(&slider, Qt::Key_Tab);
    QCOMPARE(page.stack.count(), 1); // left without a change
}

void SensorPageTest::slidersGoFineAndCoarseAndReset()
{
    OpenPage page;
    page.add("survey", someIron());
    page.open();
    auto& slider = page.find<QSlider>("hardIron_QSlider");
    slider.setFocus();
    QTest::keyClick(&slider, Qt::Key_Right);
    QCOMPARE(page.stored().hardIron_nT.y(), -790.0); // 10 nT
    QTest::keyClick(&slider, Qt::Key_PageUp);
    QCOMPARE(page.stored().hardIron_nT.y(), -290.0); // 500 nT
    const int steps = page.stack.count();
    QTest::mouseDClick(&slider, Qt::LeftButton, {}, {3, 3});
    QCOMPARE(page.stored().hardIron_nT.y(), 0.0);
    QCOMPARE(page.stack.count(), steps + 1);
    slider.setSliderPosition(slider.maximum() / 42); // a pixel of a short slider, beside zero
    QVERIFY2(std::abs(page.find<QDoubleSpinBox>("hardIron_Q").value()) < 25, qPrintable(page.find<QDoubleSpinBox>("hardIron_Q").text()));
}

void SensorPageTest::circuitsComeAndGo()
{
    OpenPage page;
    page.add("survey", someIron());
    page.open();
    page.find<QPushButton>("circuitAdd").click();
    QCOMPARE(page.stored().circuits.size(), std::size_t(2));
    page.type("circuit1Current", "5");
    page.type("circuit1S", "12.5");
    auto& name = page.find<QLineEdit>("circuit1Name");
    name.setText(QString());
    QTest::keyClick(&name, Qt::Key_Return);
    QVERIFY(!name.toolTip().isEmpty()); // a circuit has a name
    QCOMPARE(page.stored().circuits[1].name, std::string("circuit 2"));
    name.setText(QStringLiteral("pitot heat"));
    QTest::keyClick(&name, Qt::Key_Return);
    QCOMPARE(page.stored().circuits[1].name, std::string("pitot heat"));
    QCOMPARE(page.stored().circuits[1].field_nT_per_A.x(), 12.5);
    QCOMPARE(page.stored().circuits[1].current_A, 5.0);
    page.find<QToolButton>("circuit0Remove").click();
    QCOMPARE(page.stored().circuits.size(), std::size_t(1));
    QCOMPARE(page.find<QLineEdit>("circuit0Name").text(), QStringLiteral("pitot heat"));
    QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QVERIFY(!page.page->findChild<QLineEdit*>("circuit1Name"));
    page.stack.undo();
    QCOMPARE(page.stored().circuits.size(), std::size_t(2));
    QCOMPARE(page.find<QLineEdit>("circuit1Name").text(), QStringLiteral("pitot heat"));
    while (page.stack.canUndo())
        page.stack.undo();
    QVERIFY(page.stored() == someIron());
}

void SensorPageTest::polarForm()
{
    OpenPage page;
    SensorModel model;
    model.hardIron_nT = {1000, -1000, -1414.213562373095}; // up and to port: γ = +45°, δ = −45°
    page.add("survey", model);
    page.open();
    page.find<QCheckBox>("hardIronPolar").click();
    QCOMPARE(page.find<QDoubleSpinBox>("polar_size").value(), 2000.0);
    QCOMPARE(page.find<QDoubleSpinBox>("polar_elevation").value(), 45.0);
    QCOMPARE(page.find<QDoubleSpinBox>("polar_azimuth").value(), -45.0);
    QCOMPARE(page.stack.count(), 0);
    page.type("polar_azimuth", "135");
    QVERIFY((page.stored().hardIron_nT - Eigen::Vector3d(-1000, 1000, -1414.213562373095)).norm() < 1e-9);
    page.type("polar_size", "0");
    QVERIFY(page.stored().hardIron_nT.norm() == 0.0);
    page.type("polar_size", "2000"); // the direction was kept
    QVERIFY((page.stored().hardIron_nT - Eigen::Vector3d(-1000, 1000, -1414.213562373095)).norm() < 1e-9);
    page.find<QCheckBox>("hardIronPolar").click();
    QCOMPARE(page.find<QDoubleSpinBox>("hardIron_Q").value(), 1000.0);
    QCOMPARE(page.stack.count(), 3);
}

void SensorPageTest::reasonsInWords()
{
    OpenPage page;
    page.add("survey", someIron());
    page.open();
    auto& words = page.find<QLabel>("lambdaWords");
    page.type("hardIron_P", "900000"); // 𝔅 beyond any sine
    QVERIFY2(words.text().contains(QStringLiteral("No approximate coefficient B")), qPrintable(words.text()));
    QCOMPARE(page.cell(Coefficient::B, 2), QStringLiteral("—"));
    page.type("softIron_a", "-3");
    QVERIFY2(
        words.text().contains(QStringLiteral("λ")) && words.text().startsWith(QStringLiteral("No coefficients")), qPrintable(words.text()));
    QVERIFY(page.find<QTableWidget>("smithTerms").isHidden());
    QCOMPARE(page.find<QListWidget>("swingKnowledge").count(), 0);
    page.stack.undo();
    page.type("field_H", "0");
    QVERIFY2(words.text().contains(QStringLiteral("H is 0")), qPrintable(words.text()));
    QVERIFY(page.picture().map); // tilted, there is a map yet
    page.type("field_Z", "0");
    QVERIFY(page.page->view()->field == MeridianField());
    page.type("field_H", "20000.5"); // key by key: what is typed is not written over
    QCOMPARE(page.page->view()->field.horizontal_nT, 20000.5);
    QVERIFY(page.find<QTableWidget>("smithTerms").isVisible());
}

void SensorPageTest::fieldOfASite()
{
    OpenPage page;
    page.add("survey", someIron());
    const SiteId site = page.addSite("Warsaw", 52.2, 21.0);
    Site unknown;
    unknown.name = "no coordinates";
    static_cast<void>(*page.stores.save(unknown));
    page.addSwing(site, "2026-11-20", someIron());
    page.open();
    QCOMPARE(page.find<QComboBox>("fieldSite").count(), 2);
    QCOMPARE(page.find<QComboBox>("fieldSite").currentText(), QStringLiteral("Warsaw"));
    const auto stamp = stampField(*makePlace(52.2, 21.0), "2026-11-20");
    QVERIFY(page.page->view()->field == stamp->field.meridian());
    QVERIFY(page.find<QLabel>("fieldWords").text().startsWith(QStringLiteral("WMM2025")));
    auto& date = page.find<QLineEdit>("fieldDate");
    const auto setDate = [&date](const QString& text) {
        date.setFocus();
        date.selectAll();
        QTest::keyClicks(&date, text);
        QTest::keyClick(&date, Qt::Key_Return);
    };
    setDate(QStringLiteral("2005-06-01"));
    QVERIFY(page.page->view()->field == stampField(*makePlace(52.2, 21.0), "2005-06-01")->field.meridian());
    setDate(QStringLiteral("1850-06-01"));
    QVERIFY(!page.page->view());
    QVERIFY(page.find<QLabel>("fieldWords").text().startsWith(QStringLiteral("No field")));
    QVERIFY(!page.picture().map);
    page.type("field_dip", "60"); // typed takes over
    QCOMPARE(page.find<QComboBox>("fieldSite").currentIndex(), 0);
    QVERIFY(std::abs(toDegrees(page.page->view()->field.inclination_rad()) - 60) < 1e-9);
    QCOMPARE(page.stack.count(), 0);
}

void SensorPageTest::hiddenPageCatchesUp()
{
    OpenPage page;
    SensorRecord survey = page.add("survey", someIron());
    page.open();
    page.page->hide();
    survey.model.hardIron_nT.x() = -500;
    QVERIFY(page.stores.save(survey).ok());
    QVERIFY(page.page->view()->model.model == someIron()); // nothing is computed unseen
    page.page->show();
    QVERIFY(page.page->view()->model.model == survey.model);
    compareMap(*page.picture().map, survey.model, page.page->view()->field);
    QCOMPARE(page.find<QDoubleSpinBox>("hardIron_P").value(), -500.0);
}

QTEST_MAIN(SensorPageTest)
#include "SensorPageTest.moc"
