// From a log to a saved model by the page: what a person sees who opens one.

#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <random>

#include "tests/db/TestStores.h"
#include "ui/calibration/CalibrationPage.h"
#include "ui/calibration/CoverageSphere.h"
#include "ui/kit/Words.h"
#include "ui/plots/series/SeriesChart.h"
#include "ui/plots/series/SeriesPlot.h"
#include "ui/sensor/SensorEdits.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

struct OpenCalibration {
    QTemporaryDir folder;
    QSettings settings{folder.filePath("settings.ini"), QSettings::IniFormat};
    QString saveAs;
    test::TestStores stores;
    CalibrationPage page{stores, settings,
        {[](const QString&, const QString&) { return QString(); },
            [this](const QString&, const QString&, const QString&) { return saveAs; }}};

    /// Hard iron (3000, −2000, 1500) nT in a field of 48 000 nT, all attitudes. @param flat the sensor stays level, but for its noise
    QString log(const QByteArray& header, int samples, bool flat = false) const
    {
        std::mt19937 random(3);
        std::normal_distribution<double> normal;
        QByteArray text = header + '\n';
        for (int i = 0; i < samples; ++i) {
            double b[3] = {normal(random), normal(random), flat ? 0.0 : normal(random)};
            const double size = 48 / std::hypot(b[0], b[1], b[2]);
            // In braces, draws come in the order in which they are written.
            const double m[3] = {b[0] * size + 3 + 0.05 * normal(random), b[1] * size - 2 + 0.05 * normal(random),
                b[2] * size + 1.5 + 0.05 * normal(random)};
            text += QByteArray::number(0.1 * i);
            for (const double one : m)
                text += ',' + QByteArray::number(one, 'f', 4);
            text += '\n';
        }
        QFile file(folder.filePath("log.csv"));
        if (file.open(QIODevice::WriteOnly))
            file.write(text);
        return file.fileName();
    }
    void finish() const { QTRY_VERIFY_WITH_TIMEOUT(page.findChild<QPushButton*>("calibrationOpen")->isEnabled(), 20000); }
    [[nodiscard]] QString words() const { return page.findChild<QLabel*>("calibrationWords")->text(); }
};

} // namespace

class CalibrationPageTest : public QObject {
    Q_OBJECT

private slots:
    void aGoodLogGivesAModel()
    {
        OpenCalibration open;
        open.page.resize(1100, 700);
        open.page.openLog(open.log("time_s,bx_uT,by_uT,bz_uT", 600));
        open.finish();
        QVERIFY(open.page.run());
        QVERIFY2(open.words().contains("Good"), qPrintable(open.words()));
        QVERIFY((open.page.run()->model->hardIron_nT - Eigen::Vector3d(3000, -2000, 1500)).norm() < 30);
        auto plots = open.page.findChildren<SeriesPlot*>();
        QCOMPARE(plots.size(), 2);
        if (plots[0]->picture().series.size() == 2) // the log's three axes first
            std::swap(plots[0], plots[1]);
        QCOMPARE(plots[0]->picture().series.size(), std::size_t{3});
        QVERIFY(plots[0]->chart()->drawnPoints(0) >= 600);
        QCOMPARE(plots[1]->picture().series.size(), std::size_t{2});
        QCOMPARE(open.page.findChild<CoverageSphere*>()->dots(), std::size_t{600});

        open.saveAs = open.folder.filePath("model.json");
        open.page.findChild<QPushButton*>("calibrationSave")->click();
        QFile model(open.saveAs);
        QVERIFY(model.open(QIODevice::ReadOnly));
        QVERIFY(model.readAll().contains("hard_iron_nT"));
        open.saveAs = open.folder.filePath("model.h");
        open.page.findChild<QPushButton*>("calibrationSave")->click();
        QVERIFY(QFile::exists(open.saveAs));
    }

    /// How sure the calibration is goes with the model into the compass's models.
    void aStoredModelKeepsItsUncertainty()
    {
        OpenCalibration open;
        test::TestStores& stores = open.stores;
        AircraftType type;
        type.name = "Su-22";
        Aircraft aircraft;
        aircraft.type = *stores.save(type);
        aircraft.registration = "3713";
        CompassSystem remote;
        remote.name = "remote compass";
        remote.aircraft = *stores.save(aircraft);
        const CompassId compass = *stores.save(remote);
        EditContext context{stores, [](const Error& error) { QFAIL(qPrintable(messageOf(error))); }};
        QUndoStack undo;
        connect(&open.page, &CalibrationPage::storeModel, &open.page, [&](const SensorRecord& sensor) {
            undo.push(new MakeSensor(context, sensor, MakeSensor::Direction::Make, QStringLiteral("calibration")));
        });
        QVERIFY(open.page.open(compass));
        open.page.openLog(open.log("time_s,bx_uT,by_uT,bz_uT", 600));
        open.finish();
        const auto wanted = open.page.run()->uncertainty;
        QVERIFY(wanted);
        QVERIFY(wanted->covariance(9, 9) > 0);
        open.page.findChild<QPushButton*>("calibrationStore")->click();
        undo.undo();
        QVERIFY(stores.sensors.of(compass)->empty());
        undo.redo();
        const auto kept = stores.sensors.of(compass);
        QCOMPARE(kept->size(), std::size_t{1});
        QVERIFY(kept->front().uncertainty == wanted);
    }

    void aFlatLogSaysWhyAndWhatToDo()
    {
        OpenCalibration open;
        open.page.openLog(open.log("time_s,bx_uT,by_uT,bz_uT", 300, true));
        open.finish();
        QVERIFY2(open.words().contains("Not determined"), qPrintable(open.words()));
        QVERIFY2(open.words().contains("in a plane"), qPrintable(open.words()));
        QVERIFY(open.words().contains("turn the sensor through all attitudes"));
        QVERIFY(!open.page.findChild<QPushButton*>("calibrationSave")->isEnabled());
    }

    /// A header that nobody knows: the columns are chosen, and known the next time.
    void columnsAreChosenAndRemembered()
    {
        OpenCalibration open;
        QSignalSpy failed(&open.page, &Page::failed);
        const QString path = open.log("t0,first,second,third", 400);
        open.page.openLog(path);
        open.finish();
        QVERIFY(!open.page.run());
        QCOMPARE(failed.size(), 1);
        const auto choose = [&](const char* key, const QString& name) {
            auto* box = open.page.findChild<QComboBox*>(QStringLiteral("calibrationColumn_") + key);
            box->setCurrentText(name);
            emit box->activated(box->currentIndex());
            open.finish();
        };
        choose("bx", "first");
        choose("by", "second");
        choose("bz", "third");
        QVERIFY(open.page.run());
        open.page.openLog(path);
        open.finish();
        QCOMPARE(open.page.findChild<QComboBox*>("calibrationColumn_by")->currentText(), QString("second"));
        QVERIFY(open.page.run());
    }

    void againstAttitudeTheFieldIsAskedFor()
    {
        OpenCalibration open;
        open.page.openLog(open.log("time_s,bx_uT,by_uT,bz_uT", 300));
        open.finish();
        QSignalSpy failed(&open.page, &Page::failed);
        auto* method = open.page.findChild<QComboBox*>("calibrationMethod");
        method->setCurrentIndex(3);
        emit method->activated(3);
        open.finish();
        QCOMPARE(failed.size(), 1);
        QVERIFY(failed[0][0].toString().contains("dip"));
        open.page.findChild<QLineEdit*>("calibrationField")->setText("much");
        QTest::keyClick(open.page.findChild<QLineEdit*>("calibrationField"), Qt::Key_Return);
        QCOMPARE(failed.size(), 2);
        QVERIFY(failed[1][0].toString().contains("'much' is not allowed"));
    }

    /// A hundred thousand samples are drawn as the extremes of a thousand steps; a zoom draws what is inside.
    void longLogsAreThinned()
    {
        SeriesPlot plot("Log");
        plot.resize(600, 400);
        std::vector<double> values(100000, 1.0);
        values[54321] = 9.0;
        plot.setPicture({"x", "y", {}, {}, {{"one", nullptr, std::make_shared<const std::vector<double>>(values), false}}, {}});
        QVERIFY(plot.chart()->drawnPoints(0) <= 2400);
        QVERIFY(plot.chart()->drawnPoints(0) >= 1200);
        QVERIFY(!plot.seen().part);
        QVERIFY(!plot.grab().toImage().isNull());
    }

    void theSphereIsTurnedByKeys()
    {
        CoverageSphere sphere;
        sphere.setDots({{{1, 0, 0}, 0}, {{0, 0, 1}, 3}}, {0, 0, -1}, 40);
        const Eigen::Matrix3d before = sphere.turn();
        QVERIFY((before * before.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-12);
        QTest::keyClick(&sphere, Qt::Key_Right);
        QVERIFY((sphere.turn() - before).norm() > 0.1);
        QVERIFY(!sphere.grab().toImage().isNull());
    }
};

QTEST_MAIN(CalibrationPageTest)
#include "CalibrationPageTest.moc"
